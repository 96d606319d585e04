//! Takes a polygon apart where it touches itself without coming back.
//!
//! Two holes, each on a bridge of its own, may touch in a vertex. Then the polygon passes that vertex twice, each time with
//! the other hole within its corner, and what lies on one side of the vertex is joined to what lies on the other by a
//! gap of no width. Where each corner is taken to reach to the next side instead, there is no gap, but there may be
//! several polygons: here called *walks*.

use std::cmp::Ordering;

use robust::{Coord, orient2d};

use crate::sorting::merge_sort;

/// The walks of a polygon in a plane that runs round its inside anticlockwise, as the places of their corners; nothing if
/// it crosses itself at a vertex.
///
/// *Cost*: O(n log n).
pub(super) fn walks<V: Ord + Copy>(points: &[[f64; 2]], vertices: &[V]) -> Option<Vec<Vec<usize>>> {
    let next = continuations(points, vertices)?;
    let mut is_walked = vec![false; points.len()];
    let mut walks = Vec::new();
    for first in 0..points.len() {
        let mut walk = Vec::new();
        let mut corner = first;
        while !std::mem::replace(&mut is_walked[corner], true) {
            walk.push(corner);
            corner = next[corner];
        }
        if !walk.is_empty() {
            walks.push(walk);
        }
    }
    Some(walks)
}

/// One end of a side at a vertex.
#[derive(Clone, Copy)]
struct End {
    /// The corner at which the side starts.
    side: usize,
    is_arriving: bool,
    /// Where the side's other end is.
    other: [f64; 2],
}

/// For each side, named after the corner at which it starts, the side that bounds the same part of the inside beyond it.
fn continuations<V: Ord + Copy>(points: &[[f64; 2]], vertices: &[V]) -> Option<Vec<usize>> {
    let count = points.len();
    let after = |corner: usize| if corner + 1 == count { 0 } else { corner + 1 };
    let mut next: Vec<usize> = (0..count).map(after).collect();
    let mut corners: Vec<usize> = (0..count).collect();
    corners.sort_unstable_by_key(|&corner| (vertices[corner], corner));
    for run in corners.chunk_by(|&one, &other| vertices[one] == vertices[other]) {
        if run.len() == 1 {
            continue;
        }
        let mut ends: Vec<End> = Vec::with_capacity(2 * run.len());
        for &corner in run {
            let before = corner.checked_sub(1).unwrap_or(count - 1);
            ends.push(End { side: before, is_arriving: true, other: points[before] });
            ends.push(End { side: corner, is_arriving: false, other: points[after(corner)] });
        }
        let centre = points[run[0]];
        merge_sort(&mut ends, |one, other| {
            angle(centre, one.other, other.other).then(other.is_arriving.cmp(&one.is_arriving))
        });
        for (at, end) in ends.iter().enumerate().filter(|(_, end)| !end.is_arriving) {
            let arriving = &ends[if at + 1 == ends.len() { 0 } else { at + 1 }];
            if !arriving.is_arriving {
                return None;
            }
            next[arriving.side] = end.side;
        }
    }
    Some(next)
}

/// The order of two points anticlockwise round a centre.
fn angle(centre: [f64; 2], one: [f64; 2], other: [f64; 2]) -> Ordering {
    let is_lower = |[x, y]: [f64; 2]| y < centre[1] || (y == centre[1] && x < centre[0]);
    let [a, b, c] = [centre, one, other].map(|[x, y]| Coord { x, y });
    is_lower(one).cmp(&is_lower(other)).then(0.0f64.total_cmp(&(orient2d(a, b, c) + 0.0)))
}
