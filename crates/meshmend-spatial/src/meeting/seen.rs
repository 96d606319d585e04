//! Triangles that are seen at a look to have nothing but their common corners in common: by sums in doubles that leave no
//! doubt. Most pairs of neighbours are such.

use meshmend_geometry::vector::{Point, cross, dot, minus};

use super::Pair;
use crate::exact::Axis;
use crate::surface::Cell;

/// The size of a rounding, relative to the result.
const ROUNDING: f64 = f64::EPSILON / 2.0;
/// Far above what underflow may lose.
const UNDERFLOW: f64 = f64::MIN_POSITIVE * 1e20;

type Seen = [f64; 2];

impl Pair<'_> {
    /// Whether it is seen that the triangles have nothing but their common corners in common, of which there are two at most.
    /// The size is that of the longest side of their boxes, which overlap.
    ///
    /// *Cost*: some nanoseconds.
    #[inline]
    pub(crate) fn is_seen_to_be_proper(&self, size: f64) -> bool {
        match self.shared[0] {
            0 => self.is_seen_apart(size),
            0b001 | 0b010 | 0b100 => {
                self.has_plane_through_corner(size) || self.has_line_through_corner(size)
            }
            0b011 | 0b101 | 0b110 => self.has_plane_through_side(size),
            _ => false,
        }
    }

    /// Whether the triangles, which have one common corner, lie on opposite sides of a certain plane through it.
    #[inline]
    fn has_plane_through_corner(&self, size: f64) -> bool {
        // The terms together are at most as large as the product; five roundings are in each.
        const ERROR: f64 = 6.0 * ROUNDING;
        let [f, g] = self.points;
        let common = f[self.shared[0].trailing_zeros() as usize % 3];
        let ([a, b, c], [p, q, r]) = (f, g);
        let (a, b, c) = (minus(*a, common), minus(*b, common), minus(*c, common));
        let (p, q, r) = (minus(*p, common), minus(*q, common), minus(*r, common));
        // Any plane would do. This one is likely to lie between them.
        let along = |i: usize| a[i] + b[i] + c[i] - (p[i] + q[i] + r[i]);
        let normal = [along(0), along(1), along(2)];
        let steepest = normal[0].abs() + normal[1].abs() + normal[2].abs();
        let bound = ERROR * (size * steepest) + UNDERFLOW;
        let above = bits([dot(normal, a) > bound, dot(normal, b) > bound, dot(normal, c) > bound]);
        let below = bits([dot(normal, p) < -bound, dot(normal, q) < -bound, dot(normal, r) < -bound]);
        (above | self.shared[0]) & (below | self.shared[1]) == 0b111
    }

    /// The same, of lines along a side instead of planes: as they are seen along an axis.
    #[inline(never)]
    fn has_line_through_corner(&self, size: f64) -> bool {
        let [f, g] = self.points;
        let ([from, a, b], [_, c, d]) = (turned(f, self.shared[0]), turned(g, self.shared[1]));
        let axis = axis_of(f);
        let to = |corner: Point| difference(axis.seen(corner), axis.seen(from));
        let (a, b, c, d) = (to(a), to(b), to(c), to(d));
        let bound = error(size);
        let (ab, cd) = (product(a, b), product(c, d));
        let (ac, ad, bc, bd) = (product(a, c), product(a, d), product(b, c), product(b, d));
        let splits = |others: [f64; 2], own: f64| {
            (others[0] > bound && others[1] > bound && own < -bound)
                || (others[0] < -bound && others[1] < -bound && own > bound)
        };
        splits([ac, ad], ab) || splits([bc, bd], -ab) || splits([-ac, -bc], cd) || splits([-ad, -bd], -cd)
    }

    /// Whether the triangles, which have a common side, lie on opposite sides of a plane through it.
    #[inline]
    fn has_plane_through_side(&self, size: f64) -> bool {
        // Each of three terms is at most four times the fourth power of the size; eleven roundings are in it.
        const ERROR: f64 = 3.0 * 4.0 * 12.0 * ROUNDING;
        let [p, from, to] = turned(self.points[0], !self.shared[0]);
        let [q, ..] = turned(self.points[1], !self.shared[1]);
        let (side, p, q) = (minus(to, from), minus(p, from), minus(q, from));
        let square = size * size;
        dot(cross(side, p), cross(side, q)) < -(ERROR * (square * square) + UNDERFLOW)
    }

    /// Whether the triangles, which have no common corner, are seen to lie on opposite sides of a line along a side.
    #[inline(never)]
    fn is_seen_apart(&self, size: f64) -> bool {
        let axis = axis_of(self.points[0]);
        let [f, g] = self.points.map(|triangle| triangle.map(|corner| axis.seen(corner)));
        // As far as that corners of both may be apart.
        let bound = error(2.0 * size);
        has_line_beside(f, g, bound) || has_line_beside(g, f, bound)
    }
}

/// Whether a side of the first triangle has all of the second one strictly beyond it.
#[inline]
fn has_line_beside(one: [Seen; 3], other: [Seen; 3], bound: f64) -> bool {
    let [a, b, c] = one;
    let area = product(difference(b, a), difference(c, a));
    let way = if area > 0.0 { 1.0 } else { -1.0 };
    let is_beyond = |from: Seen, to: Seen| {
        let side = difference(to, from);
        other.iter().all(|&corner| product(side, difference(corner, from)) * way < -bound)
    };
    area.abs() > bound && (is_beyond(a, b) || is_beyond(b, c) || is_beyond(c, a))
}

/// The axis along which a triangle is largest, within rounding.
#[inline]
fn axis_of([a, b, c]: &[Point; 3]) -> Axis {
    let [x, y, z] = cross(minus(*b, *a), minus(*c, *a)).map(f64::abs);
    if z >= x && z >= y {
        Axis::Z
    } else if x >= y {
        Axis::X
    } else {
        Axis::Y
    }
}

/// A triangle's corners from the first one of a cell on.
#[inline]
fn turned(&[a, b, c]: &[Point; 3], cell: Cell) -> [Point; 3] {
    match cell.trailing_zeros() {
        0 => [a, b, c],
        1 => [b, c, a],
        _ => [c, a, b],
    }
}

#[inline]
fn bits([a, b, c]: [bool; 3]) -> Cell {
    Cell::from(a) | Cell::from(b) << 1 | Cell::from(c) << 2
}

#[inline]
fn difference(p: Seen, q: Seen) -> Seen {
    [p[0] - q[0], p[1] - q[1]]
}

#[inline]
fn product(p: Seen, q: Seen) -> f64 {
    p[0] * q[1] - p[1] * q[0]
}

/// More than the error of a product of two differences of at most some size: it has two terms, and four roundings are in them.
#[inline]
fn error(size: f64) -> f64 {
    2.0 * 5.0 * ROUNDING * (size * size) + UNDERFLOW
}

#[cfg(test)]
mod tests {
    use meshmend_geometry::vector::place_bits;
    use proptest::prelude::*;

    use super::*;
    use crate::boxes::Bounds;
    use crate::exact::are_collinear;

    /// Coordinates of a small grid, or next to it.
    fn number() -> impl Strategy<Value = f64> {
        let near = |(whole, step): (i32, i32)| f64::from(whole) + f64::from(step) * f64::EPSILON;
        prop_oneof![3 => (-3..4_i32).prop_map(f64::from), 1 => (-3..4_i32, -2..3_i32).prop_map(near)]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]
        #[test]
        fn what_is_seen_is_so(
            points in prop::array::uniform6(prop::array::uniform3(number())),
            shared in 0..3_usize,
            is_flat in any::<bool>(),
            power in prop::sample::select(vec![0, 0, 0, -1072, -537, -300, -260, 250, 300, 1020]),
        ) {
            let scale = |x: f64| x * 2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2);
            let mut points = points.map(|[x, y, z]| [x, y, if is_flat { x - y } else { z }].map(scale));
            let common = [points[1], points[2]];
            points[3..3 + shared].copy_from_slice(&common[..shared]);
            let [f, g] = [[points[0], points[1], points[2]], [points[5], points[4], points[3]]];
            let boxes = [f, g].map(Bounds::of);
            let are_asked = boxes[0].overlaps(&boxes[1]) && ![f, g].into_iter().any(are_collinear);
            let pair = Pair::named([&f, &g], [f, g].map(|triangle| triangle.map(place_bits)));
            if are_asked && pair.is_seen_to_be_proper(boxes[0].size().max(boxes[1].size())) {
                let cells = pair.meeting().map_or([0; 2], |meeting| meeting.cells);
                prop_assert_eq!(cells, pair.shared);
            }
        }
    }

    #[test]
    fn neighbours_on_a_grid_are_seen_to_be_proper() {
        let at = |x: i32, y: i32| [f64::from(x), f64::from(y), f64::from(x * x + 3 * y)];
        let middle = [at(0, 0), at(1, 0), at(1, 1)];
        let beside = [
            [at(0, 0), at(1, 1), at(0, 1)],
            [at(1, 0), at(2, 0), at(2, 1)],
            [at(0, 0), at(-1, 0), at(-1, -1)],
            [at(1, 1), at(1, 2), at(2, 2)],
            [at(0, 2), at(1, 3), at(0, 3)],
        ];
        for other in beside {
            let pair =
                Pair::named([&middle, &other], [middle, other].map(|triangle| triangle.map(place_bits)));
            assert!(pair.is_seen_to_be_proper(6.0), "{other:?}");
        }
    }
}
