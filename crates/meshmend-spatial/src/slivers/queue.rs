//! Which sliver comes next: needles first, the shortest edge first, then caps, the least aspect first.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use meshmend_core::FaceId;
use meshmend_geometry::vector::Point;

use super::measure::shortest_square;
use crate::SliverKind;
use crate::shape::aspect;

/// Where a sliver stands in the queue. Lengths and aspects are not negative, so that their bits are in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Turn {
    kind: SliverKind,
    size: u64,
    face: FaceId,
}

/// The slivers that wait.
#[derive(Default)]
pub(super) struct Queue {
    turns: BinaryHeap<Reverse<Turn>>,
}

impl Queue {
    /// Lets a sliver wait.
    pub(super) fn push(&mut self, face: FaceId, kind: SliverKind, points: [Point; 3]) {
        let size = match kind {
            SliverKind::Needle => shortest_square(points),
            SliverKind::Cap => aspect(points),
        };
        let turn = Turn { kind, size: size.to_bits(), face };
        self.turns.push(Reverse(turn));
    }

    /// The next face, which may have changed since it was put in.
    pub(super) fn pop(&mut self) -> Option<FaceId> {
        self.turns.pop().map(|Reverse(turn)| turn.face)
    }
}
