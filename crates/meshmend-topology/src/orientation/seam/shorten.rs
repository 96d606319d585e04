//! Sides that clash less, step by step.
//!
//! 1. Single faces are turned while more of their signed edges clash than not.
//! 2. Whole regions are turned: of each clashing signed edge the face that is nearer to a seed is held, and of all
//!    sets of other faces within some steps of the seam the best is found by a least cut. So the seam can wander on
//!    the side that it is not held on. The seeds are the faces at two clashing signed edges that are far from one
//!    another.
//! 3. Where nothing is better, a region that costs the same is turned, and 2 is tried from there; if that brings
//!    nothing it is turned back. This is done where the search is over all faces.

use std::collections::VecDeque;

use super::flow::{Budget, Flow, Region, Turn};
use super::sides::Sides;
use super::surroundings::{Reach, Seed, Surroundings};

/// How often each way out of a face is looked at, at most, on the average.
const LOOKS: u64 = 50;

/// A seam that is being shortened.
#[derive(Debug)]
struct Shortening<'a> {
    sides: Sides<'a>,
    reach: Reach,
    flow: Flow,
    surroundings: Surroundings,
    budget: Budget,
}

/// Turns faces so that no more clashes than before. Beyond a budget what was found so far stands.
///
/// *Cost*: at most a fixed number of looks at each way out of a face, on the average.
pub(super) fn shorten(sides: Sides<'_>, reach: Reach) -> Sides<'_> {
    let mut shortening = Shortening {
        flow: Flow::new(&sides),
        surroundings: Surroundings::of(&sides),
        budget: Budget(LOOKS * sides.graph.arc_count() as u64),
        reach,
        sides,
    };
    let all: Vec<u32> = shortening.sides.graph.faces().collect();
    shortening.turn_single_faces(&all);
    shortening.turn_pieces();
    while shortening.turn_regions() || shortening.detour() {}
    shortening.turn_pieces();
    shortening.sides
}

impl Shortening<'_> {
    fn turn_single_faces(&mut self, faces: &[u32]) {
        let graph = self.sides.graph;
        let mut queue: VecDeque<u32> = faces.iter().copied().collect();
        while let Some(face) = queue.pop_front() {
            let is_paid = self.budget.spend(graph.arcs(face).len()).is_some();
            if is_paid && self.sides.is_better_turned(face) {
                self.sides.turn(&[face]);
                queue.extend(graph.arcs(face).iter().map(|arc| arc.to).filter(|&other| other != face));
            }
        }
    }

    /// Turns what clashing signed edges cut off as a whole, so that what does not clash hangs together.
    fn turn_pieces(&mut self) {
        let graph = self.sides.graph;
        let mut is_seen = vec![false; graph.face_count()];
        let mut beyond = VecDeque::from([0]);
        while let Some(start) = beyond.pop_front() {
            if is_seen.get(start as usize).is_none_or(|is_seen| *is_seen) {
                continue;
            }
            let piece = self.piece_of(start, &mut is_seen);
            if start != 0 {
                self.sides.turn(&piece);
            }
            let neighbours = piece.iter().flat_map(|&face| graph.arcs(face)).map(|arc| arc.to);
            beyond.extend(neighbours.filter(|&face| !is_seen[face as usize]));
        }
    }

    /// The faces that hang together with one across signed edges that do not clash, and were not seen yet.
    fn piece_of(&self, start: u32, is_seen: &mut [bool]) -> Vec<u32> {
        let mut piece = vec![start];
        let mut done = 0;
        is_seen[start as usize] = true;
        while let Some(&face) = piece.get(done) {
            done += 1;
            for arc in self.sides.graph.arcs(face) {
                if !is_seen[arc.to as usize] && !self.sides.clashes(arc.signed_edge) {
                    is_seen[arc.to as usize] = true;
                    piece.push(arc.to);
                }
            }
        }
        piece
    }

    /// Turns regions until none is better; whether one was.
    fn turn_regions(&mut self) -> bool {
        let mut is_better = false;
        while self.turn_a_region() {
            is_better = true;
        }
        is_better
    }

    fn turn_a_region(&mut self) -> bool {
        for seed in self.surroundings.seeds(&self.sides, self.reach) {
            let Some((turn, region)) = self.best_turn(seed) else { continue };
            if turn.gain > 0 {
                self.sides.turn(&turn.faces);
                self.turn_single_faces(&region.faces);
                return true;
            }
        }
        false
    }

    /// Turns a region that costs the same, if that makes room for something better.
    fn detour(&mut self) -> bool {
        if self.reach != Reach::All {
            return false;
        }
        for seed in self.surroundings.seeds(&self.sides, self.reach) {
            let Some((turn, _)) = self.best_turn(seed) else { continue };
            if turn.faces.is_empty() {
                continue;
            }
            let before = self.sides.clone();
            self.sides.turn(&turn.faces);
            if self.turn_regions() {
                return true;
            }
            self.sides = before;
        }
        false
    }

    fn best_turn(&mut self, seed: Seed) -> Option<(Turn, Region)> {
        let region = self.surroundings.region(&self.sides, self.reach, seed);
        self.budget.spend(region.faces.len())?;
        let turn = self.flow.best_turn(&self.sides, &region, &mut self.budget)?;
        Some((turn, region))
    }
}
