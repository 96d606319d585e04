//! Lengths, heights and directions of triangles, compared exactly: in doubles where rounding leaves no doubt, else in whole
//! numbers.

use std::cmp::Ordering;

use meshmend_geometry::vector::{Point, cross, dot, minus};
use num_bigint::BigInt;

use crate::exact::Sign;
use crate::exact::integers::{self, integer, integer_points, lowest_exponent};

/// Rounding changes a squared length by less than this part of it, and a coordinate of a normal by less than this part of the
/// longest squared edge.
const ERROR: f64 = 16.0 * f64::EPSILON;

/// Whether no product of such squares under- or overflows.
fn is_in_range(square: f64) -> bool {
    square > 1e-140 && square < 1e140
}

/// Whether two points are not farther apart than a length.
pub(super) fn are_within(one: Point, other: Point, length: f64) -> bool {
    let way = minus(one, other);
    let (square, limit) = (dot(way, way), length * length);
    let is_sure = (square - limit).abs() > ERROR * (square + limit);
    if is_in_range(square) && is_in_range(limit) && is_sure {
        return square < limit;
    }
    if one == other {
        return true;
    }
    let lowest = lowest_exponent(one.iter().chain(&other).chain([&length]));
    let [one, other] = [one, other].map(|point| point.map(|x| integer(x, lowest)));
    let way = integers::minus(&one, &other);
    integers::dot(&way, &way) <= integer(length, lowest).pow(2)
}

/// Whether a triangle is not higher over its longest edge than a length. It has one that is not a point.
pub(super) fn is_no_higher(triangle: [Point; 3], length: f64) -> bool {
    let Rounded { squares, normal } = Rounded::of(triangle);
    let longest = squares.into_iter().fold(0.0, f64::max);
    let (area, limit) = (dot(normal, normal).sqrt(), length * longest.sqrt());
    let is_sure = (area - limit).abs() > 2.0 * ERROR * (longest + limit);
    if is_in_range(longest) && limit < 1e140 && is_sure {
        return area < limit;
    }
    let lowest = lowest_exponent(triangle.iter().flatten().chain([&length]));
    let [a, b, c] = triangle.map(|point| point.map(|x| integer(x, lowest)));
    let sides = [(&b, &a), (&c, &b), (&a, &c)].map(|(to, from)| integers::minus(to, from));
    let longest = sides.each_ref().map(|side| integers::dot(side, side)).into_iter().max();
    let normal = integers::cross(&sides[0], &sides[1]);
    let limit = integer(length, lowest).pow(2) * longest.unwrap_or_default();
    integers::dot(&normal, &normal) <= limit
}

/// The place of a triangle's shortest edge, and that of its longest; of equal ones the first. Edge `i` runs from corner `i`
/// to the next.
pub(super) fn extreme_sides(triangle: [Point; 3]) -> [usize; 2] {
    let squares = Rounded::of(triangle).squares;
    let is_sure = |i: usize, j: usize| (squares[i] - squares[j]).abs() > ERROR * (squares[i] + squares[j]);
    let are_sure = is_sure(0, 1) && is_sure(1, 2) && is_sure(2, 0);
    if are_sure && squares.into_iter().all(is_in_range) {
        return extremes(&squares);
    }
    let [a, b, c] = integer_points(triangle);
    let sides = [(&b, &a), (&c, &b), (&a, &c)].map(|(to, from)| integers::minus(to, from));
    extremes(&sides.each_ref().map(|side| integers::dot(side, side)))
}

/// The places of the first least and of the first greatest of three numbers.
fn extremes<T: PartialOrd>(of: &[T; 3]) -> [usize; 2] {
    let first = |is_better: fn(&T, &T) -> bool| {
        (1..3).fold(0, |best, at| if is_better(&of[at], &of[best]) { at } else { best })
    };
    [first(|one, best| one < best), first(|one, best| one > best)]
}

/// The squared length of a triangle's shortest edge, in doubles.
pub(super) fn shortest_square(triangle: [Point; 3]) -> f64 {
    Rounded::of(triangle).squares.into_iter().fold(f64::INFINITY, f64::min)
}

/// Which way the front of one triangle turns away from that of another: positive if by less than a right angle, zero also
/// where one has no area.
///
/// *Cost*: constant; whole numbers of any size where doubles leave a doubt.
pub fn agreement(one: [Point; 3], other: [Point; 3]) -> Sign {
    let rounded = [one, other].map(Rounded::of);
    let size: f64 = rounded.iter().map(|triangle| triangle.squares.into_iter().fold(0.0, f64::max)).product();
    let product = dot(rounded[0].normal, rounded[1].normal);
    let are_in_range = rounded.iter().flat_map(|triangle| triangle.squares).all(|square| square < 1e70);
    if are_in_range && size > 1e-140 && product.abs() > 8.0 * ERROR * size {
        return Sign::of(product);
    }
    let [one, other] = exact_normals(one, other);
    Sign::from(&integers::dot(&one, &other))
}

/// How the areas of two triangles compare.
pub(super) fn compare_areas(one: [Point; 3], other: [Point; 3]) -> Ordering {
    let rounded = [one, other].map(Rounded::of);
    let [a, b] = rounded.each_ref().map(|triangle| dot(triangle.normal, triangle.normal).sqrt());
    let longest = rounded.iter().flat_map(|triangle| triangle.squares).fold(0.0, f64::max);
    if is_in_range(longest) && (a - b).abs() > 4.0 * ERROR * longest {
        return if a < b { Ordering::Less } else { Ordering::Greater };
    }
    let squares = exact_normals(one, other).map(|normal| integers::dot(&normal, &normal));
    squares[0].cmp(&squares[1])
}

/// Whether a triangle has no area.
pub(super) fn is_flat(triangle: [Point; 3]) -> bool {
    crate::exact::are_collinear(triangle)
}

/// The squares of a triangle's edges, and its normal, in doubles.
struct Rounded {
    squares: [f64; 3],
    normal: Point,
}

impl Rounded {
    fn of([a, b, c]: [Point; 3]) -> Self {
        let sides = [minus(b, a), minus(c, b), minus(a, c)];
        Rounded { squares: sides.map(|side| dot(side, side)), normal: cross(sides[0], sides[1]) }
    }
}

/// The normals of two triangles, times one number.
fn exact_normals([a, b, c]: [Point; 3], [d, e, f]: [Point; 3]) -> [[BigInt; 3]; 2] {
    let [a, b, c, d, e, f] = integer_points([a, b, c, d, e, f]);
    let normal = |a, b, c| integers::cross(&integers::minus(b, a), &integers::minus(c, a));
    [normal(&a, &b, &c), normal(&d, &e, &f)]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SCALES: [f64; 5] = [1.0, 5e-324, 5e-324 * 1048576.0, 1.157920892373162e77, 5.617791046444737e306];

    #[test]
    fn lengths_and_heights_are_told_at_any_scale() {
        for scale in SCALES {
            let at = |x: f64, y: f64, z: f64| [x * scale, y * scale, z * scale];
            assert!(are_within(at(1.0, 2.0, 0.0), at(4.0, 6.0, 0.0), 5.0 * scale), "{scale}");
            assert!(!are_within(at(1.0, 2.0, 0.0), at(4.0, 6.0, 1.0), 5.0 * scale), "{scale}");
            let triangle = [at(0.0, 0.0, 0.0), at(16.0, 0.0, 0.0), at(5.0, 3.0, 0.0)];
            assert!(is_no_higher(triangle, 3.0 * scale) && !is_no_higher(triangle, 2.0 * scale), "{scale}");
            assert_eq!(extreme_sides(triangle), [2, 0]);
        }
        assert!(are_within([1.0; 3], [1.0; 3], 0.0) && !are_within([0.0; 3], [5e-324, 0.0, 0.0], 0.0));
        assert!(!is_no_higher([[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-200, 0.0]], 0.0));
    }

    #[test]
    fn of_equal_sides_the_first_counts() {
        let equal = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(extreme_sides(equal), [0, 0]);
        let [a, b, _] = equal;
        assert_eq!(extreme_sides([b, a, [0.0; 3]]), [1, 0]);
        assert_eq!(extreme_sides([a, [0.0; 3], b]), [0, 2]);
    }

    #[test]
    fn fronts_and_areas_are_told_at_any_scale() {
        for scale in SCALES {
            let at = |x: f64, y: f64, z: f64| [x * scale, y * scale, z * scale];
            let flat = [at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0)];
            let upright = [at(0.0, 0.0, 0.0), at(0.0, 1.0, 0.0), at(0.0, 0.0, 2.0)];
            let leaning = [at(0.0, 0.0, 0.0), at(2.0, 0.0, 2.0), at(0.0, 1.0, 0.0)];
            assert_eq!(agreement(flat, upright), Sign::Zero, "{scale}");
            assert_eq!(agreement(flat, leaning), Sign::Positive, "{scale}");
            assert_eq!(agreement([flat[0], flat[2], flat[1]], leaning), Sign::Negative, "{scale}");
            assert_eq!(compare_areas(flat, upright), Ordering::Less, "{scale}");
            assert_eq!(compare_areas(flat, [flat[0], flat[2], flat[1]]), Ordering::Equal, "{scale}");
        }
    }
}
