//! Cuts a large polygon into triangles in near-linear time, whatever its shape.
//!
//! 1. From left to right, each corner at which the polygon splits or merges is joined by a diagonal to the corner that
//!    was last seen above the same side. That leaves monotone pieces: a lower and an upper chain from left to right.
//! 2. Each piece is cut from left to right: what can be cut off is, the rest waits on a stack.
//!
//! *Source*: M. Garey, D. Johnson, F. Preparata, R. Tarjan, *Triangulating a simple polygon*, 1978; in the form of
//! M. de Berg et al., *Computational Geometry*, chapter 3.

use super::plane::Plane;
use super::sides::Sides;
use super::{Triangle, in_polygon_order};

/// The triangles of a polygon in a plane that runs round its inside anticlockwise. If it crosses itself they may be no
/// triangulation, or none.
///
/// *Cost*: O(n log² n) time, O(n log n) memory.
pub(super) fn by_monotone_pieces(points: Vec<[f64; 2]>) -> Vec<Triangle> {
    let plane = Plane::of(points);
    let diagonals = diagonals(&plane);
    let mut triangles = Vec::with_capacity(plane.len());
    match pieces(plane.len(), diagonals, |piece| cut(&plane, piece, &mut triangles)) {
        Some(()) => triangles,
        None => Vec::new(),
    }
}

/// What the polygon does at a corner, seen from left to right.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Event {
    /// It begins, or two parts of it become one, or one goes on along its lower or its upper chain.
    Start,
    End,
    Split,
    Merge,
    Lower,
    Upper,
}

fn event(plane: &Plane, corner: usize) -> Event {
    let (previous, next) = (plane.previous(corner), plane.next(corner));
    let is_left = |other: usize| plane.rank(other) < plane.rank(corner);
    let is_convex = || plane.turn(previous, corner, next) > 0.0;
    match (is_left(previous), is_left(next)) {
        (false, false) if is_convex() => Event::Start,
        (false, false) => Event::Split,
        (true, true) if is_convex() => Event::End,
        (true, true) => Event::Merge,
        (true, false) => Event::Lower,
        (false, true) => Event::Upper,
    }
}

/// Diagonals that part a polygon into monotone pieces, the lower place first.
fn diagonals(plane: &Plane) -> Vec<[usize; 2]> {
    let events: Vec<Event> = (0..plane.len()).map(|corner| event(plane, corner)).collect();
    let sides = Sides::of(plane);
    // For each side the corner last seen above it; at first the one at which it starts.
    let mut last_above: Vec<usize> = (0..plane.len()).collect();
    let mut diagonals: Vec<[usize; 2]> = Vec::new();
    for corner in plane.left_to_right() {
        let event = events[corner];
        let mut join = |other: usize| diagonals.push([corner.min(other), corner.max(other)]);
        if matches!(event, Event::End | Event::Merge | Event::Lower) {
            let last = last_above[plane.previous(corner)];
            if events[last] == Event::Merge {
                join(last);
            }
        }
        if matches!(event, Event::Split | Event::Merge | Event::Upper) {
            let Some(side) = sides.below(corner) else { continue };
            let last = std::mem::replace(&mut last_above[side], corner);
            if event == Event::Split || events[last] == Event::Merge {
                join(last);
            }
        }
    }
    diagonals
}

/// Calls for each piece into which diagonals part a polygon of so many corners; nothing if they cross.
fn pieces(count: usize, mut diagonals: Vec<[usize; 2]>, mut call: impl FnMut(&[usize])) -> Option<()> {
    // By their higher place, of those the shortest first.
    diagonals.sort_unstable_by_key(|&[low, high]| (high, std::cmp::Reverse(low)));
    let mut ending = diagonals.into_iter().peekable();
    let mut open: Vec<usize> = Vec::new();
    for corner in 0..count {
        open.push(corner);
        while let Some([low, _]) = ending.next_if(|&[_, high]| high == corner) {
            let at = open.iter().rposition(|&place| place == low)?;
            call(&open[at..]);
            open.truncate(at + 1);
            open.push(corner);
        }
    }
    call(&open);
    Some(())
}

/// Cuts a monotone piece, given by its corners in the polygon's order.
fn cut(plane: &Plane, piece: &[usize], triangles: &mut Vec<Triangle>) {
    let count = piece.len();
    let mut from_left: Vec<usize> = (0..count).collect();
    from_left.sort_unstable_by_key(|&at| plane.rank(piece[at]));
    let (&[first, second, ref others @ ..], Some(&rightmost)) = (&from_left[..], from_left.last()) else {
        return;
    };
    let steps_to = |at: usize| (at + count - first) % count;
    let is_lower = |at: usize| steps_to(at) < steps_to(rightmost);
    let mut push = |corners: [usize; 3]| triangles.push(in_polygon_order(corners.map(|at| piece[at])));
    // What waits to be cut, from left to right, all on one chain but for the first.
    let mut waiting = vec![first, second];
    for &at in others {
        let Some(&newest) = waiting.last() else { return };
        if at == rightmost || is_lower(at) != is_lower(newest) {
            waiting.windows(2).for_each(|pair| push([pair[0], pair[1], at]));
            waiting = vec![newest, at];
            continue;
        }
        let turn = |one: usize, two: usize| {
            let turn = plane.turn(piece[one], piece[two], piece[at]);
            if is_lower(at) { turn } else { -turn }
        };
        while let &[.., before, last] = &waiting[..]
            && turn(before, last) > 0.0
        {
            push([before, last, at]);
            waiting.pop();
        }
        waiting.push(at);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    type Flat = Vec<[f64; 2]>;

    fn area(polygon: &[[f64; 2]]) -> f64 {
        let twice = |i: usize| {
            let ([x, y], [u, v]) = (polygon[i], polygon[(i + 1) % polygon.len()]);
            x * v - u * y
        };
        (0..polygon.len()).map(twice).sum::<f64>() / 2.0
    }

    /// No triangle lies the wrong way round, and together they have the polygon's area.
    #[track_caller]
    fn assert_cut(polygon: Flat) {
        let triangles = by_monotone_pieces(polygon.clone());
        assert_eq!(triangles.len(), polygon.len() - 2);
        let areas: Vec<f64> = triangles.iter().map(|corners| area(&corners.map(|i| polygon[i]))).collect();
        let whole = area(&polygon);
        let folded = triangles.iter().zip(&areas).find(|(_, area)| **area < -1e-9 * whole);
        assert_eq!(folded, None, "of {:?} …", &polygon[..polygon.len().min(10)]);
        assert!((areas.iter().sum::<f64>() - whole).abs() <= 1e-9 * whole);
    }

    #[test]
    fn polygons_of_extreme_shape_are_cut() {
        let turned = |polygon: Flat| polygon.into_iter().map(|[x, y]| [-y, x]).collect::<Flat>();
        let comb: Flat = (0..500)
            .flat_map(|i| [[f64::from(i), 0.0], [f64::from(i) + 0.5, 1e4]])
            .chain([[500.0, -1.0], [0.0, -1.0]])
            .rev()
            .collect();
        let arm = |far: f64| move |i: u32| [f64::from(i) * 0.1, f64::from(i) + far];
        let round = |[turn, far]: [f64; 2]| [far * turn.cos(), far * turn.sin()];
        let spiral: Flat =
            (0..500).map(arm(10.0)).chain((0..500).rev().map(arm(9.8))).map(round).rev().collect();
        let spiral = if area(&spiral) < 0.0 { spiral.into_iter().rev().collect() } else { spiral };
        let stairs: Flat = (0..300)
            .flat_map(|i| [[f64::from(i), f64::from(i)], [f64::from(i + 1), f64::from(i)]])
            .chain([[300.0, 300.0], [-1.0, 300.0]])
            .collect();
        for polygon in [comb, spiral, stairs] {
            assert_cut(turned(polygon.clone()));
            assert_cut(polygon);
        }
    }

    /// A side that falls from the left passes under one that begins lower, further on. Between them is a gap, and above
    /// both a corner that belongs to the nearer one.
    #[test]
    fn sides_are_compared_where_both_are() {
        let polygon = [
            [0.0, 10.0],
            [30.0, -50.0],
            [30.0, -45.0],
            [15.0, -12.0],
            [10.0, -1.0],
            [28.0, 0.0],
            [28.0, 5.0],
            [18.0, 6.0],
            [28.0, 8.0],
            [28.0, 20.0],
        ];
        for far in [0.0, 1000.0, -1000.0] {
            assert_cut(polygon.iter().map(|&[x, y]| [x + far, y]).collect());
        }
    }

    /// Whether two sides have no point in common but an end that is one corner.
    fn are_apart(polygon: &[[f64; 2]], one: usize, other: usize) -> bool {
        let count = polygon.len();
        let [a, b, c, d] = [one, (one + 1) % count, other, (other + 1) % count].map(|i| polygon[i]);
        let turn = |[a, b, c]: [[f64; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if b == c {
            return turn([a, b, d]) != 0.0;
        }
        if d == a {
            return turn([c, d, b]) != 0.0;
        }
        let is_on_one_side = |ends: [[f64; 2]; 2], others: [[f64; 2]; 2]| {
            let turns = others.map(|point| turn([ends[0], ends[1], point]));
            turns[0] * turns[1] > 0.0
        };
        let collinear = [c, d].iter().all(|&point| turn([a, b, point]) == 0.0);
        let reaches = |i: usize| a[i].max(b[i]) < c[i].min(d[i]) || c[i].max(d[i]) < a[i].min(b[i]);
        is_on_one_side([a, b], [c, d])
            || is_on_one_side([c, d], [a, b])
            || collinear && (reaches(0) || reaches(1))
    }

    #[test]
    fn every_small_simple_polygon_is_cut() {
        let mut state = 1u64;
        let mut random = |below: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % below
        };
        let mut count = 0;
        for _ in 0..200_000 {
            let corners = 4 + random(6);
            let mut polygon: Flat = (0..corners).map(|_| [random(5) as f64, random(5) as f64]).collect();
            let pairs = (0..polygon.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
            if !pairs.clone().all(|(j, i)| are_apart(&polygon, j, i)) {
                continue;
            }
            if area(&polygon) < 0.0 {
                polygon.reverse();
            }
            assert_cut(polygon);
            count += 1;
        }
        assert!(count > 1000, "{count} polygons are simple");
    }

    #[test]
    fn whatever_crosses_itself_ends_in_any_triangles_or_none() {
        for count in [5, 50, 5000] {
            let part = |i: usize, root: f64| (i as f64 * root).fract();
            let points = (0..count).map(|i| [part(i, 2.0f64.sqrt()), part(i, 3.0f64.sqrt())]).collect();
            let triangles = by_monotone_pieces(points);
            assert!(triangles.iter().flatten().all(|&corner| corner < count));
            assert!(triangles.len() <= count - 2);
        }
        for point in [0.0, 1e300, f64::MIN_POSITIVE] {
            by_monotone_pieces(vec![[point; 2]; 100]);
        }
    }

    #[test]
    fn one_or_two_corners_make_no_triangle() {
        for count in [1, 2] {
            assert_eq!(by_monotone_pieces(vec![[1.0; 2]; count]), [[0; 3]; 0]);
        }
    }
}
