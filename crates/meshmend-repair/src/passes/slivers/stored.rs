//! Where the vertices were stored that earlier passes joined.

use meshmend_core::{PolygonMesh, VertexId};
use meshmend_geometry::vector::{Point, is_finite, place_bits};

use crate::Context;
use crate::stored_vertices::StoredVertices;

/// For each vertex the points beside its own at which the vertices were stored that it is now, ascending by vertex.
///
/// *Cost*: linear, and O(n log n) in the points.
pub(super) fn points(mesh: &PolygonMesh, context: &Context<'_>) -> Vec<(VertexId, Point)> {
    let stored = StoredVertices::new(mesh, context);
    if stored.are_present() {
        return Vec::new();
    }
    let faces = mesh.complex().faces();
    let point = |corner| {
        let (vertex, point) = (faces.corner_vertex(corner), stored.position(stored.of(corner)));
        let is_elsewhere = is_finite(&point) && point != mesh.position(vertex);
        is_elsewhere.then_some((vertex, point))
    };
    let mut points: Vec<(VertexId, Point)> = faces.corners().filter_map(point).collect();
    points.sort_unstable_by_key(|&(vertex, point)| (vertex, place_bits(point)));
    points.dedup();
    points
}
