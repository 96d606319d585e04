//! Which faces are best turned, when some stay as they are?
//!
//! With one face of every clashing signed edge held, what the others cost is a cut: a signed edge that does not clash
//! costs its weight when just one of its faces is turned; one that does, when its free face is not. The least cut is
//! found by a greatest flow from the held faces, through the signed edges that do not clash, to the free faces of
//! those that do.
//!
//! *Source*: E. A. Dinitz, *Algorithm for solution of a problem of maximum flow in networks with power estimation*,
//! 1970; for cuts that choose sides: V. Kolmogorov, R. Zabih, *What energy functions can be minimized via graph
//! cuts?*, 2004.

use super::sides::Sides;
use crate::orientation::dual_graph::Arc;

/// What is left of the looks at ways out of faces that may be taken.
#[derive(Debug)]
pub(super) struct Budget(pub(super) u64);

impl Budget {
    /// Takes some looks, if there are as many.
    pub(super) fn spend(&mut self, looks: usize) -> Option<()> {
        self.0 = self.0.checked_sub(looks as u64)?;
        Some(())
    }
}

/// The faces among which some are chosen to be turned.
#[derive(Debug)]
pub(super) struct Region {
    /// All faces of the region, the held ones among them.
    pub(super) faces: Vec<u32>,
    /// Faces that stay as they are; every way out of the region leads from one of them.
    pub(super) held: Vec<u32>,
    /// The clashing signed edges between a held face and a free one, each with the free one.
    pub(super) clashing: Vec<(u32, u32)>,
}

/// What turning faces would bring.
#[derive(Debug)]
pub(super) struct Turn {
    /// How much less would clash.
    pub(super) gain: u64,
    /// The faces to turn: as many as can be for this gain.
    pub(super) faces: Vec<u32>,
}

/// A flow, and the memory to find one.
#[derive(Debug)]
pub(super) struct Flow {
    /// What flows over each signed edge from its first face to its second.
    along: Vec<i64>,
    /// What may still leave the network at each face.
    outlet: Vec<u64>,
    /// How far each face is from the held ones.
    level: Vec<u32>,
    /// The first way out of each face that may lead on.
    next: Vec<u32>,
    queue: Vec<u32>,
}

const UNREACHED: u32 = u32::MAX;
/// No way leads on from here, or the face is not in the region.
const DEAD_END: u32 = u32::MAX - 1;

impl Flow {
    pub(super) fn new(sides: &Sides<'_>) -> Self {
        let (faces, signed_edges) = (sides.graph.face_count(), sides.graph.signed_edges().len());
        Flow {
            along: vec![0; signed_edges],
            outlet: vec![0; faces],
            level: vec![DEAD_END; faces],
            next: vec![0; faces],
            queue: Vec::new(),
        }
    }

    /// The best set of a region's faces to turn; `None` beyond the budget.
    pub(super) fn best_turn(
        &mut self,
        sides: &Sides<'_>,
        region: &Region,
        budget: &mut Budget,
    ) -> Option<Turn> {
        let found = self.cut(sides, region, budget);
        region.faces.iter().for_each(|&face| self.level[face as usize] = DEAD_END);
        found
    }

    fn cut(&mut self, sides: &Sides<'_>, region: &Region, budget: &mut Budget) -> Option<Turn> {
        for &face in &region.faces {
            self.outlet[face as usize] = 0;
            sides.graph.arcs(face).iter().for_each(|arc| self.along[arc.signed_edge as usize] = 0);
        }
        let mut gain = 0;
        for &(signed_edge, free) in &region.clashing {
            self.outlet[free as usize] += sides.graph.signed_edge(signed_edge).weight;
            gain += sides.graph.signed_edge(signed_edge).weight;
        }
        while let Some(depth) = self.find_levels(sides, region, budget)? {
            for &held in &region.held {
                gain -= self.push_from(sides, held, depth, budget)?;
            }
        }
        let is_cut_off = |face: &u32| self.level[*face as usize] == UNREACHED;
        Some(Turn { gain, faces: region.faces.iter().copied().filter(is_cut_off).collect() })
    }

    /// What could still flow from a face over a signed edge.
    #[inline]
    fn room(&self, sides: &Sides<'_>, from: u32, arc: Arc) -> u64 {
        if sides.clashes(arc.signed_edge) {
            return 0;
        }
        let (signed_edge, along) =
            (sides.graph.signed_edge(arc.signed_edge), self.along[arc.signed_edge as usize]);
        signed_edge.weight.saturating_add_signed(if signed_edge.ends[0] == from { -along } else { along })
    }

    /// The distances from the held faces along ways with room, up to the nearest outlet; its distance, if one is
    /// reached.
    fn find_levels(
        &mut self,
        sides: &Sides<'_>,
        region: &Region,
        budget: &mut Budget,
    ) -> Option<Option<u32>> {
        for &face in &region.faces {
            (self.level[face as usize], self.next[face as usize]) = (UNREACHED, 0);
        }
        region.held.iter().for_each(|&held| self.level[held as usize] = 0);
        self.queue.clear();
        self.queue.extend(&region.held);
        let (mut depth, mut done) = (None, 0);
        while let Some(&face) = self.queue.get(done) {
            done += 1;
            let level = self.level[face as usize];
            if depth.is_some_and(|depth| level >= depth) {
                break;
            }
            budget.spend(sides.graph.arcs(face).len())?;
            for &arc in sides.graph.arcs(face) {
                if self.level[arc.to as usize] == UNREACHED && self.room(sides, face, arc) > 0 {
                    self.level[arc.to as usize] = level + 1;
                    self.queue.push(arc.to);
                    if self.outlet[arc.to as usize] > 0 {
                        depth = Some(level + 1);
                    }
                }
            }
        }
        Some(depth)
    }

    /// Lets flow from a held face what can flow over ways of this length; how much.
    fn push_from(&mut self, sides: &Sides<'_>, held: u32, depth: u32, budget: &mut Budget) -> Option<u64> {
        let (mut flown, mut at) = (0, held);
        let mut path: Vec<(u32, Arc)> = Vec::new();
        loop {
            if self.level[at as usize] == depth && self.outlet[at as usize] > 0 {
                budget.spend(path.len())?;
                flown += self.push_along(sides, &path, at);
                let full = path.iter().position(|&(from, arc)| self.room(sides, from, arc) == 0);
                if let Some(full) = full {
                    at = path[full].0;
                    path.truncate(full);
                }
                continue;
            }
            match self.way_on(sides, at, budget)? {
                Some(arc) => {
                    path.push((at, arc));
                    at = arc.to;
                }
                None => {
                    self.level[at as usize] = DEAD_END;
                    let Some((from, _)) = path.pop() else { return Some(flown) };
                    at = from;
                }
            }
        }
    }

    /// Fills a path up to an outlet; how much more flows now.
    fn push_along(&mut self, sides: &Sides<'_>, path: &[(u32, Arc)], outlet: u32) -> u64 {
        let rooms = path.iter().map(|&(from, arc)| self.room(sides, from, arc));
        let amount = rooms.min().unwrap_or(0).min(self.outlet[outlet as usize]);
        self.outlet[outlet as usize] -= amount;
        for &(from, arc) in path {
            let is_along = sides.graph.signed_edge(arc.signed_edge).ends[0] == from;
            self.along[arc.signed_edge as usize] += if is_along { amount as i64 } else { -(amount as i64) };
        }
        amount
    }

    /// The next way out of a face that leads a level on and has room.
    fn way_on(&mut self, sides: &Sides<'_>, face: u32, budget: &mut Budget) -> Option<Option<Arc>> {
        let arcs = sides.graph.arcs(face);
        while let Some(&arc) = arcs.get(self.next[face as usize] as usize) {
            budget.spend(1)?;
            if self.level[arc.to as usize] == self.level[face as usize] + 1 && self.room(sides, face, arc) > 0
            {
                return Some(Some(arc));
            }
            self.next[face as usize] += 1;
        }
        Some(None)
    }
}
