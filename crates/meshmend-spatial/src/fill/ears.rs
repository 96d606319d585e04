//! Fills an opening by ears: of all corners that can be cut off, the one is next whose triangle folds least.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use meshmend_geometry::polygon::Triangle;

use super::facet::{Direction, Facet};
use super::neighbours::ascending;
use super::scaled::Scaled;
use super::{FillBy, Opening};

/// The triangles in the order in which they are cut off; `None` where no corner that is left can be.
///
/// *Cost*: O(n log n).
pub(super) fn by_ears(opening: &Opening<'_>, scaled: &Scaled, by: FillBy) -> Option<Vec<Triangle>> {
    let count = scaled.len();
    let mut front = Front {
        opening,
        scaled,
        by,
        next: (0..count).map(|corner| (corner + 1) % count).collect(),
        last: (0..count).map(|corner| (corner + count - 1) % count).collect(),
        behind: (0..count).map(|corner| scaled.beside(corner)).collect(),
        stamps: vec![0; count],
        left: count,
        ears: BinaryHeap::with_capacity(2 * count),
    };
    (0..count).for_each(|corner| front.offer(corner));
    let mut triangles = Vec::with_capacity(count - 2);
    while front.left > 2 {
        let Reverse(ear) = front.ears.pop()?;
        if front.stamps[ear.corner] == ear.stamp {
            triangles.push(front.cut(ear.corner));
        }
    }
    Some(triangles)
}

/// What is not filled yet: a loop of corners.
struct Front<'a> {
    opening: &'a Opening<'a>,
    scaled: &'a Scaled,
    by: FillBy,
    next: Vec<usize>,
    last: Vec<usize>,
    /// For each corner the direction of what lies behind the side that begins there.
    behind: Vec<Direction>,
    /// How often the surroundings of each corner changed. A corner that was cut off has none of these numbers.
    stamps: Vec<u32>,
    left: usize,
    ears: BinaryHeap<Reverse<Ear>>,
}

impl Front<'_> {
    fn triangle(&self, corner: usize) -> Triangle {
        [self.last[corner], corner, self.next[corner]]
    }

    /// Puts the ear at a corner among those that can be cut off, if it can.
    fn offer(&mut self, corner: usize) {
        let [before, _, after] = self.triangle(corner);
        let closes = self.left == 3;
        let is_barred = !closes && (self.opening.is_joined)(before, after)
            || (self.opening.is_there)(ascending(self.triangle(corner)));
        if is_barred {
            return;
        }
        let facet = self.facet(corner);
        let mut sides = vec![self.behind[before], self.behind[corner]];
        sides.extend(closes.then(|| self.behind[after]));
        let fold = sides.into_iter().map(|side| facet.direction.fold(side)).fold(0.0, f64::max);
        let worst = match self.by {
            FillBy::Fold => fold,
            FillBy::Area => facet.area,
        };
        let length = self.scaled.distance(before, after);
        let (is_flat, stamp) = (facet.is_flat, self.stamps[corner]);
        self.ears.push(Reverse(Ear { is_flat, worst, length, corner, stamp }));
    }

    /// Cuts the ear at a corner off, and looks at its neighbours again.
    fn cut(&mut self, corner: usize) -> Triangle {
        let triangle = self.triangle(corner);
        let [before, _, after] = triangle;
        self.behind[before] = self.facet(corner).direction;
        self.next[before] = after;
        self.last[after] = before;
        self.left -= 1;
        self.stamps[corner] = u32::MAX;
        let mut near = vec![before, after];
        if self.left == 3 {
            near.push(self.next[after]);
        }
        for corner in near {
            self.stamps[corner] += 1;
            self.offer(corner);
        }
        ascending(triangle)
    }

    fn facet(&self, corner: usize) -> Facet {
        // Against the order of places only where the loop closes: then the triangle begins elsewhere.
        Facet::of(self.triangle(corner).map(|at| self.scaled.point(at)))
    }
}

/// A corner that can be cut off.
#[derive(Clone, Copy, PartialEq)]
struct Ear {
    is_flat: bool,
    worst: f64,
    length: f64,
    corner: usize,
    stamp: u32,
}

impl Eq for Ear {}

impl Ord for Ear {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.is_flat.cmp(&other.is_flat))
            .then(self.worst.total_cmp(&other.worst))
            .then(self.length.total_cmp(&other.length))
            .then((self.corner, self.stamp).cmp(&(other.corner, other.stamp)))
    }
}

impl PartialOrd for Ear {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
