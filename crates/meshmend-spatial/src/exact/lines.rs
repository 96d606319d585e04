//! What lies on one line, in which order, and on which side of a line in space.

use meshmend_geometry::vector::{Point, dot, minus};

use super::integers::{cross, dot as integers_dot, integer_points, minus as integers_minus};
use super::sides::{Axis, side_of_plane, turn_along};
use super::sign::Sign;

/// Below this an error of rounding may be one of underflow.
const UNDERFLOW: f64 = f64::MIN_POSITIVE * 1e20;
/// Of a scalar product of two differences, relative to the sum of its terms' sizes, rounded up.
const ERROR: f64 = 8.0 * f64::EPSILON / 2.0;

/// Whether three points lie on one line.
///
/// *Cost*: up to three of [`turn_along`].
pub fn are_collinear(triangle: [Point; 3]) -> bool {
    projection_of(triangle).is_none()
}

/// An axis along which three points are seen to turn, and which way they turn; `None` if they lie on one line.
///
/// *Cost*: up to three of [`turn_along`].
pub fn projection_of(triangle: [Point; 3]) -> Option<(Axis, Sign)> {
    // The one with the largest of the normal's coordinates is found at once.
    let [p, q] = [minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0])];
    let sizes = meshmend_geometry::vector::cross(p, q).map(f64::abs);
    let largest =
        if sizes[2] >= sizes[0] && sizes[2] >= sizes[1] { 2 } else { usize::from(sizes[1] > sizes[0]) };
    let axes = [0, 1, 2].map(|at| Axis::ALL[(largest + at) % 3]);
    let seen = axes.into_iter().map(|axis| (axis, turn_along(axis, triangle)));
    seen.into_iter().find(|&(_, sign)| !sign.is_zero())
}

/// How the feet of two points on a line compare, along the direction from `from` to `to`: negative if the first comes first.
///
/// *Cost*: constant, as for [`side_of_plane`].
pub fn compare_along([from, to]: [Point; 2], one: Point, other: Point) -> Sign {
    let (along, way) = (minus(to, from), minus(one, other));
    let product = dot(along, way);
    let size = (0..3).map(|i| (along[i] * way[i]).abs()).sum::<f64>() + UNDERFLOW;
    if product.abs() > ERROR * size && size < f64::INFINITY {
        return Sign::of(product);
    }
    let [from, to, one, other] = integer_points([from, to, one, other]);
    Sign::from(&integers_dot(&integers_minus(&to, &from), &integers_minus(&one, &other)))
}

/// Whether two points that are not on a line lie in one half-plane that the line bounds.
///
/// *Cost*: constant, as for [`side_of_plane`]; microseconds where the points lie in one plane with the line.
pub fn are_in_same_half_plane([from, to]: [Point; 2], one: Point, other: Point) -> bool {
    if !side_of_plane([from, to, one], other).is_zero() {
        return false;
    }
    let [from, to, one, other] = integer_points([from, to, one, other]);
    let along = integers_minus(&to, &from);
    let normals = [one, other].map(|point| cross(&along, &integers_minus(&point, &from)));
    Sign::from(&integers_dot(&normals[0], &normals[1])) == Sign::Positive
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Powers of two, so that multiples are exact.
    const SCALES: [f64; 5] = [1.0, 5e-324, 5e-324 * 1048576.0, 1.157920892373162e77, 5.617791046444737e306];

    #[test]
    fn points_on_a_line_are_told_at_any_scale() {
        for scale in SCALES {
            let at = |x: f64, y: f64, z: f64| [x * scale, y * scale, z * scale];
            assert!(are_collinear([at(0.0, 0.0, 0.0), at(1.0, 2.0, 3.0), at(3.0, 6.0, 9.0)]));
            assert!(!are_collinear([at(0.0, 0.0, 0.0), at(1.0, 2.0, 3.0), at(3.0, 6.0, 8.0)]));
            assert!(are_collinear([at(1.0, 2.0, 3.0); 3]));
            let line = [at(0.0, 0.0, 0.0), at(1.0, 1.0, 1.0)];
            assert_eq!(compare_along(line, at(1.0, 0.0, 0.0), at(0.0, 0.0, 2.0)), Sign::Negative);
            assert_eq!(compare_along(line, at(3.0, 0.0, 0.0), at(0.0, 1.0, 2.0)), Sign::Zero);
            assert_eq!(compare_along(line, at(4.0, 0.0, 0.0), at(0.0, 1.0, 2.0)), Sign::Positive);
        }
    }

    #[test]
    fn half_planes_are_told_at_any_scale() {
        for scale in SCALES {
            let at = |x: f64, y: f64, z: f64| [x * scale, y * scale, z * scale];
            let line = [at(0.0, 0.0, 0.0), at(1.0, 1.0, 1.0)];
            assert!(are_in_same_half_plane(line, at(1.0, 0.0, 0.0), at(3.0, 1.0, 1.0)));
            assert!(!are_in_same_half_plane(line, at(1.0, 0.0, 0.0), at(0.0, 1.0, 1.0)));
            assert!(!are_in_same_half_plane(line, at(1.0, 0.0, 0.0), at(0.0, 1.0, 2.0)));
        }
    }
}
