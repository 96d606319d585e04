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
