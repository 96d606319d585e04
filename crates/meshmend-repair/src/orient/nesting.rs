//! Which closed patches lie inside an odd number of others: the walls of hollows.
//!
//! A patch lies inside another one when the other one winds round a point of it; patches may touch, so a point that is
//! on both does not count. *Source*: A. Van Oosterom, J. Strackee, *The solid angle of a plane triangle*, 1983.

use meshmend_core::{Column, Connectivity, FaceId, PolygonMesh};
use meshmend_geometry::vector::{Point, cross, dot, length, minus};

/// So many points of a patch are tried, from faces spread evenly. One of which all are on another patch counts as
/// outside of it.
const MOST_POINTS: usize = 16;

/// What a point's distance from a triangle may be, in parts of its distances from the corners, for it to be on it.
const ON: f64 = 1e-9;

/// For each closed patch, its faces flipped where that is chosen, whether it lies inside an odd number of the others.
///
/// *Cost*: for each pair of patches whose boxes allow it, the faces of the outer one; where they touch, up to 16 times.
pub(super) fn are_hollows<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    patches: &[Vec<FaceId>],
    is_flipped: &Column<FaceId, bool>,
) -> Vec<bool> {
    let shells: Vec<Shell> = patches.iter().map(|faces| Shell::of(kernel, mesh, faces)).collect();
    let lies_in = |inner: &Shell, outer: &Shell| {
        let answers = inner.points.iter().map(|&point| outer.holds(kernel, mesh, is_flipped, point));
        answers.flatten().next().unwrap_or(false)
    };
    let depth = |place: usize| {
        let others = shells.iter().enumerate().filter(|(other, _)| *other != place);
        others.filter(|(_, outer)| lies_in(&shells[place], outer)).count()
    };
    (0..shells.len()).map(|place| depth(place) % 2 == 1).collect()
}

struct Shell<'a> {
    faces: &'a [FaceId],
    low: Point,
    high: Point,
    /// The centres of some faces.
    points: Vec<Point>,
}

impl<'a> Shell<'a> {
    fn of<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, faces: &'a [FaceId]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &face in faces {
            for point in kernel.face_vertices(face).map(|v| mesh.position(v)) {
                low = std::array::from_fn(|i| low[i].min(point[i]));
                high = std::array::from_fn(|i| high[i].max(point[i]));
            }
        }
        let centre = |face: FaceId| -> Point {
            let corners: Vec<Point> = kernel.face_vertices(face).map(|v| mesh.position(v)).collect();
            let share = 1.0 / corners.len() as f64;
            std::array::from_fn(|i| corners.iter().map(|p| p[i] * share).sum())
        };
        let stride = faces.len() / MOST_POINTS + 1;
        let points = faces.iter().step_by(stride).map(|&face| centre(face)).collect();
        Shell { faces, low, high, points }
    }

    /// Whether the shell winds round a point; nothing for a point on it.
    fn holds<K: Connectivity>(
        &self,
        kernel: &K,
        mesh: &PolygonMesh,
        is_flipped: &Column<FaceId, bool>,
        point: Point,
    ) -> Option<bool> {
        if !self.box_holds(point) {
            return Some(false);
        }
        Some(self.winding(kernel, mesh, is_flipped, point)?.abs() > 0.5)
    }

    fn box_holds(&self, point: Point) -> bool {
        (0..3).all(|i| self.low[i] <= point[i] && point[i] <= self.high[i])
    }

    /// How often the shell winds round a point; nothing for a point on it.
    fn winding<K: Connectivity>(
        &self,
        kernel: &K,
        mesh: &PolygonMesh,
        is_flipped: &Column<FaceId, bool>,
        point: Point,
    ) -> Option<f64> {
        let mut angle = 0.0;
        for &face in self.faces {
            let mut corners = kernel.face_vertices(face).map(|v| minus(mesh.position(v), point));
            let (Some(first), Some(mut last)) = (corners.next(), corners.next()) else { continue };
            let way = if is_flipped[face] { -1.0 } else { 1.0 };
            for next in corners {
                angle += way * solid_angle(first, last, next)?;
                last = next;
            }
        }
        Some(angle / (4.0 * std::f64::consts::PI))
    }
}

/// The solid angle that a triangle fills, seen from the origin; nothing where that is on it.
fn solid_angle(a: Point, b: Point, c: Point) -> Option<f64> {
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
