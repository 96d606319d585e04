//! Meshes that need no splitting: manifold ones, whose every vertex is where its corners were stored.
//!
//! Most meshes are like this, and it takes one look at each edge and each vertex to see it. What this says is what the
//! matching would find: with at most two sides at every edge all sides are matched, so the new vertices are the
//! umbrellas; with one umbrella a vertex they are the vertices; and they keep their order and their places if the
//! lowest stored vertices behind them do.

use meshmend_core::{
    Connectivity, EdgeClass, PolygonMesh, VertexClass, VertexId, edge_class, vertex_classes,
};

use crate::StoredNames;

/// Whether every edge has one side or two, and every vertex in a face one umbrella.
pub(super) fn is_manifold<K: Connectivity>(kernel: &K) -> bool {
    let is_whole = |class: &VertexClass| class.is_manifold() || *class == VertexClass::Unreferenced;
    kernel.edges().all(|edge| edge_class(kernel, edge) != EdgeClass::NonManifold)
        && vertex_classes(kernel).values().iter().all(is_whole)
}

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
