//! How two triangles meet: the smallest cells of each that hold all that they have in common.
//!
//! All is decided by the sides of planes and lines on which corners lie. Nothing is constructed.

mod contact;
mod in_plane;
mod on_line;
mod seen;
mod shown;

use meshmend_geometry::vector::Point;

use crate::exact::{Plane, Sign};
use crate::surface::{Cell, WHOLE};

pub use contact::Contact;
pub(crate) use shown::shown_point;

/// Two triangles of positive area, and which of their corners are at one position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair<'a> {
    /// The corners of each.
    points: [&'a [Point; 3]; 2],
    /// Bit 3 i + k says whether corner i of the first is at the position of corner k of the second.
    same: u16,
    /// The corners of each that the other has too.
    shared: [Cell; 2],
}

/// Where two triangles meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Meeting {
    /// The smallest cell of each that holds all that they have in common.
    pub(crate) cells: [Cell; 2],
    /// Whether the triangles lie in one plane.
    pub(crate) is_coplanar: bool,
}

impl<'a> Pair<'a> {
    /// Two triangles, the names of whose corners are equal where their positions are.
    #[inline]
    pub(crate) fn named<N: PartialEq + Copy>(points: [&'a [Point; 3]; 2], [f, g]: [[N; 3]; 2]) -> Self {
        let row =
            |name: N| u16::from(name == g[0]) | u16::from(name == g[1]) << 1 | u16::from(name == g[2]) << 2;
        let [a, b, c] = f.map(row);
        let of_first = u8::from(a != 0) | u8::from(b != 0) << 1 | u8::from(c != 0) << 2;
        Pair { points, same: a | b << 3 | c << 6, shared: [of_first, (a | b | c) as Cell] }
    }

    /// The corner of the second triangle that is at the position of a corner of the first.
    #[inline]
    fn same(&self, corner: usize) -> Option<usize> {
        let row = self.same >> (3 * corner) & 0b111;
        (row != 0).then(|| row.trailing_zeros() as usize)
    }

    /// How the triangles meet; `None` if they are apart.
    ///
    /// *Cost*: constant, up to ten signs in space or twenty in a plane.
    #[inline]
    pub(crate) fn meeting(&self) -> Option<Meeting> {
        if self.is_coincident() {
            return Some(Meeting { cells: [WHOLE; 2], is_coplanar: true });
        }
        let of_second = self.sides_of(1);
        if self.meet_in_shared_alone(of_second) {
            return self.in_shared();
        }
        if of_second == [Sign::Zero; 3] {
            return in_plane::cells(self).map(|cells| Meeting { cells, is_coplanar: true });
        }
        let of_first = self.sides_of(0);
        if self.meet_in_shared_alone(of_first) {
            return self.in_shared();
        }
        on_line::cells(self, [of_first, of_second]).map(|cells| Meeting { cells, is_coplanar: false })
    }

    /// Whether the triangles have the same three corners.
    #[inline]
    pub(crate) fn is_coincident(&self) -> bool {
        self.shared[0] == WHOLE
    }

    /// Whether a cell of each is the same corner or the same side.
    #[inline]
    pub(crate) fn is_proper(&self, cells: [Cell; 2]) -> bool {
        if cells == self.shared {
            return cells[0] != WHOLE;
        }
        let [f, g] = cells;
        let corners = (0..3).filter(|at| f >> at & 1 == 1).map(|at| self.same(at));
        let image = corners.map(|other| other.map(|at| 1 << at)).sum::<Option<Cell>>();
        f != WHOLE && image == Some(g)
    }

    /// Triangles that have their common corners in common and nothing else; not in one plane.
    fn in_shared(&self) -> Option<Meeting> {
        (self.shared[0] != 0).then_some(Meeting { cells: self.shared, is_coplanar: false })
    }

    /// On which side of the other triangle's plane the corners of the first one (0) or the second (1) lie.
    #[inline]
    fn sides_of(&self, which: usize) -> [Sign; 3] {
        let (plane, corners) = (Plane::of(*self.points[1 - which]), self.points[which]);
        let side = |at: usize| {
            if self.shared[which] >> at & 1 == 1 { Sign::Zero } else { plane.side(corners[at]) }
        };
        [side(0), side(1), side(2)]
    }

    /// Whether the triangles have nothing but their common corners in common, as the sides of a plane tell on which one's
    /// corners lie: then no other corner is on the plane, and none across it.
    #[inline]
    fn meet_in_shared_alone(&self, sides: [Sign; 3]) -> bool {
        let count = |sign: Sign| sides.iter().filter(|&&side| side == sign).count() as u32;
        let others = 3 - self.shared[0].count_ones();
        count(Sign::Positive) == others || count(Sign::Negative) == others
    }
}

#[cfg(test)]
mod tests;
