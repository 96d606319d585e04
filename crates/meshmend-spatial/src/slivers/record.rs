//! What was done to slivers, and why others are left.

use std::fmt;

use meshmend_core::{CornerId, FaceId, VertexId};
use serde::Serialize;

use crate::SliverKind;

/// What mending slivers gives. All ids are those of the mesh that it was given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MendedSlivers {
    /// The slivers of the mesh, ascending by face.
    pub found: Vec<FoundSliver>,
    /// The steps, in order.
    pub steps: Vec<SliverStep>,
    /// The slivers that there are after all steps, ascending by face.
    pub left: Vec<LeftSliver>,
    /// How far a vertex is at most from one, as stored, that went into it.
    pub farthest: f64,
    /// The faces as they are after all steps; absent if there was none.
    pub reshaped: Option<Reshaped>,
}

/// The faces of a mesh after slivers were mended.
#[derive(Clone, Debug, PartialEq)]
pub struct Reshaped {
    /// The vertex of each corner.
    pub vertices: Vec<VertexId>,
    /// The corner of the mesh whose attributes each corner has: itself if it never went to another vertex.
    pub origins: Vec<CornerId>,
    /// For each face whether it is gone.
    pub is_gone: Vec<bool>,
}

/// A triangle that is far longer than it is high.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundSliver {
    /// Which.
    pub face: FaceId,
    /// What it looks like.
    pub kind: SliverKind,
    /// Its longest edge by its height over it, in doubles; absent if it has no area.
    pub aspect: Option<f64>,
}

/// A step that mended a sliver, or made it less of one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliverStep {
    /// The sliver that it was made for, as it was before.
    pub sliver: FoundSliver,
    /// What was done.
    pub mend: SliverMend,
}

/// What is done to a sliver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "step", rename_all = "kebab-case")]
pub enum SliverMend {
    /// One end of its shortest edge went into the other; the faces at that edge went.
    Collapse {
        /// The vertex that is gone.
        from: VertexId,
        /// The one that it went into.
        into: VertexId,
    },
    /// Its longest edge went, and another one came between the corners opposite to it in its two faces.
    Flip {
        /// The ends of the edge that went.
        edge: [VertexId; 2],
        /// The ends of the edge that came.
        to: [VertexId; 2],
        /// The other face of the edge.
        with: FaceId,
    },
    /// It went: its longest edge was boundary, and now the other two are.
    Drop,
}

impl fmt::Display for SliverMend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SliverMend::Collapse { from, into } => write!(f, "{from} went into {into}"),
            SliverMend::Flip { edge: [a, b], to: [c, d], with } => {
                write!(f, "the edge {a}-{b} to {with} was flipped to {c}-{d}")
            }
            SliverMend::Drop => f.write_str("it went"),
        }
    }
}

/// A sliver that is left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftSliver {
    /// Which, as it is.
    pub sliver: FoundSliver,
    /// Why.
    pub reason: SliverReason,
}

/// Why a sliver is left. Of several reasons it is the first; the distance is asked last, and so is the only one where it is
/// named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SliverReason {
    /// A face that would change has a number of corners other than three.
    NonTriangle,
    /// A corner of a face that would change is not finite.
    NotFinite,
    /// One of its edges has three sides or more, or the faces there run the same way.
    Sides,
    /// The faces round it would be joined in another way.
    Link,
    /// The boundary would be pinched, or cut off.
    Boundary,
    /// It lies on a seam of attributes.
    Seam,
    /// A face would turn over.
    TurnsOver,
    /// Another face would be a sliver that is no better.
    NoBetter,
    /// The surface would move farther than it may.
    Move,
    /// There were a hundred steps for each sliver already.
    StepLimit,
}

impl SliverReason {
    /// The reason in words, as it follows “left: ”.
    pub fn reason(self) -> &'static str {
        match self {
            SliverReason::NonTriangle => "a face that would change is not a triangle",
            SliverReason::NotFinite => "a corner of a face that would change is not finite",
            SliverReason::Sides => "an edge has three sides or more, or the faces there run the same way",
            SliverReason::Link => "the faces round it would be joined in another way",
            SliverReason::Boundary => "the boundary would be pinched or cut off",
            SliverReason::Seam => "it lies on a seam of attributes",
            SliverReason::TurnsOver => "a face would turn over",
            SliverReason::NoBetter => "another face would be a sliver that is no better",
            SliverReason::Move => "the surface would move farther than it may",
            SliverReason::StepLimit => "there were a hundred steps for each sliver already",
        }
    }

    /// Whether a second run, which knows nothing of the first mesh and counts its steps anew, may do what was left.
    pub fn is_limit(self) -> bool {
        matches!(self, SliverReason::Move | SliverReason::StepLimit)
    }
}
