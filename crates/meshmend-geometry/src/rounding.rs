//! What becomes of a mesh whose coordinates are stored in single precision.

use meshmend_core::{Id, PolygonMesh};

use crate::coincident::each_shared_place;
use crate::vector::{Point, area_vector, cross, dot, minus, place_bits};

/// What rounding to single precision does to the faces of a mesh and the vertices that they use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rounding {
    /// How many vertices move.
    pub moved: usize,
    /// How many vertices come to be where a lower one is, and were not before.
    pub joined: usize,
    /// How many faces had an area and have none any more, or leave the range of single precision.
    pub emptied: usize,
}

/// The mesh with positions in single precision, and what that does to its faces of three corners or more; nothing
/// where they are already.
///
/// *Cost*: linear where nothing moves; else n log n.
pub fn in_single_precision(mesh: &PolygonMesh) -> Option<(PolygonMesh, Rounding)> {
    if mesh.shared_places().is_some_and(|shared| !shared.points().iter().any(|point| is_moved(*point))) {
        return None;
    }
    let rounded = rounded_to_single(mesh.positions())?;
    let faces = mesh.faces();
    let corners = |face| faces.face_vertices(face).iter().map(|vertex| vertex.index());
    let large = faces.faces().filter(|&face| faces.corner_range(face).len() > 2).map(corners);
    let rounding = Rounding::of(mesh.positions(), &rounded, large);
    // There are as many positions as before.
    let mesh = mesh.clone().with_positions(rounded).ok()?;
    Some((mesh, rounding))
}

/// The points in single precision; `None` where they are already.
///
/// *Cost*: linear; memory where a point moves.
fn rounded_to_single(points: &[Point]) -> Option<Vec<Point>> {
    let first = points.iter().position(|point| is_moved(*point))?;
    let mut rounded = points.to_vec();
    rounded[first..].iter_mut().for_each(|point| *point = point.map(|x| f64::from(x as f32)));
    Some(rounded)
}

impl Rounding {
    /// What moving points to rounded ones does to these faces, each of which lists its vertices.
    ///
    /// *Cost*: n log n.
    fn of(
        points: &[Point],
        rounded: &[Point],
        faces: impl Iterator<Item = impl Iterator<Item = usize> + Clone>,
    ) -> Self {
        let is_moved: Vec<bool> = points.iter().map(|&point| is_moved(point)).collect();
        let mut is_used = vec![false; points.len()];
        let mut emptied = 0;
        for face in faces {
            face.clone().for_each(|vertex| is_used[vertex] = true);
            let is_touched = face.clone().any(|vertex| is_moved[vertex]);
            let has_area = |points: &[Point]| has_area(face.clone().map(|vertex| points[vertex]));
            emptied += usize::from(is_touched && has_area(points) && !has_area(rounded));
        }
        let moved = is_used.iter().zip(&is_moved).filter(|&(used, moved)| *used && *moved).count();
        Rounding { moved, joined: joined(&is_used, points, rounded), emptied }
    }
}

fn is_moved(point: Point) -> bool {
    point.iter().any(|&x| f64::from(x as f32) != x && !x.is_nan())
}

/// How many more vertices are where a lower one is after rounding than before.
fn joined(is_used: &[bool], points: &[Point], rounded: &[Point]) -> usize {
    let mut joined = 0;
    each_shared_place(
        rounded,
        |vertex| is_used[vertex],
        |vertices| {
            let mut before: Vec<[u64; 3]> =
                vertices.iter().map(|&vertex| place_bits(points[vertex])).collect();
            before.sort_unstable();
            before.dedup();
            joined += before.len() - 1;
        },
    );
    joined
}

/// Whether a polygon has an area vector that is neither zero nor beyond all numbers.
fn has_area(corners: impl Iterator<Item = Point> + Clone) -> bool {
    if has_clear_area(corners.clone()) {
        return true;
    }
    let Some(first) = corners.clone().next() else { return false };
    let spokes = corners.skip(1).map(|corner| minus(corner, first));
    let size = spokes.clone().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    if size == 0.0 || !spokes.clone().flatten().all(f64::is_finite) {
        return false;
    }
    // Measured by its size, so that no product overflows or vanishes.
    area_vector(std::iter::once([0.0; 3]).chain(spokes.map(|spoke| spoke.map(|x| x / size)))) != [0.0; 3]
}

/// Whether the area vector is so large beside the sides that no rounding could have made it. That is seen at a look,
/// and true of nearly all faces.
fn has_clear_area(mut corners: impl Iterator<Item = Point>) -> bool {
    const LEAST: f64 = 1e-16;
    let Some(first) = corners.next() else { return false };
    let (mut area, mut before, mut longest) = ([0.0; 3], [0.0; 3], 0.0_f64);
    for corner in corners {
        let spoke = minus(corner, first);
        let part = cross(before, spoke);
        area = [area[0] + part[0], area[1] + part[1], area[2] + part[2]];
        longest = longest.max(dot(spoke, spoke));
        before = spoke;
    }
    let is_plain = longest > 1e-60 && longest < 1e60;
    is_plain && dot(area, area) > LEAST * longest * longest
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rounding(points: &[Point], faces: &[[usize; 3]]) -> Option<Rounding> {
        let rounded = rounded_to_single(points)?;
        Some(Rounding::of(points, &rounded, faces.iter().map(|face| face.iter().copied())))
    }

    #[test]
    fn what_is_single_already_stays() {
        let points = [[0.5, -0.0, 2_f64.powi(100)], [f64::NAN, f64::INFINITY, 0.25]];
        assert_eq!(rounded_to_single(&points), None);
        assert_eq!(rounded_to_single(&[]), None);
    }

    /// A triangle of a centimetre far from the origin, one that stays, and one that leaves the range.
    #[test]
    fn what_is_joined_emptied_and_moved_is_counted_apart() {
        let far = 5_801_234.57;
        let points = [
            [far, 0.0, 0.0],
            [far + 0.01, 0.0, 0.0],
            [far, 0.01, 0.0],
            [0.1, 0.0, 0.0],
            [1e39, 0.0, 0.0],
            // Nothing uses it.
            [far, 1e-60, 0.0],
        ];
        let found = rounding(&points, &[[0, 1, 2], [0, 3, 2], [3, 2, 4], [3, 3, 2]]).unwrap();
        assert_eq!(found, Rounding { moved: 5, joined: 1, emptied: 2 });
    }

    #[test]
    fn what_was_equal_before_is_not_joined_by_rounding() {
        let points = [[0.1, 0.0, 0.0], [0.1, -0.0, 0.0], [0.1 + 1e-12, 0.0, 0.0], [0.0, 1.0, 0.0]];
        let found = rounding(&points, &[[0, 1, 3], [2, 1, 3]]).unwrap();
        assert_eq!(found, Rounding { moved: 3, joined: 1, emptied: 1 });
    }

    #[test]
    fn small_faces_have_an_area_however_small() {
        let tiny = |x: f64| [[0.0; 3], [x, 0.0, 0.0], [0.0, x, 0.0]];
        assert_eq!(rounding(&tiny(1e-44), &[[0, 1, 2]]).map(|found| found.emptied), Some(0));
        assert_eq!(rounding(&tiny(1e-300), &[[0, 1, 2]]).map(|found| found.emptied), Some(1));
    }
}
