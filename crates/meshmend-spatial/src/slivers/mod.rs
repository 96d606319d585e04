//! How are triangles that are too thin mended, and which are left?
//!
//! A needle has its shortest edge collapsed, a cap its longest one flipped, or it is dropped where that edge is boundary. Each
//! step keeps how the faces hang together, turns no face over and makes no face a worse sliver, and moves nothing farther
//! than allowed from where it was stored. It lowers the number of vertices or of faces, or else the sorted list of aspects,
//! so that steps end. Every yes or no is that of real arithmetic.
//!
//! A sliver that is left is judged again when a face at one of its corners has changed. So what is left in the end would be
//! left a second time, but for what is left because of the distance, or of too many steps.

mod collapse;
mod flip;
mod ground;
mod measure;
mod mending;
mod queue;
mod record;
mod stood_for;
mod surface;

use meshmend_core::{PolygonMesh, VertexId};
use meshmend_geometry::vector::Point;

pub use ground::{Attributes, NoAttributes};
pub use measure::agreement;
pub use record::{FoundSliver, LeftSliver, MendedSlivers, Reshaped, SliverMend, SliverReason, SliverStep};

/// A mesh whose slivers are to be mended.
#[derive(Clone, Copy)]
pub struct SliverTask<'a> {
    /// The mesh.
    pub mesh: &'a PolygonMesh,
    /// A triangle at least so many times as long as it is high is a sliver. A finite number.
    pub aspect: f64,
    /// How far a point may move. A finite number of 0 or more.
    pub reach: f64,
    /// Points that vertices stand for beside their own: those of the vertices as stored that are them now. Ascending by vertex.
    pub stood_for: &'a [(VertexId, Point)],
    /// Which corners and faces have the same attributes.
    pub attributes: &'a dyn Attributes,
}

/// Mends the slivers of a mesh, step by step; `None` if `goes_on` says no.
///
/// *Cost*: linear to find them, on all threads, and if there are any linear to index the mesh; then for each step that of the
/// faces round the sliver, and O(log n). Some microseconds where doubles can't tell.
pub fn mend_slivers(task: &SliverTask<'_>, goes_on: &dyn Fn() -> bool) -> Option<MendedSlivers> {
    mending::mend(task, goes_on)
}

#[cfg(test)]
mod tests;
