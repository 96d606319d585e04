//! How bad a triangulation is.

use std::cmp::Ordering;

use super::corners::{Polygon, Triangle, are_neighbours};
use crate::vector::{Point, cross, dot, minus};

/// What a triangulation avoids first, after triangles that join two corners at one vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Avoid {
    /// Triangles that lie the wrong way round or have no area, and then diagonals that are taken.
    Folds,
    /// Diagonals that are taken, and then such triangles.
    TakenDiagonals,
}

/// How bad a triangulation is, the worst first.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cost {
    /// Triangles two of whose corners stand at one vertex.
    pub(super) joined: u32,
    /// Triangles that lie the wrong way round.
    pub(super) folded: u32,
    /// Triangles without an area.
    pub(super) flat: u32,
    /// Diagonals that are taken.
    pub(super) taken: u32,
    /// The sum of one over the quality of each shape: 1 for an equilateral triangle.
    pub(super) shape: f64,
}

impl Cost {
    pub(super) fn plus(self, other: Cost) -> Cost {
        Cost {
            joined: self.joined + other.joined,
            folded: self.folded + other.folded,
            flat: self.flat + other.flat,
            taken: self.taken + other.taken,
            shape: self.shape + other.shape,
        }
    }

    /// Whether the triangles lie side by side.
    pub(super) fn is_proper(&self) -> bool {
        self.joined == 0 && self.folded == 0
    }
}

/// The costs of a polygon's triangles and diagonals.
pub(super) struct Costs<'a> {
    pub(super) polygon: Polygon<'a>,
    pub(super) avoid: Avoid,
    pub(super) is_taken: &'a dyn Fn(usize, usize) -> bool,
    pub(super) normal: Point,
}

impl Costs<'_> {
    pub(super) fn compared(&self, one: &Cost, other: &Cost) -> Ordering {
        let counts = |cost: &Cost| match self.avoid {
            Avoid::Folds => [cost.joined, cost.folded, cost.flat, cost.taken],
            Avoid::TakenDiagonals => [cost.joined, cost.taken, cost.folded, cost.flat],
        };
        counts(one).cmp(&counts(other)).then(one.shape.total_cmp(&other.shape))
    }

    pub(super) fn of(&self, triangle: Triangle) -> Cost {
        let [a, b, c] = triangle.map(|corner| self.polygon.vertex(corner));
        let joined = u32::from(a == b || b == c || c == a);
        Cost { joined, ..shape_cost(triangle.map(|corner| self.polygon.points[corner]), self.normal) }
    }

    pub(super) fn of_side(&self, one: usize, other: usize) -> Cost {
        let is_diagonal = !are_neighbours(self.polygon.len(), one, other);
        Cost { taken: u32::from(is_diagonal && (self.is_taken)(one, other)), ..Cost::default() }
    }

    pub(super) fn of_all(&self, triangles: &[Triangle]) -> Cost {
        triangles.iter().fold(Cost::default(), |sum, &triangle| sum.plus(self.of(triangle)))
    }
}

/// What the shape of a triangle costs: one over its quality, always finite.
fn shape_cost([a, b, c]: [Point; 3], normal: Point) -> Cost {
    let (u, v, w) = (minus(b, a), minus(c, a), minus(c, b));
    let area = cross(u, v);
    let size = dot(area, area).sqrt();
    let lengths = dot(u, u) + dot(v, v) + dot(w, w);
    let shape = lengths / (size * 2.0 * 3.0f64.sqrt());
    if !shape.is_finite() || size == 0.0 {
        return Cost { flat: 1, ..Cost::default() };
    }
    Cost { folded: u32::from(dot(area, normal) <= 0.0), shape, ..Cost::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_costs_more_the_worse_its_shape_is() {
        let up = [0.0, 0.0, 1.0];
        let cost = |[x, y]: [f64; 2], size: f64, normal| {
            shape_cost([[0.0; 3], [size, 0.0, 0.0], [x * size, y * size, 0.0]], normal)
        };
        let even = [0.5, 0.75f64.sqrt()];
        for size in [0.01, 1.0, 100.0] {
            assert!((cost(even, size, up).shape - 1.0).abs() < 1e-12);
            // Of the sides' squares, 1 + 1 + 2, a right angle makes half an area.
            assert!((cost([0.0, 1.0], size, up).shape - 2.0 / 3.0f64.sqrt()).abs() < 1e-12);
        }
        let [proper, folded, flat] =
            [cost(even, 1.0, up), cost(even, 1.0, [0.0, 0.0, -1.0]), cost([0.5, 0.0], 1.0, up)];
        assert_eq!([proper, folded, flat].map(|cost| (cost.folded, cost.flat)), [(0, 0), (1, 0), (0, 1)]);
    }
}
