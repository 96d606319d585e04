//! All faces compared with each other at once, near ones together.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use meshmend_core::FaceId;
use rayon::prelude::*;

use super::STEP;
use super::hits::{Hit, Met, Piece, hit};
use super::run::Subject;
use crate::boxes::{FewBoxes, JoinPart, Leaf};

/// How many leaves are remembered as the first of two, and as the second.
const REMEMBERED: [usize; 2] = [8, 64];
/// After so many tests others are told of them.
const TOLD: u64 = 4096;
/// A search of the whole keeps what meets, if it is not more than one pair a face and so many.
const KEPT: u64 = 65_536;

/// What was found among all faces.
#[derive(Default)]
pub(super) struct Joined {
    /// The pairs of triangles of different faces that meet, in any order.
    pub(super) met: Vec<Met>,
    /// The faces of which two triangles cross, in any order.
    pub(super) self_crossing: Vec<FaceId>,
}

/// All that meets; `None` if more pairs are tested than the budget has, or more meet than are kept, or whoever watches has stopped
/// it. Which of the first two it is does not depend on the number of threads.
pub(super) fn joined(subject: &Subject<'_>, budget: u64) -> Option<Joined> {
    let kept = subject.surface.mesh().counts().faces as u64 + KEPT;
    let counts = [Bounded::to(budget), Bounded::to(kept)];
    let parts = subject.tree.join_parts().into_par_iter();
    let search = |leaves: &mut Leaves<'_>, part| leaves.search(part, &counts);
    let found: Vec<Joined> = parts.map_init(|| Leaves::of(subject), search).collect::<Option<_>>()?;
    let mut total = Joined::default();
    for part in found {
        total.met.extend(part.met);
        total.self_crossing.extend(part.self_crossing);
    }
    Some(total)
}

/// A number that several threads add to, and its bound.
struct Bounded {
    count: AtomicU64,
    most: u64,
}

impl Bounded {
    fn to(most: u64) -> Self {
        Bounded { count: AtomicU64::new(0), most }
    }

    /// Adds to the number, and breaks off if it is beyond its bound.
    fn add(&self, more: u64) -> ControlFlow<()> {
        let before = self.count.fetch_add(more, Ordering::Relaxed);
        if before + more > self.most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

/// The leaves of the tree, those remembered that were asked for last.
struct Leaves<'a> {
    subject: &'a Subject<'a>,
    firsts: Vec<Remembered>,
    seconds: Vec<Remembered>,
}

/// The triangles of a leaf.
#[derive(Clone)]
struct Remembered {
    leaf: Option<usize>,
    pieces: Vec<Piece>,
    boxes: FewBoxes,
}

impl<'a> Leaves<'a> {
    fn of(subject: &'a Subject<'a>) -> Self {
        let [firsts, seconds] = REMEMBERED
            .map(|count| vec![Remembered { leaf: None, pieces: Vec::new(), boxes: FewBoxes::new() }; count]);
        Leaves { subject, firsts, seconds }
    }

    /// What meets in a part of the search; `None` if a count goes beyond its bound.
    fn search(&mut self, part: JoinPart, [all_tests, all_met]: &[Bounded; 2]) -> Option<Joined> {
        let mut found = Joined::default();
        let (mut tests, mut told) = (0, 0);
        let watch = self.subject.surface.watch();
        let mut tell = |tests: u64, met: usize| {
            all_tests.add(tests)?;
            if watch.look(STEP, 0, 0).is_err() {
                return ControlFlow::Break(());
            }
            all_met.add((met - std::mem::replace(&mut told, met)) as u64)
        };
        let ended = self.subject.tree.join(part, &mut |leaves| {
            tests += self.compare(leaves, &mut found);
            if tests < TOLD {
                ControlFlow::Continue(())
            } else {
                tell(std::mem::take(&mut tests), found.met.len())
            }
        });
        let is_within = ended.is_continue() && tell(tests, found.met.len()).is_continue();
        is_within.then_some(found)
    }

    /// Compares the triangles of two leaves, or of one, and tells how many pairs were tested.
    fn compare(&mut self, [one, other]: [Leaf; 2], found: &mut Joined) -> u64 {
        let Subject { surface, tree, .. } = self.subject;
        let mut tests = 0;
        let mut test = |f: &Piece, g: &Piece| {
            if !f.bounds.overlaps(&g.bounds) {
                return;
            }
            tests += 1;
            let (f, g) = if f.number < g.number { (f, g) } else { (g, f) };
            match hit(surface, f, g) {
                Some(Hit::SelfCrossing(face)) => found.self_crossing.push(face),
                Some(Hit::Faces(met)) => found.met.push(met),
                None => {}
            }
        };
        let is_one = one.number == other.number;
        let box_of_second = tree.bounds_of_leaf(other.number);
        let firsts = remembered(self.subject, &mut self.firsts, one);
        if is_one {
            for (at, f) in firsts.pieces.iter().enumerate() {
                let later = firsts.boxes.overlapping(&f.bounds) & !1 << at;
                firsts.each_of(later, |g| test(f, g));
            }
        } else {
            let seconds = remembered(self.subject, &mut self.seconds, other);
            firsts.each_of(firsts.boxes.overlapping(box_of_second), |f| {
                seconds.each_of(seconds.boxes.overlapping(&f.bounds), |g| test(f, g));
            });
        }
        tests
    }
}

impl Remembered {
    /// The triangles of some bits.
    #[inline]
    fn each_of(&self, mut bits: u32, mut found: impl FnMut(&Piece)) {
        while bits != 0 {
            if let Some(piece) = self.pieces.get(bits.trailing_zeros() as usize) {
                found(piece);
            }
            bits &= bits - 1;
        }
    }
}

/// A leaf, remembered or gathered.
fn remembered<'l>(subject: &Subject<'_>, all: &'l mut [Remembered], leaf: Leaf) -> &'l Remembered {
    let place = leaf.number % all.len();
    let known = &mut all[place];
    if known.leaf != Some(leaf.number) {
        known.leaf = Some(leaf.number);
        known.pieces.clear();
        known.boxes = FewBoxes::new();
        for (place, &number) in subject.tree.items()[leaf.items].iter().enumerate() {
            let piece = Piece::of(subject.surface, number);
            known.boxes.set(place, &piece.bounds);
            known.pieces.push(piece);
        }
    }
    known
}
