//! Normals for vertices that have none beside others that have one.

use meshmend_core::{Id, PolygonMesh};
use meshmend_geometry::vector::{area_vector, length};

/// For each vertex the direction of its first face that has an area, or upwards.
///
/// *Cost*: linear.
pub(super) fn normals_of_faces(mesh: &PolygonMesh) -> Vec<[f32; 3]> {
    let mut normals: Vec<Option<[f32; 3]>> = vec![None; mesh.counts().vertices];
    for face in mesh.faces().faces() {
        let vertices = mesh.faces().face_vertices(face);
        if vertices.iter().all(|vertex| normals[vertex.index()].is_some()) {
            continue;
        }
        let area = area_vector(vertices.iter().map(|&vertex| mesh.position(vertex)));
        let size = length(area);
        if size.is_normal() {
            let normal = area.map(|x| (x / size) as f32);
            vertices.iter().for_each(|vertex| {
                normals[vertex.index()].get_or_insert(normal);
            });
        }
    }
    normals.into_iter().map(|normal| normal.unwrap_or([0.0, 0.0, 1.0])).collect()
}
