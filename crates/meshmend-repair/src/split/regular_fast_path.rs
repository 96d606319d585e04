//! Meshes that need no splitting: manifold ones, whose every vertex is where its corners were stored.
//!
//! Most meshes are like this, and it takes one look at each vertex to see it. What this says is what the
//! matching would find: with at most two sides at every edge all sides are matched, so the new vertices are the
//! umbrellas; with one umbrella a vertex they are the vertices; and they keep their order and their places if the
//! lowest stored vertices behind them do.

use meshmend_core::{Connectivity, PolygonMesh, VertexId};

use crate::StoredNames;

/// Whether the lowest stored vertex behind each vertex is where the vertex is, and these ascend as the vertices do.
pub(super) fn keeps_names<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, names: &StoredNames<'_>) -> bool {
    if names.are_present() {
        return true;
    }
    let mut lowest: Vec<Option<VertexId>> = vec![None; kernel.vertex_count()];
    for corner in kernel.corners() {
        let name = names.of(corner);
        let lowest = &mut lowest[kernel.corner_vertex(corner).0 as usize];
        *lowest = Some(lowest.map_or(name, |lowest| lowest.min(name)));
    }
    let mut last = None;
    kernel.vertices().zip(lowest).all(|(vertex, lowest)| {
        let name = lowest.unwrap_or_else(|| names.of_vertex(vertex));
        let bits = |point: [f64; 3]| point.map(f64::to_bits);
        last.replace(name) < Some(name) && bits(names.position(name)) == bits(mesh.position(vertex))
    })
}
