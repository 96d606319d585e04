//! Triangles in two planes: each is cut by the other's plane, and both cuts lie on the line of the two planes.
//!
//! *Source*: T. Möller, A fast triangle-triangle intersection test, 1997, in the form of P. Guigue and O. Devillers, 2003,
//! which takes signs alone.

use super::Pair;
use crate::exact::{Sign, side_of_plane};
use crate::surface::{Cell, WHOLE};

/// Where a triangle's outline passes a plane: on a side whose first end lies above the plane or on it, and whose second one
/// below or on it, but not both on it.
#[derive(Clone, Copy)]
struct End {
    above: usize,
    below: usize,
    /// The side, or the corner if one of its ends is on the plane.
    cell: Cell,
}

/// What a plane cuts out of a triangle: a segment or a corner.
struct Trace {
    ends: [End; 2],
    /// The smallest cell that holds all of it.
    whole: Cell,
}

/// The smallest cells that hold what two triangles have in common; `sides` has for each on which side of the other's plane
/// its corners lie, neither all on it nor all strictly on one side.
pub(super) fn cells(pair: &Pair<'_>, sides: [[Sign; 3]; 2]) -> Option<[Cell; 2]> {
    let [f, g] = sides.map(trace);
    let orders = f.ends.map(|one| g.ends.map(|other| order(pair, one, other)));
    let none = |sign: Sign| orders.iter().flatten().all(|&order| order != sign);
    let is_one_sided = none(Sign::Positive) || none(Sign::Negative);
    if !is_one_sided {
        return Some([f.whole, g.whole]);
    }
    // They are apart, or an end of one is an end of the other.
    let all = (0..4).map(|at| (at / 2, at % 2));
    let touching = all.into_iter().find(|&(one, other)| orders[one][other].is_zero());
    touching.map(|(one, other)| [f.ends[one].cell, g.ends[other].cell])
}

/// Which of two ends comes first along the line of the planes; all questions about one pair of triangles go by one direction.
fn order(pair: &Pair<'_>, one: End, other: End) -> Sign {
    let are_one = |at: usize| pair.same(at).is_some_and(|same| [other.above, other.below].contains(&same));
    if are_one(one.above) || are_one(one.below) {
        // The other end of such a side is off the plane, so that both ends are the shared corner.
        return Sign::Zero;
    }
    let [f, g] = pair.points;
    side_of_plane([f[one.above], f[one.below], g[other.above]], g[other.below])
}

fn trace(sides: [Sign; 3]) -> Trace {
    let at_corner = |corner: usize, beside: usize| {
        let (above, below) =
            if sides[beside] == Sign::Positive { (beside, corner) } else { (corner, beside) };
        End { above, below, cell: 1 << corner }
    };
    let on_side = |one: usize, other: usize| {
        let (above, below) = if sides[one] == Sign::Positive { (one, other) } else { (other, one) };
        End { above, below, cell: 1 << one | 1 << other }
    };
    let turned = (0..3).map(|at| [at, (at + 1) % 3, (at + 2) % 3]);
    for [a, b, c] in turned {
        match [a, b, c].map(|at| sides[at].is_zero()) {
            [true, true, _] => {
                return Trace { ends: [at_corner(a, c), at_corner(b, c)], whole: 1 << a | 1 << b };
            }
            [true, false, false] if sides[b] == sides[c] => {
                return Trace { ends: [at_corner(a, b); 2], whole: 1 << a };
            }
            [true, false, false] => {
                return Trace { ends: [at_corner(a, b), on_side(b, c)], whole: WHOLE };
            }
            [false, false, false] if sides[b] == sides[c] => {
                return Trace { ends: [on_side(a, b), on_side(a, c)], whole: WHOLE };
            }
            _ => {}
        }
    }
    // Only a triangle that the plane misses comes here.
    Trace { ends: [on_side(0, 1), on_side(0, 2)], whole: WHOLE }
}
