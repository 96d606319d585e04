//! Whether a triangle lies between two points that differ along one axis: exact, and never undecided.
//!
//! A point counts as moved by (ε, ε², ε³) for a sufficiently small ε. So it lies on no triangle, and no line through it
//! along an axis meets a side of one. The answers for a triangle and for its neighbours then agree, and the crossings of
//! a closed surface add up. *Source*: H. Edelsbrunner, E. Mücke, *Simulation of
//! simplicity*, 1990.

use robust::{Coord, Coord3D, orient2d, orient3d};

use meshmend_geometry::vector::{Point, cross, dot, length, minus};

/// Three points, in the direction in which a surface is seen counter-clockwise.
pub(super) type Triangle = [Point; 3];

/// A point is on a triangle if its distance is at most this, in parts of its distances from the corners.
const ON: f64 = 1e-9;

/// By how much one triangle changes the winding of its surface on the way from a point to where one of its coordinates has
/// another value.
pub(super) fn crossing(triangle: &Triangle, from: Point, axis: usize, to: f64) -> i32 {
    if !passes_through(triangle, from, axis) {
        return 0;
    }
    let mut end = from;
    end[axis] = to;
    match (is_in_front(triangle, from), is_in_front(triangle, end)) {
        (true, false) => 1,
        (false, true) => -1,
        _ => 0,
    }
}

/// Whether the line through a point along an axis meets a triangle.
fn passes_through(triangle: &Triangle, point: Point, axis: usize) -> bool {
    let others = [[1, 2], [0, 2], [0, 1]][axis];
    let flat = |p: Point| Coord { x: p[others[0]], y: p[others[1]] };
    let (at, corners) = (flat(point), triangle.map(flat));
    let mut turns = 0;
    for place in 0..3 {
        let (one, other) = (corners[place], corners[(place + 1) % 3]);
        // At equal heights the point counts as higher; on a rising side it counts as to the right of it.
        if one.y <= at.y && other.y > at.y {
            turns += i32::from(orient2d(one, other, at) > 0.0);
        } else if one.y > at.y && other.y <= at.y {
            turns -= i32::from(orient2d(one, other, at) < 0.0);
        }
    }
    turns != 0
}

/// Whether a point lies on that side of a triangle's plane from which it is seen counter-clockwise.
fn is_in_front(triangle: &Triangle, point: Point) -> bool {
    let space = |p: Point| Coord3D { x: p[0], y: p[1], z: p[2] };
    let [a, b, c] = triangle.map(space);
    let above = -orient3d(a, b, c, space(point));
    if above != 0.0 {
        return above > 0.0;
    }
    // The first part of the normal that is not zero decides.
    let normal = [[1, 2], [2, 0], [0, 1]].into_iter().map(|[x, y]| {
        let [a, b, c] = triangle.map(|p| Coord { x: p[x], y: p[y] });
        orient2d(a, b, c)
    });
    normal.into_iter().find(|&part| part != 0.0).is_some_and(|part| part > 0.0)
}

/// Whether a point is on a triangle, within the precision of doubles.
pub(super) fn is_on(triangle: &Triangle, point: Point) -> bool {
    let [a, b, c] = triangle.map(|corner| minus(corner, point));
    solid_angle(a, b, c).is_none()
}

/// The solid angle that a triangle fills, seen from the origin. Returns `None` if the origin is on it. *Source*: A. Van
/// Oosterom, J. Strackee, *The solid angle of a plane triangle*, 1983.
pub(super) fn solid_angle(a: Point, b: Point, c: Point) -> Option<f64> {
    let (x, y, z) = (length(a), length(b), length(c));
    let volume = dot(a, cross(b, c));
    let facing = x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y;
    let on = ON * x * y * z;
    (volume.abs() > on || facing > on).then(|| 2.0 * volume.atan2(facing))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn an_octant_is_an_eighth_of_the_sphere_however_far_its_corners_are() {
        let [a, b, c] = [[2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 5.0]];
        assert!((solid_angle(a, b, c).unwrap() - PI / 2.0).abs() < 1e-12);
        assert!((solid_angle(b, a, c).unwrap() + PI / 2.0).abs() < 1e-12);
    }

    /// A regular tetrahedron, seen from places near one corner and another, and from outside.
    #[test]
    fn the_faces_round_a_point_make_up_a_whole_sphere_and_those_beside_it_nothing() {
        let corners = [[1.0; 3], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        let seen_from = |point: Point| -> f64 {
            let [a, b, c, d] = corners.map(|corner| minus(corner, point));
            [[a, b, c], [a, c, d], [a, d, b], [b, d, c]]
                .map(|[a, b, c]| solid_angle(a, b, c).unwrap())
                .iter()
                .sum()
        };
        for (point, whole) in
            [([0.0; 3], 1.0), ([0.7, 0.6, 0.7], 1.0), ([0.5, -0.6, -0.4], 1.0), ([1.1; 3], 0.0)]
        {
            let seen = seen_from(point).abs();
            assert!((seen - whole * 4.0 * PI).abs() < 1e-9, "{point:?}: {seen}");
        }
    }

    #[test]
    fn what_is_on_a_triangle_sees_no_angle_and_what_is_in_its_plane_an_empty_one() {
        let corners = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let seen_from = |point: Point| {
            let [a, b, c] = corners.map(|corner| minus(corner, point));
            solid_angle(a, b, c)
        };
        for on in [[1.0, 1.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0; 3]] {
            assert_eq!(seen_from(on), None, "{on:?}");
        }
        assert_eq!(seen_from([3.0, 3.0, 0.0]), Some(0.0));
        assert!((seen_from([1.0, 1.0, 1e-6]).unwrap().abs() - 2.0 * PI).abs() < 1e-5);
    }
}
