//! Which faces of a layout are flipped or collapsed: exactly, whatever rounding did.

use std::cmp::Ordering;

use meshmend_core::FaceId;
use robust::{Coord, orient2d};

/// The sign of a triangle's area.
pub(crate) fn orientation(triangle: &[u32; 3], points: &[[f64; 2]]) -> Ordering {
    let [a, b, c] = triangle.map(|node| points[node as usize]).map(|[x, y]| Coord { x, y });
    let area = orient2d(a, b, c);
    // Where a coordinate is not a number there is no sign, and no area.
    area.partial_cmp(&0.0).unwrap_or(Ordering::Equal)
}

/// The faces with a triangle of negative area, and those with one without area and none that is negative; ascending.
pub(crate) fn bad_faces(
    triangles: &[[u32; 3]],
    face_of: &[FaceId],
    points: &[[f64; 2]],
) -> (Vec<FaceId>, Vec<FaceId>) {
    let (mut flipped, mut collapsed): (Vec<FaceId>, Vec<FaceId>) = (Vec::new(), Vec::new());
    for (triangle, &face) in triangles.iter().zip(face_of) {
        match orientation(triangle, points) {
            Ordering::Greater => continue,
            Ordering::Less => flipped.push(face),
            Ordering::Equal => collapsed.push(face),
        }
    }
    flipped.dedup();
    collapsed.dedup();
    collapsed.retain(|face| flipped.binary_search(face).is_err());
    (flipped, collapsed)
}
