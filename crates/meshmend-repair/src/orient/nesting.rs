//! Which closed patches lie inside an odd number of others: the walls of hollows.
//!
//! A patch lies inside another one when the other one winds round a point of it. *Source*: A. Van Oosterom,
//! J. Strackee, *The solid angle of a plane triangle*, 1983.

use meshmend_core::{Column, Connectivity, FaceId, PolygonMesh};

use crate::vector::{Point, cross, dot, length, minus};

/// For each closed patch, its faces flipped where that is chosen, whether it lies inside an odd number of the others.
///
/// *Cost*: for each pair of patches whose boxes allow it, the faces of the outer one.
pub(super) fn are_hollows<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    patches: &[Vec<FaceId>],
    is_flipped: &Column<FaceId, bool>,
) -> Vec<bool> {
    let shells: Vec<Shell> = patches.iter().map(|faces| Shell::of(kernel, mesh, faces)).collect();
    let lies_in = |inner: &Shell, outer: &Shell| {
        outer.box_holds(inner.inside_point)
            && outer.winding(kernel, mesh, is_flipped, inner.inside_point).abs() > 0.5
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
    /// The centre of the first face: on the shell, and rarely on another one.
    inside_point: Point,
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
        let first = faces
            .first()
            .map(|&face| kernel.face_vertices(face).map(|v| mesh.position(v)).collect::<Vec<_>>());
        let corners = first.unwrap_or_default();
        let share = 1.0 / corners.len().max(1) as f64;
        let inside_point = std::array::from_fn(|i| corners.iter().map(|p| p[i] * share).sum());
        Shell { faces, low, high, inside_point }
    }

    fn box_holds(&self, point: Point) -> bool {
        (0..3).all(|i| self.low[i] <= point[i] && point[i] <= self.high[i])
    }

    /// How often the shell winds round a point.
    fn winding<K: Connectivity>(
        &self,
        kernel: &K,
        mesh: &PolygonMesh,
        is_flipped: &Column<FaceId, bool>,
        point: Point,
    ) -> f64 {
        let mut angle = 0.0;
        for &face in self.faces {
            let mut corners = kernel.face_vertices(face).map(|v| minus(mesh.position(v), point));
            let (Some(first), Some(mut last)) = (corners.next(), corners.next()) else { continue };
            let way = if is_flipped[face] { -1.0 } else { 1.0 };
            for next in corners {
                angle += way * solid_angle(first, last, next);
                last = next;
            }
        }
        angle / (4.0 * std::f64::consts::PI)
    }
}

fn solid_angle(a: Point, b: Point, c: Point) -> f64 {
    let (x, y, z) = (length(a), length(b), length(c));
    let volume = dot(a, cross(b, c));
    2.0 * volume.atan2(x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn an_octant_is_an_eighth_of_the_sphere_however_far_its_corners_are() {
        let [a, b, c] = [[2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 5.0]];
        assert!((solid_angle(a, b, c) - PI / 2.0).abs() < 1e-12);
        assert!((solid_angle(b, a, c) + PI / 2.0).abs() < 1e-12);
    }

    /// A regular tetrahedron, seen from places near one corner and another, and from outside.
    #[test]
    fn the_faces_round_a_point_make_up_a_whole_sphere_and_those_beside_it_nothing() {
        let corners = [[1.0; 3], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        let seen_from = |point: Point| -> f64 {
            let [a, b, c, d] = corners.map(|corner| minus(corner, point));
            [[a, b, c], [a, c, d], [a, d, b], [b, d, c]].map(|[a, b, c]| solid_angle(a, b, c)).iter().sum()
        };
        for (point, whole) in
            [([0.0; 3], 1.0), ([0.7, 0.6, 0.7], 1.0), ([0.5, -0.6, -0.4], 1.0), ([1.1; 3], 0.0)]
        {
            assert!(
                (seen_from(point).abs() - whole * 4.0 * PI).abs() < 1e-9,
                "{point:?}: {}",
                seen_from(point)
            );
        }
    }
}
