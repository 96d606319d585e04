//! On which side of a plane or a line a point lies.

use meshmend_geometry::vector::Point;
use robust::{Coord, Coord3D, orient2d, orient3d};

use super::integers::{cross, dot, integer_points, integers, minus as integers_minus, small_integers};
use super::sign::Sign;

/// Below this an error of rounding is one of underflow as well. Far above what underflow may lose, far below all that
/// matters.
const UNDERFLOW: f64 = f64::MIN_POSITIVE * 1e20;
/// Of the determinant in space, relative to the sum of its terms' sizes. Four roundings are in a term of the normal, four
/// more follow; those of the sizes are of second order.
const ERROR_IN_SPACE: f64 = 12.0 * f64::EPSILON / 2.0;
/// Of the determinant in a plane, relative to the sum of its terms' sizes: three roundings, likewise.
const ERROR_IN_PLANE: f64 = 4.0 * f64::EPSILON / 2.0;

/// The plane of a triangle, ready to be asked about many points.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    triangle: [Point; 3],
    /// The triangle's normal, rounded.
    normal: Point,
    /// The sum of the sizes of the terms of each of its coordinates.
    size: Point,
}

impl Plane {
    /// That of a triangle.
    #[inline]
    pub fn of(triangle: [Point; 3]) -> Self {
        let [a, b, c] = triangle;
        let [bx, by, bz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let [cx, cy, cz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
        let left = [by * cz, bz * cx, bx * cy];
        let right = [bz * cy, bx * cz, by * cx];
        let normal = [left[0] - right[0], left[1] - right[1], left[2] - right[2]];
        let size = |i: usize| left[i].abs() + right[i].abs() + UNDERFLOW;
        Plane { triangle, normal, size: [size(0), size(1), size(2)] }
    }

    /// On which side of the plane a point lies: positive where the triangle is seen to run anticlockwise.
    ///
    /// *Cost*: constant; a few nanoseconds if the point is not nearly on the plane, about a hundred if it is, microseconds
    /// for coordinates whose products leave the range of doubles.
    #[inline]
    pub fn side(&self, point: Point) -> Sign {
        let a = self.triangle[0];
        let [x, y, z] = [point[0] - a[0], point[1] - a[1], point[2] - a[2]];
        let determinant = self.normal[0] * x + self.normal[1] * y + self.normal[2] * z;
        let size = self.size[0] * x.abs() + self.size[1] * y.abs() + self.size[2] * z.abs() + UNDERFLOW;
        if determinant.abs() > ERROR_IN_SPACE * size && size < f64::INFINITY {
            return Sign::of(determinant);
        }
        exact_side(self.triangle, point)
    }
}

/// On which side of a triangle's plane a point lies: positive where the triangle is seen to run anticlockwise.
///
/// *Cost*: that of [`Plane::side`].
#[inline]
pub fn side_of_plane(triangle: [Point; 3], point: Point) -> Sign {
    Plane::of(triangle).side(point)
}

#[cold]
fn exact_side([a, b, c]: [Point; 3], point: Point) -> Sign {
    let all = [a, b, c, point];
    if (0..3).any(|axis| all.iter().all(|p| p[axis] == point[axis])) || [a, b, c].contains(&point) {
        return Sign::Zero;
    }
    if let Some(sign) = side_by_small_integers([a, b, c], point) {
        return sign;
    }
    if all.iter().flatten().all(|&x| is_moderate(x)) {
        let [a, b, c, point] = all.map(|[x, y, z]| Coord3D { x, y, z });
        return -Sign::of(orient3d(a, b, c, point));
    }
    side_by_integers([a, b, c], point)
}

/// The side, if the coordinates have so few digits that no product is beyond 128 bits; often so where points lie on the plane.
fn side_by_small_integers([a, b, c]: [Point; 3], p: Point) -> Option<Sign> {
    let [ax, ay, az, bx, by, bz, cx, cy, cz, px, py, pz] =
        small_integers([a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2], p[0], p[1], p[2]])?;
    let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
    let (bx, by, bz) = (bx - ax, by - ay, bz - az);
    let (cx, cy, cz) = (cx - ax, cy - ay, cz - az);
    let normal = [
        product(by, cz) - product(bz, cy),
        product(bz, cx) - product(bx, cz),
        product(bx, cy) - product(by, cx),
    ];
    let way = [px - ax, py - ay, pz - az].map(i128::from);
    let sum = normal[0] * way[0] + normal[1] * way[1] + normal[2] * way[2];
    Some(Sign::from(sum.cmp(&0)))
}

fn side_by_integers([a, b, c]: [Point; 3], point: Point) -> Sign {
    let [a, b, c, point] = integer_points([a, b, c, point]);
    let normal = cross(&integers_minus(&b, &a), &integers_minus(&c, &a));
    Sign::from(&dot(&normal, &integers_minus(&point, &a)))
}

/// Which way three points of a plane turn: positive if anticlockwise.
///
/// *Cost*: as that of [`side_of_plane`].
#[inline]
pub fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    let (left, right) = ((a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0]));
    let (determinant, size) = (left - right, left.abs() + right.abs() + UNDERFLOW);
    if determinant.abs() > ERROR_IN_PLANE * size && size < f64::INFINITY {
        return Sign::of(determinant);
    }
    exact_turn(a, b, c)
}

#[cold]
fn exact_turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    if let Some([ax, ay, bx, by, cx, cy]) = small_integers([a[0], a[1], b[0], b[1], c[0], c[1]]) {
        let product = |x: i64, y: i64| i128::from(x) * i128::from(y);
        return Sign::from(product(ax - cx, by - cy).cmp(&product(ay - cy, bx - cx)));
    }
    if [a, b, c].iter().flatten().all(|&x| is_moderate(x)) {
        let [a, b, c] = [a, b, c].map(|[x, y]| Coord { x, y });
        return Sign::of(orient2d(a, b, c));
    }
    turn_by_integers(a, b, c)
}

fn turn_by_integers(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    let [ax, ay, bx, by, cx, cy] = integers([a[0], a[1], b[0], b[1], c[0], c[1]]);
    let (left, right) = ((ax - &cx) * (by - &cy), (ay - cy) * (bx - cx));
    Sign::from(left.cmp(&right))
}

/// A coordinate's axis, along which points are seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first coordinate's.
    X,
    /// The second coordinate's.
    Y,
    /// The third coordinate's.
    Z,
}

impl Axis {
    /// All three.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// A point as it is seen from far out on the axis.
    #[inline]
    pub fn seen(self, [x, y, z]: Point) -> [f64; 2] {
        match self {
            Axis::X => [y, z],
            Axis::Y => [z, x],
            Axis::Z => [x, y],
        }
    }
}

/// Which way three points turn, seen from far out on an axis: the sign of that coordinate of the triangle's normal.
///
/// *Cost*: as that of [`side_of_plane`].
#[inline]
pub fn turn_along(axis: Axis, [a, b, c]: [Point; 3]) -> Sign {
    turn(axis.seen(a), axis.seen(b), axis.seen(c))
}

/// Whether products of three differences of such numbers, and the errors of these, are far within the range of doubles.
fn is_moderate(x: f64) -> bool {
    const LEAST: f64 = 1e-72;
    const GREATEST: f64 = 1e72;
    x == 0.0 || (LEAST..=GREATEST).contains(&x.abs())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Numbers of all kinds: small whole ones, those next to them, multiples of any power of two, and any bits at all.
    fn number() -> impl Strategy<Value = f64> {
        let whole = (-4..5_i32).prop_map(f64::from);
        let next = (-4..5_i32, -1..2_i64).prop_map(|(whole, step)| {
            f64::from_bits((f64::from(whole).to_bits() as i64 + step).unsigned_abs() & !(1 << 63))
        });
        let scaled = (-8..9_i32, -1074..1020_i32).prop_map(|(whole, power)| {
            f64::from(whole) * 2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2)
        });
        let any = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite());
        prop_oneof![4 => whole, 2 => next, 1 => scaled, 1 => any]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        #[test]
        fn signs_are_those_of_whole_numbers(
            points in prop::array::uniform4(prop::array::uniform3(number())),
            weights in prop::array::uniform2(0..3_u8),
        ) {
            let [a, b, c, mut point] = points;
            // Often nearly in the plane.
            if weights != [0, 0] {
                let [v, w] = weights.map(|weight| f64::from(weight) / 4.0);
                let near = std::array::from_fn(|i| a[i] + v * (b[i] - a[i]) + w * (c[i] - a[i]));
                if meshmend_geometry::vector::is_finite(&near) {
                    point = near;
                }
            }
            prop_assert_eq!(side_of_plane([a, b, c], point), side_by_integers([a, b, c], point));
            for axis in Axis::ALL {
                let [a, b, c] = [a, b, point].map(|point| axis.seen(point));
                prop_assert_eq!(turn(a, b, c), turn_by_integers(a, b, c));
            }
        }
    }

    #[test]
    fn sides_are_told_at_any_scale() {
        for scale in [1.0, 5e-324, 1e-320, 1e-200, 1e200, 8e307] {
            let point = |x: f64, y: f64, z: f64| [x * scale, y * scale, z * scale];
            let flat = [point(0.0, 0.0, 0.0), point(1.0, 0.0, 0.0), point(0.0, 1.0, 0.0)];
            assert_eq!(side_of_plane(flat, point(1.0, 1.0, 1.0)), Sign::Positive, "{scale}");
            assert_eq!(side_of_plane(flat, point(1.0, 1.0, -1.0)), Sign::Negative, "{scale}");
            assert_eq!(side_of_plane(flat, point(-2.0, 2.0, 0.0)), Sign::Zero, "{scale}");
            assert_eq!(turn([0.0, 0.0], [scale, 0.0], [scale, scale]), Sign::Positive, "{scale}");
            assert_eq!(turn([0.0, 0.0], [scale, scale], [2.0 * scale, 2.0 * scale]), Sign::Zero, "{scale}");
            assert_eq!(turn_along(Axis::Z, flat), Sign::Positive);
            assert_eq!(turn_along(Axis::X, flat), Sign::Zero);
        }
    }

    #[test]
    fn far_and_near_together_are_told_apart() {
        let plane = [[0.0, 0.0, 5e-324], [1e308, 0.0, 5e-324], [0.0, 1e308, 5e-324]];
        assert_eq!(side_of_plane(plane, [1e300, 1e300, 0.0]), Sign::Negative);
        assert_eq!(side_of_plane(plane, [1e300, 1e300, 5e-324]), Sign::Zero);
        assert_eq!(side_of_plane(plane, [1e300, 1e300, 1e-323]), Sign::Positive);
    }
}
