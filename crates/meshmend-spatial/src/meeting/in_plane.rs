//! Triangles in one plane.

use super::Pair;
use crate::exact::{Axis, Sign, projection_of, turn, turn_along};
use crate::surface::{Cell, WHOLE};

/// The sides of a triangle's sides on which three points lie: positive on the inside.
type Turns = [[Sign; 3]; 3];

/// The smallest cells that hold what two triangles in one plane have in common.
pub(super) fn cells(pair: &Pair) -> Option<[Cell; 2]> {
    let (axis, sign) = projection_of(pair.points[0])?;
    let to_second = turns(pair, axis, sign);
    let to_first = turns(&pair.swapped(), axis, turn_along(axis, pair.points[1]));
    if !is_apart(&to_second) && !is_apart(&to_first) {
        return Some([WHOLE; 2]);
    }
    // What they have in common is a point or a part of a line, and ends in corners.
    let (of_first, of_second) = (inside(&to_first), inside(&to_second));
    if of_first == 0 && of_second == 0 {
        return None;
    }
    Some([least_cell(of_first, of_second, &to_second), least_cell(of_second, of_first, &to_first)])
}

/// Where the second triangle's corners lie by the first one's sides, which runs anticlockwise along the axis if `sign` is
/// positive.
fn turns(pair: &Pair, axis: Axis, sign: Sign) -> Turns {
    let [f, g] = pair.points.map(|points| points.map(|point| axis.seen(point)));
    std::array::from_fn(|side| {
        let next = (side + 1) % 3;
        std::array::from_fn(|at| {
            if [side, next].into_iter().any(|end| pair.same[end] == Some(at)) {
                Sign::Zero
            } else {
                sign * turn(f[side], f[next], g[at])
            }
        })
    })
}

/// Whether some side has all corners of the other triangle on its line or outside.
fn is_apart(turns: &Turns) -> bool {
    turns.iter().any(|side| side.iter().all(|&turn| turn != Sign::Positive))
}

/// The corners that lie on the inside or the outline of the other triangle, a bit each.
fn inside(turns: &Turns) -> Cell {
    let is_inside = |at: &usize| turns.iter().all(|side| side[*at] != Sign::Negative);
    (0..3).filter(is_inside).map(|at| 1 << at).sum()
}

/// The smallest cell of a triangle that holds some of its own corners and some of the other's, all of which lie on it.
fn least_cell(own: Cell, others: Cell, turns: &Turns) -> Cell {
    let is_on = |side: usize| {
        let opposite = 1 << ((side + 2) % 3);
        let mut others = (0..3).filter(|at| others >> at & 1 == 1);
        own & opposite == 0 && others.all(|at| turns[side][at].is_zero())
    };
    (0..3).filter(|&side| is_on(side)).fold(WHOLE, |cell, side| cell & !(1 << ((side + 2) % 3)))
}
