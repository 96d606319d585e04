//! On which side does each face lie, and what clashes?

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::joints::{Arc, TieGraph};

/// The sides of all faces of a graph.
#[derive(Clone, Debug)]
pub(super) struct Sides<'a> {
    pub(super) graph: &'a TieGraph,
    /// Whether a face lies on the other side than as stored.
    is_turned: Vec<bool>,
    /// The ties that clash and that turning a face can mend: not those of a face with itself.
    clashing: BTreeSet<u32>,
}

impl<'a> Sides<'a> {
    /// Sides chosen before.
    pub(super) fn given(graph: &'a TieGraph, is_turned: Vec<bool>) -> Self {
        let mut sides = Sides { graph, is_turned, clashing: BTreeSet::new() };
        let is_between_two = |tie: &u32| graph.tie(*tie).ends[0] != graph.tie(*tie).ends[1];
        let ties = (0..graph.ties().len() as u32).filter(is_between_two);
        sides.clashing = ties.filter(|&tie| sides.clashes(tie)).collect();
        sides
    }

    pub(super) fn into_turned(self) -> Vec<bool> {
        self.is_turned
    }

    /// Turns some faces.
    ///
    /// *Cost*: O(d log k) for d ways out of them and k ties that clash.
    pub(super) fn turn(&mut self, faces: &[u32]) {
        for &face in faces {
            self.is_turned[face as usize] ^= true;
            for arc in self.graph.arcs(face).iter().filter(|arc| arc.to != face) {
                if !self.clashing.remove(&arc.tie) {
                    self.clashing.insert(arc.tie);
                }
            }
        }
    }

    /// Whether orientation does not pass across a tie.
    #[inline]
    pub(super) fn clashes(&self, tie: u32) -> bool {
        let tie = self.graph.tie(tie);
        let [one, other] = tie.ends.map(|face| self.is_turned[face as usize]);
        one ^ other ^ tie.is_mirrored
    }

    /// The ties that clash and that turning a face can mend, ascending.
    pub(super) fn clashing(&self) -> impl DoubleEndedIterator<Item = u32> + Clone + '_ {
        self.clashing.iter().copied()
    }

    /// How much clashes that turning faces can mend.
    pub(super) fn cost(&self) -> u64 {
        self.clashing().map(|tie| self.graph.tie(tie).weight).sum()
    }

    /// Whether turning a face leaves less that clashes.
    pub(super) fn is_better_turned(&self, face: u32) -> bool {
        let ties = self.graph.arcs(face).iter().filter(|arc| arc.to != face);
        let (mut clashing, mut agreeing) = (0, 0);
        for &Arc { tie, .. } in ties {
            *(if self.clashes(tie) { &mut clashing } else { &mut agreeing }) += self.graph.tie(tie).weight;
        }
        clashing > agreeing
    }
}

/// The faces that hang together, and sides for them, by walks from the lowest faces: across the heaviest ties first, of
/// equal ones across the one that was come to first.
pub(super) struct Walk {
    pub(super) components: Vec<Vec<u32>>,
    pub(super) is_turned: Vec<bool>,
}

impl Walk {
    /// *Cost*: O(n log w) for w different weights.
    pub(super) fn over(graph: &TieGraph) -> Self {
        let mut walk = Walk { components: Vec::new(), is_turned: vec![false; graph.face_count()] };
        let mut is_seen = vec![false; graph.face_count()];
        let mut waiting = Waiting::default();
        for lowest in graph.faces() {
            if std::mem::replace(&mut is_seen[lowest as usize], true) {
                continue;
            }
            let mut faces = vec![lowest];
            waiting.add_from(graph, lowest);
            while let Some((from, Arc { tie, to })) = waiting.next() {
                if std::mem::replace(&mut is_seen[to as usize], true) {
                    continue;
                }
                walk.is_turned[to as usize] = walk.is_turned[from as usize] ^ graph.tie(tie).is_mirrored;
                faces.push(to);
                waiting.add_from(graph, to);
            }
            walk.components.push(faces);
        }
        walk
    }
}

/// Ways that were not taken yet, each with where it begins, by weight.
#[derive(Default)]
struct Waiting(BTreeMap<u64, VecDeque<(u32, Arc)>>);

impl Waiting {
    fn add_from(&mut self, graph: &TieGraph, face: u32) {
        for &arc in graph.arcs(face) {
            self.0.entry(graph.tie(arc.tie).weight).or_default().push_back((face, arc));
        }
    }

    fn next(&mut self) -> Option<(u32, Arc)> {
        let mut heaviest = self.0.last_entry()?;
        let way = heaviest.get_mut().pop_front();
        if heaviest.get().is_empty() {
            heaviest.remove();
        }
        way
    }
}
