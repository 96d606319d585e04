//! Triangles in one plane.

use super::Pair;
use crate::exact::{Sign, projection_of, turn, turn_along};
use crate::surface::{Cell, WHOLE};

/// The sides of a triangle's sides on which three points lie: positive on the inside.
type Turns = [[Sign; 3]; 3];

/// The smallest cells that hold what two triangles in one plane have in common.
pub(super) fn cells(pair: &Pair<'_>) -> Option<[Cell; 2]> {
    let (axis, sign) = projection_of(*pair.points[0])?;
    let seen = pair.points.map(|triangle| triangle.map(|corner| axis.seen(corner)));
    let signs = [sign, turn_along(axis, *pair.points[1])];
    let [f, g] = [0, 1].map(|which| Half { pair, seen: &seen, which, sign: signs[which] });
    if f.is_shared_alone() || g.is_shared_alone() {
        return Some(pair.shared);
    }
    let (to_second, to_first) = (f.turns(), g.turns());
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

/// One of two triangles, as it is seen.
struct Half<'a> {
    pair: &'a Pair<'a>,
    seen: &'a [[[f64; 2]; 3]; 2],
    /// Which of the two it is.
    which: usize,
    /// Which way it turns.
    sign: Sign,
}

impl Half<'_> {
    /// Whether a side of this triangle shows that the two have nothing but their common corners in common, of which there are
    /// one or two: the side holds them, and all other corners of the other triangle lie strictly beyond it.
    fn is_shared_alone(&self) -> bool {
        let [own, others] = [self.pair.shared[self.which], self.pair.shared[1 - self.which]];
        let holds = |side: usize| own & !(1 << side | 1 << ((side + 1) % 3)) == 0;
        let is_beyond =
            |side: usize, at: usize| others >> at & 1 == 1 || self.turn(side, at) == Sign::Negative;
        own != 0 && (0..3).any(|side| holds(side) && (0..3).all(|at| is_beyond(side, at)))
    }

    /// Where the other triangle's corners lie by all sides.
    fn turns(&self) -> Turns {
        let ends = |side: usize| 1 << side | 1 << ((side + 1) % 3);
        let is_end =
            |side: usize, at: usize| (0..3).any(|own| ends(side) >> own & 1 == 1 && self.is_same(own, at));
        [0, 1, 2]
            .map(|side| [0, 1, 2].map(|at| if is_end(side, at) { Sign::Zero } else { self.turn(side, at) }))
    }

    /// Where a corner of the other triangle lies by a side: positive on the inside.
    fn turn(&self, side: usize, at: usize) -> Sign {
        let own = &self.seen[self.which];
        self.sign * turn(own[side], own[(side + 1) % 3], self.seen[1 - self.which][at])
    }

    fn is_same(&self, own: usize, other: usize) -> bool {
        let [first, second] = if self.which == 0 { [own, other] } else { [other, own] };
        self.pair.same(first) == Some(second)
    }
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
