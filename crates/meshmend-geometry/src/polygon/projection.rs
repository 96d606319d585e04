//! A polygon in space as it is seen in a plane.

use super::corners::Polygon;
use crate::vector::{Point, cross, dot, minus};

/// The points without the coordinate in which the normal is largest, exactly; they run round the polygon's inside
/// anticlockwise.
pub(super) fn seen_along_an_axis(polygon: Polygon<'_>, normal: Point) -> Option<Vec<[f64; 2]>> {
    let size = normal.map(f64::abs);
    let dropped = if size[2] >= size[0] && size[2] >= size[1] { 2 } else { usize::from(size[1] >= size[0]) };
    let (x, y) = ((dropped + 1) % 3, (dropped + 2) % 3);
    let (x, y) = if normal[dropped] < 0.0 { (y, x) } else { (x, y) };
    // A zero has one sign.
    all_finite(polygon.points.iter().map(|point| [point[x] + 0.0, point[y] + 0.0]))
}

/// The points as the polygon's area vector sees them, rounded; they run round the polygon's inside anticlockwise.
pub(super) fn seen_along_the_normal(polygon: Polygon<'_>, normal: Point) -> Option<Vec<[f64; 2]>> {
    let &origin = polygon.points.first()?;
    let least = if normal[0].abs() <= normal[1].abs().min(normal[2].abs()) {
        0
    } else {
        1 + usize::from(normal[2].abs() < normal[1].abs())
    };
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let unit = |v: Point| v.map(|x| x / dot(v, v).sqrt());
    let right = unit(cross(axis, unit(normal)));
    let up = cross(unit(normal), right);
    let seen = polygon.points.iter().map(|&point| minus(point, origin));
    all_finite(seen.map(|point| [dot(point, right) + 0.0, dot(point, up) + 0.0]))
}

fn all_finite(points: impl Iterator<Item = [f64; 2]>) -> Option<Vec<[f64; 2]>> {
    let points: Vec<[f64; 2]> = points.collect();
    points.iter().flatten().all(|x| x.is_finite()).then_some(points)
}
