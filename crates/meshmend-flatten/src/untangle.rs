//! The last few faces that rounding has flipped or collapsed, put right one node at a time.
//!
//! A node may be anywhere in the *kernel* of its star: where it sees every side of the polygon around it from inside.
//! The equations put it there. In a corner so narrow that doubles can't tell their solution from the outside, it may
//! be rounded out; the middle of the kernel is as far from all sides as can be. A node moves only if all triangles of
//! its star are then well oriented, by the exact test.

use std::cmp::Ordering;

use crate::orientation::orientation;

/// Rounds go on while each leaves fewer bad triangles than the one before, and at most this long.
const ROUNDS: usize = 64;

/// Moves nodes of bad triangles that `may_move` allows, in order, until none is bad or none gets better.
pub(crate) fn untangle(triangles: &[[u32; 3]], points: &mut [[f64; 2]], may_move: impl Fn(u32) -> bool) {
    let mut before = usize::MAX;
    for _ in 0..ROUNDS {
        let bad = |triangle: &&[u32; 3]| orientation(triangle, points) != Ordering::Greater;
        let bad: Vec<[u32; 3]> = triangles.iter().filter(bad).copied().collect();
        if bad.len() >= before {
            return;
        }
        before = bad.len();
        let mut nodes: Vec<u32> = bad.into_iter().flatten().filter(|&node| may_move(node)).collect();
        nodes.sort_unstable();
        nodes.dedup();
        if nodes.is_empty() {
            return;
        }
        let stars = stars(triangles, &nodes);
        for (&node, star) in nodes.iter().zip(&stars) {
            centre(node, star, points);
        }
    }
}

/// The triangles at each of some ascending nodes.
fn stars(triangles: &[[u32; 3]], nodes: &[u32]) -> Vec<Vec<[u32; 3]>> {
    let mut stars = vec![Vec::new(); nodes.len()];
    for triangle in triangles {
        for node in triangle {
            if let Ok(place) = nodes.binary_search(node) {
                stars[place].push(*triangle);
            }
        }
    }
    stars
}

/// Moves a node to the middle of its kernel, if that is good for all of its star.
fn centre(node: u32, star: &[[u32; 3]], points: &mut [[f64; 2]]) {
    let is_good = |points: &[[f64; 2]]| star.iter().all(|t| orientation(t, points) == Ordering::Greater);
    if is_good(points) {
        return;
    }
    let sides: Vec<[[f64; 2]; 2]> = star.iter().map(|triangle| far_side(node, *triangle, points)).collect();
    let Some(middle) = middle_of_kernel(&sides) else { return };
    let old = std::mem::replace(&mut points[node as usize], middle);
    if !is_good(points) {
        points[node as usize] = old;
    }
}

/// The side of a triangle that a node is not on, as the triangle runs.
fn far_side(node: u32, triangle: [u32; 3], points: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let at = triangle.iter().position(|&n| n == node).unwrap_or(0);
    [1, 2].map(|step| points[triangle[(at + step) % 3] as usize])
}

/// The mean of the corners of what lies to the left of all sides, if that is anything.
fn middle_of_kernel(sides: &[[[f64; 2]; 2]]) -> Option<[f64; 2]> {
    let ends = || sides.iter().flatten();
    let least = ends().copied().reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1])])?;
    let most = ends().copied().reduce(|a, b| [a[0].max(b[0]), a[1].max(b[1])])?;
    // A narrow star is stretched to a square: which side a point is on stays, and rounding matters less.
    let size = [0, 1].map(|axis| most[axis] - least[axis]);
    if size.iter().any(|&size| size.is_nan() || size <= 0.0) {
        return None;
    }
    let stretched = |p: [f64; 2]| [0, 1].map(|axis| (p[axis] - least[axis]) / size[axis]);
    let mut kernel = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    for side in sides {
        kernel = clipped(&kernel, side.map(stretched));
    }
    let count = kernel.len() as f64;
    let mean = |axis: usize| kernel.iter().map(|p| p[axis]).sum::<f64>() / count;
    (kernel.len() > 2).then(|| [0, 1].map(|axis| least[axis] + size[axis] * mean(axis)))
}

/// The part of a convex polygon to the left of a line.
fn clipped(polygon: &[[f64; 2]], [a, b]: [[f64; 2]; 2]) -> Vec<[f64; 2]> {
    let height = |p: [f64; 2]| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (&p, &q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (from, to) = (height(p), height(q));
        if from >= 0.0 {
            left.push(p);
        }
        if (from < 0.0) != (to < 0.0) && from != to {
            let part = from / (from - to);
            left.push([0, 1].map(|axis| p[axis] + part * (q[axis] - p[axis])));
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A fan around node 0, whose rim runs counterclockwise.
    fn fan(rim: &[[f64; 2]]) -> (Vec<[u32; 3]>, Vec<[f64; 2]>) {
        let count = rim.len() as u32;
        let triangles = (0..count).map(|i| [0, 1 + i, 1 + (i + 1) % count]).collect();
        (triangles, [[0.0; 2]].iter().chain(rim).copied().collect())
    }

    fn is_good(triangles: &[[u32; 3]], points: &[[f64; 2]]) -> bool {
        triangles.iter().all(|triangle| orientation(triangle, points) == Ordering::Greater)
    }

    #[test]
    fn a_node_outside_its_star_comes_in() {
        let (triangles, mut points) = fan(&[[2.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0]]);
        assert!(!is_good(&triangles, &points));
        untangle(&triangles, &mut points, |node| node == 0);
        assert!(is_good(&triangles, &points));
        assert_eq!(points[0], [2.5, 0.5]);
    }

    #[test]
    fn a_narrow_star_that_is_not_convex_is_seen_from_its_kernel() {
        let rim = [[0.0, 0.0], [1e-13, 0.5], [2e-13, 0.0], [1.9e-13, 1.0], [1e-14, 1.0]];
        let (triangles, mut points) = fan(&rim);
        points[0] = [1e-13, 0.2];
        untangle(&triangles, &mut points, |node| node == 0);
        assert!(is_good(&triangles, &points), "{points:?}");
    }

    #[test]
    fn nothing_moves_where_there_is_no_kernel_or_no_leave() {
        // Two notches that look away from each other: no point sees all of it.
        let rim =
            [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        let (triangles, mut points) = fan(&rim);
        points[0] = [2.0, 2.0];
        let before = points.clone();
        untangle(&triangles, &mut points, |_| false);
        assert_eq!(points, before);
        untangle(&triangles, &mut points, |node| node == 0);
        assert_eq!(points, before);
    }
}
