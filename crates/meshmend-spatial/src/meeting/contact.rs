//! The ways in which two faces meet that do not meet properly.

use crate::surface::Cell;

/// What of two faces meets, where they share more than a corner or an edge; the greatest last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Contact {
    /// A corner of one lies on an edge of the other.
    VertexEdge,
    /// A corner of one lies on the inside of the other.
    VertexFace,
    /// An edge of one crosses or overlaps one of the other.
    EdgeEdge,
    /// An edge of one lies on the inside of the other, or a part of it.
    EdgeFace,
    /// Their insides have a common point: they cross or overlap.
    FaceFace,
    /// Their corners have the same positions in the same cycle, either way round.
    Coincident,
}

impl Contact {
    /// All of them, the least first.
    pub const ALL: [Contact; 6] = [
        Contact::VertexEdge,
        Contact::VertexFace,
        Contact::EdgeEdge,
        Contact::EdgeFace,
        Contact::FaceFace,
        Contact::Coincident,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Contact::VertexEdge => "vertex-edge",
            Contact::VertexFace => "vertex-face",
            Contact::EdgeEdge => "edge-edge",
            Contact::EdgeFace => "edge-face",
            Contact::FaceFace => "face-face",
            Contact::Coincident => "coincident",
        }
    }

    /// That of two cells; two corners meet properly.
    pub(crate) fn of_cells(cells: [Cell; 2]) -> Option<Self> {
        let [one, other] = cells.map(Cell::count_ones);
        match (one.min(other), one.max(other)) {
            (1, 2) => Some(Contact::VertexEdge),
            (1, 3) => Some(Contact::VertexFace),
            (2, 2) => Some(Contact::EdgeEdge),
            (2, 3) => Some(Contact::EdgeFace),
            (3, 3) => Some(Contact::FaceFace),
            _ => None,
        }
    }
}
