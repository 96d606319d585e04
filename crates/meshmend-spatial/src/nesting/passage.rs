//! How a ray passes a triangle.

use meshmend_geometry::vector::Point;

use crate::exact::{
    Axis, Sign, are_collinear, compare_along, projection_of, side_of_plane, turn, turn_along,
};

/// How a ray from a point towards +z passes a triangle that the point does not lie on: positive if out through its front,
/// negative if in through it, zero if not at all.
///
/// The ray is moved by an infinitesimal (e, e²) in x and y, so that it meets no corner, no edge, and no face along the face.
///
/// *Cost*: that of four of [`turn`].
pub fn passage(point: Point, triangle: [Point; 3]) -> Sign {
    let seen = Axis::Z.seen(point);
    let [a, b, c] = triangle.map(|corner| Axis::Z.seen(corner));
    let turns = [turn(a, b, seen), turn(b, c, seen), turn(c, a, seen)];
    passage_of_turns(triangle, turns, || side_of_plane(triangle, point))
}

/// The same for a point whose place is known: which way each side of the triangle turns towards it, seen from +z, and on which
/// side of the triangle's plane it lies. So it need not be a point of doubles.
pub fn passage_of_turns(triangle: [Point; 3], turns: [Sign; 3], side: impl FnOnce() -> Sign) -> Sign {
    let [a, b, c] = triangle;
    let sides = [(a, b), (b, c), (c, a)];
    let mut moved = turns
        .into_iter()
        .zip(sides)
        .map(|(turn, (from, to))| if turn.is_zero() { turn_of_moved(from, to) } else { turn });
    let (Some(one), Some(two), Some(three)) = (moved.next(), moved.next(), moved.next()) else {
        return Sign::Zero;
    };
    if one.is_zero() || one != two || one != three {
        return Sign::Zero;
    }
    // It passes only what is above the point.
    if side() * one == Sign::Negative { one } else { Sign::Zero }
}

/// Which way a side turns towards a point on its line that is moved by the infinitesimal, seen from +z.
fn turn_of_moved(from: Point, to: Point) -> Sign {
    let first = Sign::of(from[1] - to[1]);
    if first.is_zero() { Sign::of(to[0] - from[0]) } else { first }
}

/// Whether a point lies on a triangle, its border included, also if it has no area.
///
/// *Cost*: that of [`side_of_plane`], and where the point is in the plane, of up to six of [`turn`].
pub fn lies_on(point: Point, triangle: [Point; 3]) -> bool {
    if !side_of_plane(triangle, point).is_zero() {
        return false;
    }
    let [a, b, c] = triangle;
    let sides = [[a, b], [b, c], [c, a]];
    match projection_of(triangle) {
        Some((axis, way)) => {
            sides.into_iter().all(|[from, to]| turn_along(axis, [from, to, point]) * way != Sign::Negative)
        }
        None => sides.into_iter().any(|side| is_between(point, side)),
    }
}

/// Whether a point lies on a segment, its ends included.
fn is_between(point: Point, [from, to]: [Point; 2]) -> bool {
    if from == to {
        return point == from;
    }
    are_collinear([from, to, point])
        && compare_along([from, to], point, from) != Sign::Negative
        && compare_along([from, to], point, to) != Sign::Positive
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRIANGLE: [Point; 3] = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 2.0, 1.0]];

    fn turned([a, b, c]: [Point; 3]) -> [Point; 3] {
        [a, c, b]
    }

    #[test]
    fn rays_pass_what_is_above_them_whichever_way_it_lies() {
        assert_eq!(passage([0.5, 0.5, 0.0], TRIANGLE), Sign::Positive);
        assert_eq!(passage([0.5, 0.5, 0.0], turned(TRIANGLE)), Sign::Negative);
        assert_eq!(passage([0.5, 0.5, 2.0], TRIANGLE), Sign::Zero);
        assert_eq!(passage([2.5, 0.5, 0.0], TRIANGLE), Sign::Zero);
    }

    #[test]
    fn of_two_triangles_that_share_a_side_one_is_passed() {
        let square: [Point; 4] = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 2.0, 1.0], [0.0, 2.0, 1.0]];
        let [a, b, c, d] = square;
        for halves in [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]] {
            for (point, passed) in [([1.0, 1.0, 0.0], 1), ([0.0, 1.0, 0.0], 1), ([0.0, 0.0, 0.0], 1)] {
                let count = halves.iter().filter(|&&half| passage(point, half) == Sign::Positive).count();
                assert_eq!(count, passed, "{point:?}");
            }
            for point in [[2.0, 1.0, 0.0], [2.0, 2.0, 0.0], [1.0, 2.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]]
            {
                assert!(halves.iter().all(|&half| passage(point, half).is_zero()), "{point:?}");
            }
        }
        let upright = TRIANGLE.map(|[x, y, z]| [x, z, y]);
        assert_eq!(passage([0.5, 1.0, -1.0], upright), Sign::Zero);
    }

    #[test]
    fn points_on_a_triangle_are_those_of_its_border_too() {
        let lie = |x: f64, y: f64| lies_on([x, y, 1.0], TRIANGLE) && lies_on([x, y, 1.0], turned(TRIANGLE));
        assert!(lie(0.5, 0.5) && lie(0.0, 0.0) && lie(1.0, 1.0) && !lie(1.5, 1.0) && !lie(-1.0, 0.0));
        assert!(!lies_on([0.5, 0.5, 1f64.next_up()], TRIANGLE));
        let flat = [[0.0; 3], [2.0, 2.0, 2.0], [1.0, 1.0, 1.0]];
        assert!(lies_on([1.5, 1.5, 1.5], flat) && !lies_on([2.5, 2.5, 2.5], flat));
        assert!(!lies_on([1.0, 1.0, 0.5], flat) && lies_on([1.0; 3], [[1.0; 3]; 3]));
    }
}
