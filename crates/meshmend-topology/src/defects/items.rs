//! The items of one kind of defect, with no more than tells them apart.

use meshmend_core::{Defect, DefectKind, EdgeId, Element, FaceId, VertexId};

use crate::{DuplicateFace, OneSidedStrip};

/// The items of a kind, by ascending id, in the form that their element has.
#[derive(Clone, Debug)]
pub(super) enum Items {
    Faces(Vec<FaceId>),
    Corners(Vec<(FaceId, VertexId)>),
    Repeats(Vec<DuplicateFace>),
    /// Edges that all have so many sides.
    Edges(Vec<EdgeAt>, u32),
    EdgesOfDegree(Vec<(EdgeAt, u32)>),
    Vertices(Vec<VertexId>),
    Pinches(Vec<Pinch>),
    LooseEdges(Vec<[VertexId; 2]>),
    LoosePoints(Vec<VertexId>),
    Strips(Vec<OneSidedStrip>),
}

#[derive(Clone, Copy, Debug)]
pub(super) struct EdgeAt {
    pub(super) edge: EdgeId,
    pub(super) ends: [VertexId; 2],
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Pinch {
    pub(super) vertex: VertexId,
    pub(super) umbrellas: u32,
    pub(super) boundary_only: bool,
}

impl Items {
    pub(super) fn len(&self) -> usize {
        match self {
            Items::Faces(list) => list.len(),
            Items::Corners(list) => list.len(),
            Items::Repeats(list) => list.len(),
            Items::Edges(list, _) => list.len(),
            Items::EdgesOfDegree(list) => list.len(),
            Items::Vertices(list) => list.len(),
            Items::Pinches(list) => list.len(),
            Items::LooseEdges(list) => list.len(),
            Items::LoosePoints(list) => list.len(),
            Items::Strips(list) => list.len(),
        }
    }

    /// The item at a place, as a defect of a kind.
    pub(super) fn defect(&self, kind: DefectKind, place: usize) -> Defect {
        let index = place as u32;
        match self {
            Items::Faces(list) => Defect::new(kind, Element::Face(list[place])),
            Items::Corners(list) => {
                let (face, vertex) = list[place];
                Defect::new(kind, Element::Corner { face, vertex })
            }
            Items::Repeats(list) => {
                let DuplicateFace { face, original, .. } = list[place];
                Defect::new(kind, Element::Face(face)).beside(Element::Face(original))
            }
            Items::Edges(list, degree) => at_edge(kind, list[place], *degree),
            Items::EdgesOfDegree(list) => at_edge(kind, list[place].0, list[place].1),
            Items::Vertices(list) => Defect::new(kind, Element::Vertex(list[place])),
            Items::Pinches(list) => {
                let Pinch { vertex, umbrellas, boundary_only } = list[place];
                Defect::pinched_vertex(vertex, umbrellas, boundary_only)
            }
            Items::LooseEdges(list) => Defect::new(kind, Element::LooseEdge { index, ends: list[place] }),
            Items::LoosePoints(list) => Defect::new(kind, Element::LoosePoint { index, vertex: list[place] }),
            Items::Strips(list) => list[place].clone().into(),
        }
    }
}

fn at_edge(kind: DefectKind, EdgeAt { edge, ends }: EdgeAt, degree: u32) -> Defect {
    Defect::new(kind, Element::Edge { edge, ends }).counting(degree)
}
