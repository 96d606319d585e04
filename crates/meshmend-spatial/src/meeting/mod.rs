//! How two triangles meet: the smallest cells of each that hold all that they have in common.
//!
//! All is decided by the sides of planes and lines on which corners lie. Nothing is constructed.

mod contact;
mod in_plane;
mod on_line;
mod shown;

use meshmend_geometry::vector::Point;

use crate::exact::{Sign, side_of_plane};
use crate::surface::{Cell, WHOLE};

pub use contact::Contact;
pub(crate) use shown::shown_point;

/// Two triangles of positive area, and which of their corners are at one position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    /// The corners of each.
    points: [[Point; 3]; 2],
    /// For each corner of the first the one of the second at its position.
    same: [Option<usize>; 3],
}

/// Where two triangles meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Meeting {
    /// The smallest cell of each that holds all that they have in common.
    pub(crate) cells: [Cell; 2],
    /// Whether the triangles lie in one plane.
    pub(crate) is_coplanar: bool,
}

impl Pair {
    /// Two triangles, the names of whose corners are equal where their positions are.
    #[inline]
    pub(crate) fn named<N: PartialEq + Copy>(points: [[Point; 3]; 2], [f, g]: [[N; 3]; 2]) -> Self {
        Pair { points, same: f.map(|name| g.iter().position(|&other| other == name)) }
    }

    /// How the triangles meet; `None` if they are apart.
    ///
    /// *Cost*: constant, up to ten signs in space or twenty in a plane.
    pub(crate) fn meeting(&self) -> Option<Meeting> {
        let shared = self.same.iter().flatten().count();
        if shared == 3 {
            return Some(Meeting { cells: [WHOLE; 2], is_coplanar: true });
        }
        let of_second = self.sides_of_second();
        if meets_in_shared_alone(of_second, shared) {
            return self.in_shared();
        }
        if of_second == [Sign::Zero; 3] {
            return in_plane::cells(self).map(|cells| Meeting { cells, is_coplanar: true });
        }
        let of_first = self.swapped().sides_of_second();
        if meets_in_shared_alone(of_first, shared) {
            return self.in_shared();
        }
        on_line::cells(self, [of_first, of_second]).map(|cells| Meeting { cells, is_coplanar: false })
    }

    /// Whether the triangles have the same three corners.
    pub(crate) fn is_coincident(&self) -> bool {
        self.same.iter().all(Option::is_some)
    }

    /// Whether a cell of each is the same corner or the same side.
    pub(crate) fn is_proper(&self, [f, g]: [Cell; 2]) -> bool {
        f != WHOLE && self.image(f) == Some(g)
    }

    /// Triangles in two planes that have their common corners in common and nothing else.
    fn in_shared(&self) -> Option<Meeting> {
        let shared: Cell = (0..3).filter(|&at| self.same[at].is_some()).map(|at| 1 << at).sum();
        let image = self.image(shared).filter(|&image| image != 0)?;
        Some(Meeting { cells: [shared, image], is_coplanar: false })
    }

    /// The second triangle's cell that has the same corners as one of the first's.
    fn image(&self, cell: Cell) -> Option<Cell> {
        let corners = (0..3).filter(|at| cell >> at & 1 == 1).map(|at| self.same[at]);
        corners.map(|other| other.map(|at| 1 << at)).sum()
    }

    /// The second triangle first.
    fn swapped(&self) -> Self {
        let [f, g] = self.points;
        let same = std::array::from_fn(|at| self.same.iter().position(|&other| other == Some(at)));
        Pair { points: [g, f], same }
    }

    /// On which side of the first triangle's plane the corners of the second lie.
    fn sides_of_second(&self) -> [Sign; 3] {
        let [f, g] = self.points;
        std::array::from_fn(
            |at| {
                if self.same.contains(&Some(at)) { Sign::Zero } else { side_of_plane(f, g[at]) }
            },
        )
    }
}

/// Whether triangles with so many common corners have nothing else in common, as the sides of a plane tell on which one's
/// corners lie: then no other corner is on the plane, and none across it.
fn meets_in_shared_alone(sides: [Sign; 3], shared: usize) -> bool {
    let count = |sign: Sign| sides.iter().filter(|&&side| side == sign).count();
    count(Sign::Positive) == 3 - shared || count(Sign::Negative) == 3 - shared
}

#[cfg(test)]
mod tests;
