//! Meshes that need no splitting: manifold ones, whose every vertex is where its corners were stored.
//!
//! Most meshes are like this, and one look at each corner shows it. The answer is the one that the matching would give:
//! with at most two sides at every edge all sides are matched, so the new vertices are the umbrellas; with one umbrella
//! a vertex they are the vertices; and they keep their order and their places if the lowest stored vertices behind them
//! do.

use meshmend_core::{Connectivity, PolygonMesh, VertexId};

use crate::stored_vertices::StoredVertices;

/// Whether the lowest stored vertex behind each vertex is where the vertex is, and these ascend as the vertices do.
pub(super) fn keeps_vertices<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    stored: &StoredVertices<'_>,
) -> bool {
    if stored.are_present() {
        return true;
    }
    let mut lowest: Vec<Option<VertexId>> = vec![None; kernel.vertex_count()];
    for corner in kernel.corners() {
        let behind = stored.of(corner);
        let lowest = &mut lowest[kernel.corner_vertex(corner).0 as usize];
        *lowest = Some(lowest.map_or(behind, |lowest| lowest.min(behind)));
    }
    let mut last = None;
    kernel.vertices().zip(lowest).all(|(vertex, lowest)| {
        let behind = lowest.unwrap_or_else(|| stored.of_vertex(vertex));
        let bits = |point: [f64; 3]| point.map(f64::to_bits);
        last.replace(behind) < Some(behind) && bits(stored.position(behind)) == bits(mesh.position(vertex))
    })
}
