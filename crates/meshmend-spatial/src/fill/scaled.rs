//! The points of an opening in a size at which products of coordinates neither overflow nor vanish.

use meshmend_geometry::vector::{Point, is_finite, length};

use super::Opening;
use super::facet::{Direction, Facet};

/// The corners of an opening, scaled by a power of two, and the directions beside its sides.
pub(super) struct Scaled {
    points: Vec<Point>,
    beside: Vec<Direction>,
    /// What lengths were multiplied by.
    factor: f64,
}

impl Scaled {
    pub(super) fn of(opening: &Opening<'_>) -> Self {
        let factor = factor_for(opening.points);
        let points = opening.points.iter().map(|point| point.map(|x| x * factor)).collect();
        let beside = opening.beside.iter().map(|&vector| Direction::of(vector)).collect();
        Scaled { points, beside, factor }
    }

    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    pub(super) fn point(&self, corner: usize) -> Point {
        self.points[corner]
    }

    /// Another point at the same scale.
    pub(super) fn scaled(&self, point: Point) -> Point {
        point.map(|x| x * self.factor)
    }

    /// The direction of the face beside the side that begins at a corner.
    pub(super) fn beside(&self, corner: usize) -> Direction {
        self.beside[corner]
    }

    pub(super) fn facet(&self, corners: [usize; 3]) -> Facet {
        Facet::of(corners.map(|corner| self.points[corner]))
    }

    /// The distance of two corners, for comparisons.
    pub(super) fn distance(&self, one: usize, other: usize) -> f64 {
        length(std::array::from_fn(|axis| self.points[one][axis] - self.points[other][axis]))
    }

    /// An area as it is without the scale.
    pub(super) fn unscaled_area(&self, area: f64) -> f64 {
        area / self.factor / self.factor
    }
}

/// Coordinates of this size, or of one over it, need no scale.
const USUAL: f64 = 1e60;

/// The power of two that brings the largest coordinate near 1; 1 where there is none, or where it is of a usual size.
pub(super) fn factor_for(points: &[Point]) -> f64 {
    let finite = points.iter().filter(|point| is_finite(point)).flatten();
    let largest = finite.fold(0.0f64, |most, x| most.max(x.abs()));
    let is_usual = largest == 0.0 || (1.0 / USUAL..USUAL).contains(&largest);
    if is_usual { 1.0 } else { (-largest.log2().floor()).clamp(-1020.0, 1020.0).exp2() }
}
