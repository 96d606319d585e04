//! Which corners stand at each vertex: 14 bytes a triangle of a closed mesh.

use std::ops::Range;

use super::grouping::{Groups, Records, Strategy};
use crate::{Array, CornerId, FaceTable, Id, Per, VertexId};

/// The corners of each vertex, ascending.
#[derive(Debug)]
pub(crate) struct VertexCorners(Groups<CornerId>);

impl VertexCorners {
    /// *Cost*: linear; two passes over the corners, four where they are scattered.
    pub(crate) fn build(faces: &FaceTable) -> Self {
        // In order, putting together what threads have found takes longer than finding it.
        let strategy = Strategy::for_table(faces);
        let strategy =
            Strategy { threads: if strategy.is_scattered { strategy.threads } else { 1 }, ..strategy };
        let shares = strategy.shares(faces.corner_count());
        let corners: Vec<_> = shares.into_iter().map(|range| FaceCorners { faces, range }).collect();
        VertexCorners(Groups::joined(strategy.collect(faces.vertex_count(), &corners)))
    }

    #[inline]
    pub(crate) fn of(&self, vertex: VertexId) -> &[CornerId] {
        let v = vertex.index();
        &self.0.items[self.0.starts[v] as usize..self.0.starts[v + 1] as usize]
    }

    /// The arrays that they consist of.
    pub(crate) fn arrays(&self) -> [Array; 2] {
        [
            Array::new("vertex starts", Per::Vertex, size_of::<u32>(), self.0.starts.capacity()),
            Array::new("vertex corners", Per::Corner, size_of::<CornerId>(), self.0.items.capacity()),
        ]
    }

    pub(crate) fn heap_bytes(&self) -> usize {
        self.arrays().iter().map(Array::bytes).sum()
    }
}

/// Some corners, by their vertices.
struct FaceCorners<'a> {
    faces: &'a FaceTable,
    range: Range<usize>,
}

impl Records<CornerId> for FaceCorners<'_> {
    #[inline]
    fn for_each(&self, mut visit: impl FnMut(u32, CornerId)) {
        let vertices = &self.faces.corner_vertices()[self.range.clone()];
        self.range.clone().zip(vertices).for_each(|(corner, vertex)| visit(vertex.0, CornerId::new(corner)));
    }
}
