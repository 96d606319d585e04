//! The sides along the boundary of a mesh, found by the vertices at which they begin.

use meshmend_core::{Column, Connectivity, CornerId, VertexId};

/// For each vertex the boundary sides there.
pub(super) struct Borders {
    /// The corner whose side is boundary and begins at the vertex; the last one where there are several.
    leaving: Column<VertexId, Option<CornerId>>,
    /// How many boundary sides begin or end at the vertex, up to three.
    counts: Column<VertexId, u8>,
}

impl Borders {
    /// *Cost*: linear.
    pub(super) fn of<K: Connectivity>(kernel: &K) -> Self {
        let count = kernel.vertex_count();
        let mut borders = Borders { leaving: Column::filled(None, count), counts: Column::filled(0, count) };
        for edge in kernel.edges() {
            let mut corners = kernel.edge_corners(edge);
            if let (Some(corner), None) = (corners.next(), corners.next()) {
                borders.leaving[kernel.corner_vertex(corner)] = Some(corner);
                for end in kernel.edge_ends(edge) {
                    borders.counts[end] = (borders.counts[end] + 1).min(3);
                }
            }
        }
        borders
    }

    /// Whether a loop comes to each of its vertices once, and no other loop does.
    pub(super) fn is_simple(&self, vertices: &[VertexId]) -> bool {
        vertices.iter().all(|&vertex| self.counts[vertex] == 2)
    }

    /// The corners whose sides a loop consists of, in its order; `None` where a side runs the other way.
    pub(super) fn sides<K: Connectivity>(&self, kernel: &K, vertices: &[VertexId]) -> Option<Vec<CornerId>> {
        let next = vertices.iter().cycle().skip(1);
        let side = |(&from, &to): (&VertexId, &VertexId)| {
            self.leaving[from].filter(|&corner| kernel.corner_target(corner) == to)
        };
        vertices.iter().zip(next).map(side).collect()
    }
}
