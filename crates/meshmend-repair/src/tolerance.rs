//! Distances that a user gives, and whether the coordinates of a mesh can resolve them.

use meshmend_core::PolygonMesh;

use crate::{Distance, PassError};

/// A distance that is one, and that the coordinates of the faces can resolve.
///
/// # Errors
/// When it is negative or not finite, or so small that coordinates as large as these can't differ by it.
///
/// *Cost*: linear.
pub(crate) fn resolved(pass: &'static str, mesh: &PolygonMesh, distance: f64) -> Result<f64, PassError> {
    if !(distance.is_finite() && distance >= 0.0) {
        return Err(no_tolerance(pass, distance));
    }
    if distance == 0.0 {
        return Ok(distance);
    }
    let used = mesh.faces().corner_vertices().iter().flat_map(|&vertex| mesh.position(vertex));
    let extent = used.filter(|x| x.is_finite()).fold(0.0f64, |most, x| most.max(x.abs()));
    if distance < extent * f64::EPSILON {
        return Err(unresolved(pass, distance, extent));
    }
    Ok(distance)
}

/// The length that a distance is on a mesh, if it is one that the coordinates can resolve.
///
/// # Errors
/// As [`resolved`].
///
/// *Cost*: linear.
pub(crate) fn resolved_on(
    pass: &'static str,
    mesh: &PolygonMesh,
    distance: Distance,
) -> Result<f64, PassError> {
    resolved(pass, mesh, distance.length_on(mesh))
}

/// Why a number is not a tolerance.
pub(crate) fn no_tolerance(pass: &'static str, distance: f64) -> PassError {
    let reason = format!("a tolerance must be a finite number of 0 or more, not {distance}");
    PassError::Request { pass, reason }
}

/// Why a tolerance is too fine.
pub(crate) fn unresolved(pass: &'static str, distance: f64, extent: f64) -> PassError {
    let reason = format!(
        "a tolerance of {distance:e} can't be resolved by coordinates as large as {extent:e}; {pass} exactly instead"
    );
    PassError::Request { pass, reason }
}
