//! A triangle of a face's surface.

use meshmend_core::{FaceId, VertexId};

/// A corner, a side or the whole of a triangle, by the places of its corners: bit k for corner k.
pub type Cell = u8;

/// The cell that is a whole triangle.
pub const WHOLE: Cell = 0b111;

/// A triangle that is a face or a part of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangle {
    /// The lowest vertex at each corner's position, the way round that the face has. Numbers beyond the mesh's vertices are
    /// those of points on diagonals.
    pub corners: [VertexId; 3],
    /// The face that it is, or is a part of.
    pub face: FaceId,
    /// A bit for each cell of the triangle that lies inside the face: of corners those on diagonals, of sides diagonals.
    inside: u8,
}

impl Triangle {
    /// A face that is a triangle.
    pub(crate) fn whole(face: FaceId, corners: [VertexId; 3]) -> Self {
        Triangle { corners, face, inside: 0 }
    }

    /// A part of a larger face, of which some cells lie inside.
    pub(crate) fn part(face: FaceId, corners: [VertexId; 3], inside: impl IntoIterator<Item = Cell>) -> Self {
        let inside = inside.into_iter().fold(0, |inside, cell| inside | 1 << cell);
        Triangle { corners, face, inside }
    }

    /// The cell of the face that a cell of the triangle is, or lies inside of.
    #[inline]
    pub fn cell_of_face(&self, cell: Cell) -> Cell {
        if self.inside >> cell & 1 == 1 { WHOLE } else { cell }
    }

    /// Whether some corner or side of the triangle lies inside the face.
    #[inline]
    pub(crate) fn has_inside(&self) -> bool {
        self.inside != 0
    }
}
