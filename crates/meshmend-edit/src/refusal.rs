//! Why an operator refuses.

use std::fmt;

use meshmend_core::counted;
use thiserror::Error;

use crate::{EdgeKey, FaceKey, HalfKey, Key, StaleKey, VertexKey};

/// One reason why an operator refuses. Each has a [`code`](EditRefusal::code) that does not change.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum EditRefusal {
    /// The element of a key is gone.
    #[error("{0} is gone")]
    Stale(Key),
    /// There would be more elements than a mesh can number.
    #[error("there would be more elements than a mesh can number")]
    Full,
    /// The new vertex would not lie between the ends of the edge.
    #[error("the fraction is not between 0 and 1")]
    NotBetween,
    /// A vertex has the wrong number of edges.
    #[error("{vertex} has {}, and {needed} are needed", counted(found, "edge"))]
    Degree {
        /// The vertex.
        vertex: VertexKey,
        /// How many edges it has.
        found: usize,
        /// How many it needs, in words.
        needed: &'static str,
    },
    /// A face of three sides would lose one.
    #[error("{0} has 3 sides, and would lose one")]
    Triangle(FaceKey),
    /// A face is not a triangle.
    #[error("{0} is not a triangle")]
    NotATriangle(FaceKey),
    /// An edge joins the two vertices, which would be joined a second time.
    #[error("{} and {} would be joined twice", .0[0], .0[1])]
    AlreadyJoined([VertexKey; 2]),
    /// The two half-edges are not of one face.
    #[error("{} and {} are not of one face", .0[0], .0[1])]
    TwoFaces([HalfKey; 2]),
    /// The two corners are neighbours, or the same.
    #[error("the corners of {} and {} are neighbours or the same", .0[0], .0[1])]
    Adjacent([HalfKey; 2]),
    /// The element is on the boundary.
    #[error("{0} is on the boundary")]
    Boundary(Key),
    /// Two faces share a vertex besides the edge between them.
    #[error("{} and {} share {vertex} as well", .faces[0], .faces[1])]
    SharesMore {
        /// The two faces.
        faces: [FaceKey; 2],
        /// What they share besides.
        vertex: VertexKey,
    },
    /// The surface would not stay what it is: the link condition fails.
    #[error("the link condition fails at {}", elements(.vertices, .edges, .faces))]
    LinkCondition {
        /// The vertices joined to both ends that are not the tip of one triangle at the edge.
        vertices: Vec<VertexKey>,
        /// The edges that lie opposite to both ends in triangles.
        edges: Vec<EdgeKey>,
        /// The faces that have both ends and not the edge.
        faces: Vec<FaceKey>,
    },
    /// An edge inside joins two vertices of the boundary.
    #[error("{0} is inside and joins two vertices of the boundary")]
    Bridge(EdgeKey),
    /// A hole of three sides would close.
    #[error("the hole at {0} has 3 sides, and would close")]
    WouldClose(HalfKey),
    /// A vertex would be on two holes.
    #[error("{0} is on a hole, and would be on two")]
    WouldPinch(VertexKey),
    /// The half-edge is not along a hole.
    #[error("{0} is not along a hole")]
    NotAHole(HalfKey),
    /// The two half-edges do not leave the same vertex.
    #[error("{} and {} leave different vertices", .0[0], .0[1])]
    NotOneVertex([HalfKey; 2]),
    /// Both ends of the arc are at the same place.
    #[error("both ends of the arc are at {0}")]
    SameHalf(HalfKey),
    /// The half-edges are no simple closed walk.
    #[error("the half-edges do not make a closed walk of 3 or more different vertices")]
    NotALoop,
    /// The loop meets a hole.
    #[error("the loop meets a hole at {0}")]
    TouchesHole(VertexKey),
    /// The holes have different numbers of sides.
    #[error("one hole has {}, the other has {}", counted(.0[0], "side"), .0[1])]
    DifferentLengths([usize; 2]),
    /// Both half-edges are along the same hole.
    #[error("{} and {} are along the same hole", .0[0], .0[1])]
    SameHole([HalfKey; 2]),
    /// A face would come back to a vertex.
    #[error("{0} would come back to a vertex")]
    VertexTwice(FaceKey),
}

impl EditRefusal {
    /// The word for the kind of reason, as documents and other programs use it.
    pub fn code(&self) -> &'static str {
        match self {
            EditRefusal::Stale(_) => "stale",
            EditRefusal::Full => "full",
            EditRefusal::NotBetween => "not-between",
            EditRefusal::Degree { .. } => "degree",
            EditRefusal::Triangle(_) => "triangle",
            EditRefusal::NotATriangle(_) => "not-a-triangle",
            EditRefusal::AlreadyJoined(_) => "already-joined",
            EditRefusal::TwoFaces(_) => "two-faces",
            EditRefusal::Adjacent(_) => "adjacent",
            EditRefusal::Boundary(_) => "boundary",
            EditRefusal::SharesMore { .. } => "shares-more",
            EditRefusal::LinkCondition { .. } => "link-condition",
            EditRefusal::Bridge(_) => "bridge",
            EditRefusal::WouldClose(_) => "would-close",
            EditRefusal::WouldPinch(_) => "would-pinch",
            EditRefusal::NotAHole(_) => "not-a-hole",
            EditRefusal::NotOneVertex(_) => "not-one-vertex",
            EditRefusal::SameHalf(_) => "same-half",
            EditRefusal::NotALoop => "not-a-loop",
            EditRefusal::TouchesHole(_) => "touches-hole",
            EditRefusal::DifferentLengths(_) => "different-lengths",
            EditRefusal::SameHole(_) => "same-hole",
            EditRefusal::VertexTwice(_) => "vertex-twice",
        }
    }
}

/// All the elements of a failed link condition, in words.
fn elements(vertices: &[VertexKey], edges: &[EdgeKey], faces: &[FaceKey]) -> String {
    let vertices = vertices.iter().map(VertexKey::to_string);
    let all =
        vertices.chain(edges.iter().map(EdgeKey::to_string)).chain(faces.iter().map(FaceKey::to_string));
    all.collect::<Vec<String>>().join(", ")
}

/// An operator was refused, and nothing was changed: all reasons, never only the first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// The reasons; there is at least one.
    pub reasons: Vec<EditRefusal>,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (place, reason) in self.reasons.iter().enumerate() {
            write!(f, "{}{reason}", if place == 0 { "" } else { "; " })?;
        }
        Ok(())
    }
}

impl std::error::Error for Refused {}

impl From<EditRefusal> for Refused {
    fn from(reason: EditRefusal) -> Self {
        Refused { reasons: vec![reason] }
    }
}

impl From<StaleKey> for Refused {
    fn from(StaleKey(key): StaleKey) -> Self {
        EditRefusal::Stale(key).into()
    }
}

/// An answer out of the reasons that were found.
pub(crate) fn unless(reasons: Vec<EditRefusal>) -> Result<(), Refused> {
    if reasons.is_empty() { Ok(()) } else { Err(Refused { reasons }) }
}
