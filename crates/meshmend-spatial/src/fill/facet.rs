//! One triangle of a fill: its direction, its area, and how far it is folded against another.
//!
//! The direction of a slim triangle is hardly that of a product of rounded differences. So differences keep what rounding
//! takes from them, and products are exact, wherever the triangle is slim.

use meshmend_geometry::vector::{Point, area_vector, cross, dot, minus};

use super::factor::factor_for;
use crate::exact::are_collinear;

/// Below this square of the sine at a corner, products are computed exactly.
const SLIM: f64 = 1e-8;
/// Below this square it is asked whether the triangle has an area at all.
const NEARLY_FLAT: f64 = 1e-24;

/// A vector of length 1, and behind it the number 1. Without a direction all four numbers are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Direction([f64; 4]);

impl Direction {
    const NONE: Direction = Direction([0.0; 4]);

    /// The direction of a vector of any length.
    pub(super) fn of(vector: Point) -> Self {
        let largest = vector.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        if largest == 0.0 || !largest.is_finite() {
            return Direction::NONE;
        }
        let even = vector.map(|x| x / largest);
        let size = dot(even, even).sqrt();
        Direction([even[0] / size, even[1] / size, even[2] / size, 1.0])
    }

    /// How far two neighbours are folded: 1 − cos of the angle between them, and 0 where one has no direction.
    #[inline]
    pub(super) fn fold(self, other: Direction) -> f64 {
        let ([a, b, c, has], [x, y, z, other_has]) = (self.0, other.0);
        (has * other_has - (a * x + b * y + c * z)).max(0.0)
    }
}

/// A triangle of a fill.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    pub(super) direction: Direction,
    pub(super) area: f64,
    /// Whether all corners lie on one line, exactly.
    pub(super) is_flat: bool,
}

impl Facet {
    pub(super) fn of(corners: [Point; 3]) -> Self {
        let normal = normal_of(corners);
        let direction = Direction::of(normal);
        if direction == Direction::NONE {
            return Facet { direction, area: 0.0, is_flat: true };
        }
        Facet { direction, area: dot(normal, normal).sqrt() / 2.0, is_flat: false }
    }
}

/// The direction of a face that an opening may have beside it, of length 1; zero where it has none.
///
/// *Cost*: linear in the corners.
pub fn direction_of_face(points: &[Point]) -> Point {
    let factor = factor_for(points);
    let scaled = |point: &Point| point.map(|x| x * factor);
    let vector = match points {
        [a, b, c] => normal_of([a, b, c].map(scaled)),
        _ => area_vector(points.iter().map(scaled)),
    };
    let Direction([x, y, z, _]) = Direction::of(vector);
    [x, y, z]
}

/// The vector product of two sides of a triangle; zero just where its corners lie on one line.
fn normal_of([a, b, c]: [Point; 3]) -> Point {
    let (u, v) = (minus(b, a), minus(c, a));
    let sides = dot(u, u) * dot(v, v);
    let normal = cross(u, v);
    if dot(normal, normal) >= SLIM * sides && sides > 0.0 {
        return normal;
    }
    let normal = careful_normal([a, b, c]);
    if dot(normal, normal) < NEARLY_FLAT * sides && are_collinear([a, b, c]) { [0.0; 3] } else { normal }
}

/// The vector product with differences and products to twice the usual precision.
fn careful_normal([a, b, c]: [Point; 3]) -> Point {
    let u: [[f64; 2]; 3] = std::array::from_fn(|axis| difference(b[axis], a[axis]));
    let v: [[f64; 2]; 3] = std::array::from_fn(|axis| difference(c[axis], a[axis]));
    std::array::from_fn(|axis| {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let ([one, rest], [other, other_rest]) = (product(u[i], v[j]), product(u[j], v[i]));
        let [whole, rounding] = difference(one, other);
        whole + (rounding + (rest - other_rest))
    })
}

/// A difference, and what rounding took from it.
fn difference(a: f64, b: f64) -> [f64; 2] {
    let whole = a - b;
    let taken = a - whole;
    [whole, (a - (whole + taken)) + (taken - b)]
}

/// A product of two such numbers, and what rounding took from it.
fn product([a, a_rest]: [f64; 2], [b, b_rest]: [f64; 2]) -> [f64; 2] {
    let whole = a * b;
    [whole, a.mul_add(b, -whole) + (a * b_rest + a_rest * b)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fold_is_one_less_the_cosine() {
        let up = Direction::of([0.0, 0.0, 1e-200]);
        let folds = [[0.0, 0.0, 7.0], [1e200, 0.0, 0.0], [0.0, 0.0, -3.0], [0.0; 3]];
        assert_eq!(folds.map(|other| up.fold(Direction::of(other))), [0.0, 1.0, 2.0, 0.0]);
    }

    #[test]
    fn a_slim_triangle_has_its_direction_and_one_on_a_line_has_none() {
        let slim = Facet::of([[0.1, 0.1, 0.1], [0.7, 0.7, 0.7], [0.4, 0.4, 0.4 + f64::EPSILON / 4.0]]);
        let line = Facet::of([[0.1, 0.1, 0.1], [0.7, 0.7, 0.7], [0.4, 0.4, 0.4]]);
        let sideways = Direction::of([1.0, -1.0, 0.0]);
        assert!(slim.direction.fold(sideways).min(2.0 - slim.direction.fold(sideways)) < 1e-9);
        assert!(line.is_flat && line.area == 0.0 && !slim.is_flat, "{line:?}");
    }

    #[test]
    fn the_direction_of_a_face_has_length_one_in_any_size() {
        for size in [1e-200, 1.0, 1e200] {
            let square = [[0.0, 0.0, size], [size, 0.0, size], [size, size, size], [0.0, size, size]];
            assert_eq!(direction_of_face(&square), [0.0, 0.0, 1.0]);
            assert_eq!(direction_of_face(&square[..3]), [0.0, 0.0, 1.0]);
        }
        assert_eq!(direction_of_face(&[[1.0; 3]; 3]), [0.0; 3]);
    }
}
