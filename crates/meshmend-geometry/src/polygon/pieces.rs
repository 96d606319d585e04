//! Cuts a polygon that comes back to a vertex into simple ones that cover what it covers.
//!
//! A face with a hole is written as its rim, a *bridge* to the hole, the hole the other way round, and the bridge
//! back. Told apart by their places, its corners are those of a disc, though some stand at one vertex; so it is cut
//! into triangles like any other. These make a tree, in which two are neighbours where they share a diagonal. From
//! its leaves on, what lies on both sides of a diagonal is joined again unless that would bring two corners of one
//! vertex together. The diagonals that are left are the cuts. A small polygon that crosses itself is tried with every
//! choice of diagonals.

use std::cmp::Reverse;
use std::collections::BTreeSet;

use meshmend_core::VertexId;

use super::corners::{Polygon, Triangle};
use super::cost::Avoid;
use super::projection::{seen_along_an_axis, seen_along_the_normal};
use super::triangulate::least_cost;
use super::turning::ExactArea;
use super::walks::walks;
use crate::vector::{Point, area_vector};

/// Whether a polygon that comes back to a vertex has a hole: whether one of its loops turns against the whole of it.
///
/// *Cost*: linear.
pub fn has_hole(whole: &[Point], mut loops: impl Iterator<Item = Vec<Point>>) -> bool {
    if !whole.iter().flatten().all(|x| x.is_finite()) {
        return false;
    }
    let whole = ExactArea::of(whole);
    loops.any(|points| ExactArea::of(&points).turns_against(&whole))
}

/// The simple pieces of a polygon, each with its corners in the polygon's order, by their first. `None` if none were
/// found that keep what is promised, as in most polygons that cross themselves.
///
/// No two sides of pieces run the same way between the same vertices, and no piece turns against the polygon. A cut
/// runs along an edge that is taken only where there is no other choice.
///
/// *Cost*: as for [`triangulate_polygon`](super::triangulate_polygon), and O(n log n).
pub fn simple_pieces(
    polygon: Polygon<'_>,
    is_taken: &dyn Fn(usize, usize) -> bool,
) -> Option<Vec<Vec<usize>>> {
    let whole: Vec<usize> = (0..polygon.len()).collect();
    let sides = sides_of(polygon, std::slice::from_ref(&whole));
    let is_side = |ends: [VertexId; 2]| sides.binary_search(&ends).is_ok();
    let is_taken = |one: usize, other: usize| {
        let (a, b) = (polygon.vertex(one), polygon.vertex(other));
        is_side([a, b]) || is_side([b, a]) || is_taken(one, other)
    };
    let alone = cut(polygon, &[whole], &is_taken);
    if let Some((pieces, true)) = alone {
        return Some(pieces);
    }
    let normal = area_vector(polygon.points.iter().copied());
    let walked = [seen_along_an_axis, seen_along_the_normal].into_iter().find_map(|seen| {
        let walks = walks(&seen(polygon, normal)?, polygon.vertices)?;
        let (pieces, is_proper) = cut(polygon, &walks, &is_taken)?;
        is_proper.then_some(pieces)
    });
    walked.or(alone.map(|(pieces, _)| pieces)).or_else(|| searched(polygon, 0, &mut Vec::new()))
}

/// Polygons of so many corners are cut in every way before they are given up.
const LARGEST_SEARCHED: usize = 8;

/// The first pieces that keep what is promised, of all ways to cut a small polygon along these diagonals and more.
fn searched(polygon: Polygon<'_>, from: usize, cuts: &mut Vec<[usize; 2]>) -> Option<Vec<Vec<usize>>> {
    let count = polygon.len();
    if count > LARGEST_SEARCHED {
        return None;
    }
    let mut pieces = parted(count, cuts.clone())?;
    let is_simple = |piece: &Vec<usize>| {
        let vertex = |place: usize| polygon.vertex(piece[place]);
        (1..piece.len()).all(|place| (0..place).all(|before| vertex(before) != vertex(place)))
    };
    if pieces.iter().all(is_simple) && are_sound(polygon, &pieces) {
        pieces.sort_unstable();
        return Some(pieces);
    }
    let crosses = |[a, b]: [usize; 2], [c, d]: [usize; 2]| a < c && c < b && b < d || c < a && a < d && d < b;
    let diagonals = (0..count).flat_map(|low| (low + 2..count).map(move |high| [low, high]));
    for (at, diagonal) in diagonals.enumerate().skip(from).filter(|(_, ends)| *ends != [0, count - 1]) {
        if cuts.iter().any(|&other| crosses(diagonal, other)) {
            continue;
        }
        cuts.push(diagonal);
        let found = searched(polygon, at + 1, cuts);
        cuts.pop();
        if found.is_some() {
            return found;
        }
    }
    None
}

/// The pieces of some walks along a polygon, if they keep what is promised, and whether triangles lie in them side by
/// side.
fn cut(
    polygon: Polygon<'_>,
    walks: &[Vec<usize>],
    is_taken: &dyn Fn(usize, usize) -> bool,
) -> Option<(Vec<Vec<usize>>, bool)> {
    let (mut pieces, mut is_proper) = (Vec::new(), true);
    for walk in walks {
        let points: Vec<Point> = walk.iter().map(|&corner| polygon.points[corner]).collect();
        let vertices: Vec<VertexId> = walk.iter().map(|&corner| polygon.vertex(corner)).collect();
        let part = Polygon { points: &points, vertices: &vertices };
        let (cost, triangles) =
            least_cost(part, Avoid::Folds, &|one, other| is_taken(walk[one], walk[other]));
        is_proper &= cost.is_proper();
        let parted = parted(part.len(), cuts(part, triangles)?)?;
        pieces.extend(parted.iter().map(|piece| in_order(piece, walk)));
    }
    pieces.sort_unstable();
    are_sound(polygon, &pieces).then_some((pieces, is_proper))
}

/// The corners of a piece of a walk, the lowest first.
fn in_order(piece: &[usize], walk: &[usize]) -> Vec<usize> {
    let mut corners: Vec<usize> = piece.iter().map(|&at| walk[at]).collect();
    let least = corners.iter().enumerate().min_by_key(|(_, corner)| **corner).map_or(0, |(at, _)| at);
    corners.rotate_left(least);
    corners
}

/// The diagonals, as their lower and higher place, that part the triangles into simple pieces; `None` if a triangle
/// has two corners at one vertex.
fn cuts(polygon: Polygon<'_>, mut triangles: Vec<Triangle>) -> Option<Vec<[usize; 2]>> {
    let repeated = repeated_vertices(polygon);
    let is_repeated = |vertex: &VertexId| repeated.binary_search(vertex).is_ok();
    // Each triangle after those beyond its two lower sides, which then are on top of the stack.
    triangles.sort_unstable_by_key(|&[low, _, high]| (high, Reverse(low)));
    let mut stack: Vec<BTreeSet<VertexId>> = Vec::new();
    let mut cuts = Vec::new();
    for [a, b, c] in triangles {
        let ends = [a, b, c].map(|corner| polygon.vertex(corner));
        if ends[0] == ends[1] || ends[1] == ends[2] || ends[2] == ends[0] {
            return None;
        }
        let mut part: BTreeSet<VertexId> = ends.into_iter().filter(is_repeated).collect();
        for [low, high] in [[b, c], [a, b]] {
            if high - low == 1 {
                continue;
            }
            let beyond = stack.pop()?;
            let ends = [polygon.vertex(low), polygon.vertex(high)];
            match joined(part, beyond, ends) {
                Ok(both) => part = both,
                Err(alone) => {
                    cuts.push([low, high]);
                    part = alone;
                }
            }
        }
        stack.push(part);
    }
    Some(cuts)
}

/// The vertices at which more than one corner stands, ascending.
fn repeated_vertices(polygon: Polygon<'_>) -> Vec<VertexId> {
    let mut vertices = polygon.vertices.to_vec();
    vertices.sort_unstable();
    vertices.chunk_by(|one, other| one == other).filter(|run| run.len() > 1).map(|run| run[0]).collect()
}

/// Both sets in one if they have nothing in common but the ends of a diagonal; else the first as it was.
fn joined(
    part: BTreeSet<VertexId>,
    beyond: BTreeSet<VertexId>,
    ends: [VertexId; 2],
) -> Result<BTreeSet<VertexId>, BTreeSet<VertexId>> {
    let is_larger = beyond.len() > part.len();
    let (mut large, small) = if is_larger { (beyond, part) } else { (part, beyond) };
    if small.iter().any(|vertex| !ends.contains(vertex) && large.contains(vertex)) {
        return Err(if is_larger { small } else { large });
    }
    large.extend(small);
    Ok(large)
}

/// The pieces into which diagonals part a polygon of so many corners; `None` if they cross.
fn parted(count: usize, mut cuts: Vec<[usize; 2]>) -> Option<Vec<Vec<usize>>> {
    // By their higher place, of those the shortest first.
    cuts.sort_unstable_by_key(|&[low, high]| (high, Reverse(low)));
    let mut ending = cuts.into_iter().peekable();
    let (mut pieces, mut open) = (Vec::new(), Vec::new());
    for corner in 0..count {
        open.push(corner);
        while let Some([low, _]) = ending.next_if(|&[_, high]| high == corner) {
            let at = open.iter().rposition(|&place| place == low)?;
            pieces.push(open[at..].to_vec());
            open.truncate(at + 1);
            open.push(corner);
        }
    }
    pieces.push(open);
    Some(pieces)
}

fn are_sound(polygon: Polygon<'_>, pieces: &[Vec<usize>]) -> bool {
    let sides = sides_of(polygon, pieces);
    if sides.windows(2).any(|pair| pair[0] == pair[1]) {
        return false;
    }
    let whole = ExactArea::of(polygon.points);
    pieces.iter().all(|piece| {
        let points: Vec<Point> = piece.iter().map(|&corner| polygon.points[corner]).collect();
        !ExactArea::of(&points).turns_against(&whole)
    })
}

/// The vertices of all sides of some pieces, in the direction in which they are run; sorted.
fn sides_of(polygon: Polygon<'_>, pieces: &[Vec<usize>]) -> Vec<[VertexId; 2]> {
    let mut sides = Vec::with_capacity(polygon.len());
    for piece in pieces {
        let next = piece.iter().cycle().skip(1);
        sides.extend(piece.iter().zip(next).map(|(&from, &to)| [polygon.vertex(from), polygon.vertex(to)]));
    }
    sides.sort_unstable();
    sides
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(corners: &[(u32, [i32; 2])]) -> Option<Vec<Vec<u32>>> {
        let points: Vec<Point> =
            corners.iter().map(|(_, [x, y])| [f64::from(*x), f64::from(*y), 0.0]).collect();
        let vertices: Vec<VertexId> = corners.iter().map(|(vertex, _)| VertexId(*vertex)).collect();
        let polygon = Polygon { points: &points, vertices: &vertices };
        let pieces = simple_pieces(polygon, &|_, _| false)?;
        Some(pieces.iter().map(|piece| piece.iter().map(|&corner| vertices[corner].0).collect()).collect())
    }

    /// Corners at vertices whose numbers are their coordinates.
    fn at(corners: &[[i32; 2]]) -> Vec<(u32, [i32; 2])> {
        corners.iter().map(|&[x, y]| ((x * 100 + y) as u32, [x, y])).collect()
    }

    const RIM: [[i32; 2]; 4] = [[0, 0], [4, 0], [4, 4], [0, 4]];

    #[test]
    fn a_ring_becomes_two_pieces() {
        let ring = at(&[&RIM[..], &[[0, 0], [1, 1], [1, 3], [3, 3], [3, 1], [1, 1]]].concat());
        let found = pieces(&ring).unwrap();
        assert_eq!(found.len(), 2, "{found:?}");
    }

    #[test]
    fn a_hole_that_touches_the_rim_leaves_one_piece_less() {
        let found = pieces(&at(&[&RIM[..], &[[0, 0], [1, 3], [3, 1]]].concat())).unwrap();
        assert_eq!(found.len(), 2, "{found:?}");
    }

    #[test]
    fn a_figure_of_eight_that_crosses_itself_has_no_pieces() {
        assert_eq!(pieces(&at(&[[0, 0], [4, 0], [0, 4], [4, 4], [0, 0], [1, 3], [2, 9]])), None);
    }

    /// Twice the area of pieces, at vertices whose numbers are their coordinates.
    fn doubled_area(pieces: &[Vec<u32>]) -> i32 {
        let at = |vertex: u32| [vertex as i32 / 100, vertex as i32 % 100];
        let of = |piece: &Vec<u32>| -> i32 {
            let sides = piece.iter().zip(piece.iter().cycle().skip(1));
            sides.map(|(&p, &q)| (at(p), at(q))).map(|([a, b], [c, d])| a * d - b * c).sum()
        };
        assert!(pieces.iter().all(|piece| of(piece) > 0), "{pieces:?}");
        pieces.iter().map(of).sum()
    }

    #[test]
    fn holes_that_touch_and_hang_on_bridges_of_their_own_stay_open() {
        let holes = [
            [[0, 0], [1, 1], [1, 2], [2, 2], [2, 1], [1, 1]],
            [[0, 0], [2, 3], [3, 3], [3, 2], [2, 2], [2, 3]],
        ];
        let face = at(&[&[[0, 0], [9, 0], [9, 9], [0, 9]][..], &holes[1], &holes[0]].concat());
        assert_eq!(doubled_area(&pieces(&face).unwrap()), 2 * (81 - 2));
    }

    /// Of faces that cross themselves some can be cut all the same, if not by triangles that lie side by side.
    #[test]
    fn a_small_face_that_crosses_itself_is_cut_if_any_diagonals_do() {
        let crossing = at(&[[0, 1], [0, 0], [3, 1], [0, 1], [3, 3], [1, 0]]);
        assert!(pieces(&crossing).is_some());
        let impossible = at(&[[2, 3], [1, 0], [0, 4], [4, 3], [2, 3], [0, 1], [4, 2]]);
        assert_eq!(pieces(&impossible), None);
    }
}
