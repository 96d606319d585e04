//! The vocabulary that every other crate of meshmend speaks.
//!
//! Five ideas carry the library, and each has its home here:
//!
//! 1. **The mesh is an immutable value; connectivity is an index over it.** [`FaceTable`] holds any polygon
//!    soup, [`PolygonMesh`] adds positions, loose elements and attributes, and a *kernel* is a disposable index
//!    over the mesh's [`Complex`].
//! 2. **A corner is a half-edge.** Corner `c` stands at one vertex and owns the *side* that runs to the next
//!    corner's vertex. Faces, edges and vertices are three ways of grouping corners: their *stars*
//!    ([`Connectivity`]).
//! 3. **Refusal is computed from capabilities.** A kernel declares what it holds ([`Capabilities`]); shared code
//!    lists every [`Defect`] outside that ([`admission`]); only then is the kernel assembled, and that can't fail.
//! 4. **One vocabulary of defects.** Why a kernel refuses, what a check finds and what a pass mends are all
//!    [`Defect`]s: a kind, the [`Element`] where it is, and a count. All that is said of a kind is its [`Rule`].
//! 5. **Provenance is the record of change.** A pass says for each new face and corner which old one it came
//!    from ([`Provenance`]); everything else is derived, and attributes ride on it ([`Draft`]).
//!
//! The features `rayon` (large meshes on several threads) and `serde` (records and defects as JSON) are on by default.

mod attributes;
mod changes;
mod classes;
mod column;
mod defects;
mod edges;
#[cfg(test)]
mod error_cases;
mod faces;
mod ids;
mod kernel;
mod lists;
mod polygon_mesh;
mod printable;
#[cfg(feature = "serde")]
mod serialized;
mod threads;
mod watch;
mod words;

pub use attributes::{
    Aspect, Carry, Differences, Domain, FlippedNormals, Layer, LayerParts, NO_VALUE, Role, Values,
    turned_normals,
};
pub use changes::{Blend, Draft, DraftError, FilledHole, Loose, Provenance, Sources, VertexDraft};
pub use classes::{Classes, Joined, SidedClasses};
pub use column::Column;
pub use defects::{
    Defect, DefectKind, Defects, Detail, Element, Found, Lie, Listed, Rule, RuleError, Rules, Severity,
    Strip, Unjudged,
};
pub use edges::{EdgeSide, EdgeTable};
pub use faces::{
    Complex, FaceIndex, FaceTable, FaceTableBuilder, FaceTableError, MAX_CORNERS, canonical_rotation,
    distinct_count, normalised,
};
pub use ids::{CornerId, EdgeId, FaceId, Id, VertexId};
pub use kernel::{
    Adjacency, Array, Build, Capabilities, Cell, CellError, Connectivity, Cost, Costs, EdgeClass, EdgeUse,
    Grouped, Incidence, KernelTask, Lesson, ManifoldConnectivity, Per, Pointer, Refusal, Target, Umbrellas,
    VertexClass, admission, edge_class, irregular_vertices, is_inconsistent, is_manifold, umbrellas,
    vertex_classes, vertex_classes_in,
};
pub use lists::Lists;
pub use polygon_mesh::{Counts, MeshArrays, MeshError, Metadata, PolygonMesh, SharedPlaces};
pub use printable::printable;
pub use watch::{Cancelled, ITEMS_BETWEEN_LOOKS, Progress, Watch};
pub use words::counted;
