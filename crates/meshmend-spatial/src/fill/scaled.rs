//! The points of an opening in a size at which products of coordinates neither overflow nor vanish.

use meshmend_geometry::vector::{Point, length};

use super::Opening;
use super::facet::{Direction, Facet};
use super::factor::factor_for;

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
