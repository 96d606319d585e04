//! The mean of a triangle's corners, which need not be a point of doubles.

use meshmend_geometry::vector::Point;

use super::integers::{IntegerPoint, cross, dot, integer_points, minus};
use super::sides::Axis;
use super::sign::Sign;

/// The point in the middle of a triangle: the mean of its corners.
#[derive(Clone, Copy, Debug)]
pub struct Centroid {
    corners: [Point; 3],
}

impl Centroid {
    /// That of a triangle.
    pub fn of(corners: [Point; 3]) -> Self {
        Centroid { corners }
    }

    /// On which side of a triangle's plane it lies: positive where the triangle is seen to run anticlockwise.
    ///
    /// *Cost*: microseconds.
    pub fn side_of_plane(&self, triangle: [Point; 3]) -> Sign {
        let [centroid, a, b, c] = self.threefold(triangle);
        let normal = cross(&minus(&b, &a), &minus(&c, &a));
        Sign::from(&dot(&normal, &minus(&centroid, &a)))
    }

    /// Which way each side of a triangle turns towards it, seen from far out on an axis.
    ///
    /// *Cost*: microseconds.
    pub fn turns_along(&self, axis: Axis, triangle: [Point; 3]) -> [Sign; 3] {
        let [centroid, a, b, c] = self.threefold(triangle);
        [(&a, &b), (&b, &c), (&c, &a)].map(|(from, to)| {
            let [_, x, y] = match axis {
                Axis::X => [0, 1, 2],
                Axis::Y => [1, 2, 0],
                Axis::Z => [2, 0, 1],
            };
            let (left, right) = (
                (&to[x] - &from[x]) * (&centroid[y] - &from[y]),
                (&to[y] - &from[y]) * (&centroid[x] - &from[x]),
            );
            Sign::from(left.cmp(&right))
        })
    }

    /// The centroid and a triangle's corners, all coordinates times three and a power of two.
    fn threefold(&self, [a, b, c]: [Point; 3]) -> [IntegerPoint; 4] {
        let [p, q, r] = self.corners;
        let [p, q, r, a, b, c] = integer_points([p, q, r, a, b, c]);
        let sum = [&p[0] + &q[0] + &r[0], &p[1] + &q[1] + &r[1], &p[2] + &q[2] + &r[2]];
        let [a, b, c] = [a, b, c].map(|corner| corner.map(|x| x * 3));
        [sum, a, b, c]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_a_triangle_is_where_it_is() {
        let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 1.0]];
        let centroid = Centroid::of(triangle);
        assert_eq!(centroid.side_of_plane(triangle), Sign::Zero);
        assert_eq!(centroid.turns_along(Axis::Z, triangle), [Sign::Positive; 3]);
        let third = [[0.0, 0.0, 1.0 / 3.0], [1.0, 0.0, 1.0 / 3.0], [0.0, 1.0, 1.0 / 3.0]];
        // A third in doubles is less than a third.
        assert_eq!(centroid.side_of_plane(third), Sign::Positive);
    }
}
