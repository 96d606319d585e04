//! The default repair in one call.

use meshmend_core::PolygonMesh;
use meshmend_repair::{PassError, Pipeline, Repaired};

/// Repairs a mesh with the default pipeline: the result is manifold, consistently oriented where that can be, and
/// free of rubbish; no face is removed that is not degenerate, non-finite or there twice.
///
/// # Errors
/// When the result would have more elements than a mesh holds.
///
/// *Cost*: n log n in the corners.
pub fn repair(mesh: &PolygonMesh) -> Result<Repaired, PassError> {
    Pipeline::default().run(mesh)
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTable, VertexId};

    use super::*;

    #[test]
    fn a_triangle_that_is_there_twice_is_there_once() {
        let corners = [0, 1, 2, 1, 2, 0].map(VertexId).to_vec();
        let faces = FaceTable::triangles(3, corners).unwrap();
        let mesh = PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces).unwrap();
        let repaired = repair(&mesh).unwrap();
        assert_eq!((repaired.mesh.counts().faces, repaired.removed_faces.len()), (1, 1));
    }
}
