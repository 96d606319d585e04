//! The scale at which products of coordinates neither overflow nor vanish.

use meshmend_geometry::vector::{Point, is_finite};

/// Coordinates of this size, or of one over it, need no scale.
const USUAL: f64 = 1e60;

/// The power of two that brings the largest coordinate near 1; 1 where there is none, or where it is of a usual size.
pub(super) fn factor_for(points: &[Point]) -> f64 {
    let finite = points.iter().filter(|point| is_finite(point)).flatten();
    let largest = finite.fold(0.0f64, |most, x| most.max(x.abs()));
    let is_usual = largest == 0.0 || (1.0 / USUAL..USUAL).contains(&largest);
    if is_usual { 1.0 } else { (-largest.log2().floor()).clamp(-1020.0, 1020.0).exp2() }
}
