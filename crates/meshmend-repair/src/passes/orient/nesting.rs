//! Which closed patches lie inside an odd number of others: those are the walls of hollows.
//!
//! A patch lies inside another one if that one winds round a point of it. Patches may touch: a point that is on both does
//! not count, and another point is tried.

use meshmend_core::{Connectivity, FaceId, PolygonMesh};

use super::fates::Fates;
use super::winding::{Query, Shell, Windings};
use meshmend_geometry::vector::Point;

/// How many points of a patch are tried, from faces spread evenly. A patch counts as outside of another one if all of them
/// are on that one.
const MOST_POINTS: usize = 16;

/// For each closed patch, whether it lies inside an odd number of the others. Faces are taken as they are flipped.
///
/// *Cost*: O(n log n) for n faces of patches that lie apart from each other or one in the other, and for each point of a
/// patch the faces close to it; for each pair of patches that touch, up to 16 times.
pub(super) fn are_hollows<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    patches: &[&[FaceId]],
    fates: &Fates,
) -> Vec<bool> {
    let shells: Vec<Shell> = patches.iter().map(|faces| shell(kernel, mesh, faces, fates)).collect();
    let points: Vec<Vec<Point>> = patches.iter().map(|faces| points_on(kernel, mesh, faces)).collect();
    are_inside_oddly_many(&shells, &points)
}

/// The same for shells, with some points on each.
fn are_inside_oddly_many(shells: &[Shell], points: &[Vec<Point>]) -> Vec<bool> {
    let everything: Vec<&Shell> = shells.iter().collect();
    let first = |place: usize| {
        let &point = points[place].first()?;
        Some(Query { point, own: Some(place as u32) })
    };
    let asked: Vec<usize> = (0..shells.len()).filter(|&place| first(place).is_some()).collect();
    let queries: Vec<Query> = asked.iter().filter_map(|&place| first(place)).collect();
    let mut depths = vec![0; shells.len()];
    // Pairs that touch where they were asked: the outer one first.
    let mut open: Vec<(u32, u32)> = Vec::new();
    for (&place, answer) in asked.iter().zip(Windings::of(&everything, &queries)) {
        depths[place] = answer.inside;
        open.extend(answer.touching.into_iter().map(|outer| (outer, place as u32)));
    }
    for turn in 1..MOST_POINTS {
        open.retain(|&(_, inner)| turn < points[inner as usize].len());
        open.sort_unstable();
        let mut left = Vec::new();
        for pairs in open.chunk_by(|one, other| one.0 == other.0) {
            let ask = |&(_, inner): &(u32, u32)| Query { point: points[inner as usize][turn], own: None };
            let queries: Vec<Query> = pairs.iter().map(ask).collect();
            let answers = Windings::of(&[&shells[pairs[0].0 as usize]], &queries);
            for (&pair, answer) in pairs.iter().zip(answers) {
                depths[pair.1 as usize] += answer.inside;
                left.extend((!answer.touching.is_empty()).then_some(pair));
            }
        }
        open = left;
    }
    depths.into_iter().map(|depth| depth % 2 == 1).collect()
}

/// The triangles of a patch's faces, each face cut from its first corner.
fn shell<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, faces: &[FaceId], fates: &Fates) -> Shell {
    let mut triangles = Vec::with_capacity(faces.len());
    for &face in faces {
        let mut corners = kernel.face_vertices(face).map(|v| mesh.position(v));
        let (Some(first), Some(mut last)) = (corners.next(), corners.next()) else { continue };
        for next in corners {
            triangles.push(if fates.is_flipped(face) { [first, next, last] } else { [first, last, next] });
            last = next;
        }
    }
    Shell::of(triangles)
}

/// The centres of some faces, to the bit the same whichever way round these run.
fn points_on<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, faces: &[FaceId]) -> Vec<Point> {
    let centre = |face: FaceId| -> Point {
        let mut vertices: Vec<_> = kernel.face_vertices(face).collect();
        vertices.sort_unstable();
        let corners: Vec<Point> = vertices.into_iter().map(|v| mesh.position(v)).collect();
        let share = 1.0 / corners.len() as f64;
        std::array::from_fn(|i| corners.iter().map(|p| p[i] * share).sum())
    };
    let stride = faces.len() / MOST_POINTS + 1;
    faces.iter().step_by(stride).map(|&face| centre(face)).collect()
}

#[cfg(test)]
mod tests;
