//! The canonical numbering of a complex's edges, and which corners use which edge.
//!
//! ```text
//! ends          (v0,v1) (v0,v2) (v1,v2) ...      sorted by (smaller vertex, larger vertex)
//! corner_edge   c0 → e0   c1 → e2   ...          the side that begins at the corner
//! edge_sides    e0: c0 c7 | e1: c2 | ...         ascending corners, grouped by edge, each with its side's direction
//! ```
//!
//! Bytes a triangle of a closed mesh: 12 + 12 + 12 + 6 = 42.
//!
//! Building it is what costs, not asking it.

use crate::{Array, Column, CornerId, EdgeId, Id, Per, VertexId};

/// The edges of a table whose every side joins two different vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeTable {
    pub(super) ends: Column<EdgeId, [VertexId; 2]>,
    pub(super) corner_edge: Column<CornerId, EdgeId>,
    pub(super) starts: Vec<u32>,
    pub(super) edge_sides: Vec<EdgeSide>,
}

/// A corner whose side runs along an edge, and which way: one word, as there are fewer than 2³¹ corners.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EdgeSide(pub(super) u32);

impl EdgeSide {
    /// The corner at which the side begins.
    #[inline]
    pub fn corner(self) -> CornerId {
        CornerId(self.0 >> 1)
    }

    /// Whether the side runs from the smaller to the larger vertex.
    #[inline]
    pub fn is_forward(self) -> bool {
        self.0 & 1 == 1
    }
}

impl EdgeTable {
    /// How many edges there are.
    pub fn edge_count(&self) -> usize {
        self.ends.len()
    }

    /// Every edge, ascending.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = EdgeId> + Clone + use<> {
        (0..self.ends.len()).map(EdgeId::new)
    }

    /// The two vertices of an edge, the smaller one first.
    #[inline]
    pub fn ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.ends[edge]
    }

    /// All edges' ends, by ascending edge.
    pub fn all_ends(&self) -> &[[VertexId; 2]] {
        self.ends.values()
    }

    /// The edge that a corner's side runs along.
    #[inline]
    pub fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.corner_edge[corner]
    }

    /// The corners whose sides run along an edge, ascending.
    #[inline]
    pub fn edge_corners(&self, edge: EdgeId) -> impl ExactSizeIterator<Item = CornerId> + Clone {
        self.edge_sides(edge).iter().map(|side| side.corner())
    }

    /// The same, each with the direction of its side.
    #[inline]
    pub fn edge_sides(&self, edge: EdgeId) -> &[EdgeSide] {
        let e = edge.index();
        &self.edge_sides[self.starts[e] as usize..self.starts[e + 1] as usize]
    }

    /// The arrays that it consists of.
    pub(crate) fn arrays(&self) -> [Array; 4] {
        [
            Array::of_column("edge ends", Per::Edge, &self.ends),
            Array::of_column("corner edge", Per::Corner, &self.corner_edge),
            Array::new("edge starts", Per::Edge, size_of::<u32>(), self.starts.capacity()),
            Array::new("edge sides", Per::Corner, size_of::<EdgeSide>(), self.edge_sides.capacity()),
        ]
    }

    /// Bytes on the heap.
    pub fn heap_bytes(&self) -> usize {
        self.ends.heap_bytes()
            + self.corner_edge.heap_bytes()
            + self.starts.capacity() * size_of::<u32>()
            + self.edge_sides.capacity() * size_of::<EdgeSide>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceTable;

    #[test]
    fn edges_are_numbered_by_their_ends_and_list_ascending_corners() {
        let corners = [2, 1, 0, 0, 1, 3, 1, 0, 4].map(VertexId).to_vec();
        let table = EdgeTable::build(&FaceTable::triangles(5, corners).unwrap());
        let ends: Vec<_> = table.all_ends().iter().map(|e| e.map(|v| v.0)).collect();
        assert_eq!(ends, [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [1, 3], [1, 4]]);
        assert!(table.edge_corners(EdgeId(0)).eq([1, 3, 6].map(CornerId)));
        let directions: Vec<bool> =
            table.edge_sides(EdgeId(0)).iter().map(|side| side.is_forward()).collect();
        assert_eq!(directions, [false, true, false]);
        assert_eq!(table.corner_edge(CornerId(7)), EdgeId(3));
    }
}
