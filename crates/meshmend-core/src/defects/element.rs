//! The elements of a mesh at which something can be wrong.

use std::fmt;

use crate::{EdgeId, FaceId, VertexId, counted};

/// An element of a mesh, or several that are one place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
#[allow(
    missing_docs,
    reason = "the fields are ids named after what they identify; the variants are explained"
)]
pub enum Element {
    /// A vertex.
    Vertex(VertexId),
    /// An edge of the complex, with the vertices that it joins.
    Edge { edge: EdgeId, ends: [VertexId; 2] },
    /// A face.
    Face(FaceId),
    /// A face where it is at a vertex.
    Corner { face: FaceId, vertex: VertexId },
    /// An edge that is not a side of any face, by its place in the list of loose edges.
    LooseEdge { index: u32, ends: [VertexId; 2] },
    /// A point that is an element of its own, by its place in the list of loose points.
    LoosePoint { index: u32, vertex: VertexId },
    /// The patch of a face, which is the lowest one in it.
    Patch(FaceId),
    /// The component of a face, which is the lowest one in it.
    Component(FaceId),
    /// A closed strip of faces.
    Strip(Box<Strip>),
}

/// Faces each of which is joined to the next one across an edge, the last one to the first.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Strip {
    /// The faces, in order.
    pub faces: Vec<FaceId>,
    /// The edges that are crossed, each behind its face.
    pub edges: Vec<EdgeId>,
}

impl Element {
    /// What such an element is called in reports.
    pub fn name(&self) -> &'static str {
        match self {
            Element::Vertex(_) => "vertex",
            Element::Edge { .. } => "edge",
            Element::Face(_) => "face",
            Element::Corner { .. } => "corner",
            Element::LooseEdge { .. } => "loose-edge",
            Element::LoosePoint { .. } => "loose-point",
            Element::Patch(_) => "patch",
            Element::Component(_) => "component",
            Element::Strip(_) => "strip",
        }
    }

    /// The face that it is, has or begins with.
    pub fn face(&self) -> Option<FaceId> {
        match self {
            Element::Face(face)
            | Element::Corner { face, .. }
            | Element::Patch(face)
            | Element::Component(face) => Some(*face),
            Element::Strip(strip) => strip.faces.first().copied(),
            _ => None,
        }
    }

    /// The edge of the complex that it is.
    pub fn edge(&self) -> Option<EdgeId> {
        match self {
            Element::Edge { edge, .. } => Some(*edge),
            _ => None,
        }
    }

    /// The vertex that it is, or at which it is.
    pub fn vertex(&self) -> Option<VertexId> {
        match self {
            Element::Vertex(vertex) | Element::Corner { vertex, .. } | Element::LoosePoint { vertex, .. } => {
                Some(*vertex)
            }
            _ => None,
        }
    }

    /// The vertices that it joins, if it is an edge.
    pub fn ends(&self) -> Option<[VertexId; 2]> {
        match self {
            Element::Edge { ends, .. } | Element::LooseEdge { ends, .. } => Some(*ends),
            _ => None,
        }
    }

    /// The element with other names for its vertices: those of another numbering of the same mesh.
    #[must_use]
    pub fn with_vertices(mut self, name: impl Fn(VertexId) -> VertexId) -> Self {
        match &mut self {
            Element::Vertex(vertex) | Element::Corner { vertex, .. } | Element::LoosePoint { vertex, .. } => {
                *vertex = name(*vertex);
            }
            Element::Edge { ends, .. } | Element::LooseEdge { ends, .. } => *ends = ends.map(name),
            Element::Face(_) | Element::Patch(_) | Element::Component(_) | Element::Strip(_) => {}
        }
        self
    }

    /// The element with other names for its edges: those of another numbering of the same mesh.
    #[must_use]
    pub fn with_edges(mut self, name: impl Fn(EdgeId) -> EdgeId) -> Self {
        match &mut self {
            Element::Edge { edge, .. } => *edge = name(*edge),
            Element::Strip(strip) => strip.edges.iter_mut().for_each(|edge| *edge = name(*edge)),
            _ => {}
        }
        self
    }

    /// The element with other names for its faces: those of another numbering of the same mesh.
    #[must_use]
    pub fn with_faces(mut self, name: impl Fn(FaceId) -> FaceId) -> Self {
        match &mut self {
            Element::Face(face)
            | Element::Corner { face, .. }
            | Element::Patch(face)
            | Element::Component(face) => *face = name(*face),
            Element::Strip(strip) => strip.faces.iter_mut().for_each(|face| *face = name(*face)),
            Element::Vertex(_)
            | Element::Edge { .. }
            | Element::LooseEdge { .. }
            | Element::LoosePoint { .. } => {}
        }
        self
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Element::Vertex(vertex) => write!(f, "{vertex}"),
            Element::Edge { edge, ends: [a, b] } => write!(f, "{edge} {a}-{b}"),
            Element::Face(face) => write!(f, "{face}"),
            Element::Corner { face, vertex } => write!(f, "{face} at {vertex}"),
            Element::LooseEdge { index, .. } => write!(f, "loose edge {index}"),
            Element::LoosePoint { index, .. } => write!(f, "loose point {index}"),
            Element::Patch(face) => write!(f, "the patch of {face}"),
            Element::Component(face) => write!(f, "the component of {face}"),
            Element::Strip(strip) => {
                write!(f, "a strip of {}", counted(strip.faces.len(), "face"))?;
                strip.faces.first().map_or(Ok(()), |first| write!(f, " from {first}"))
            }
        }
    }
}
