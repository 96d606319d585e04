//! On which side does each face lie, and what clashes?

use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::orientation::dual_graph::{Arc, SignedGraph};

/// The sides of all faces of a graph.
#[derive(Clone, Debug)]
pub(super) struct Sides<'a> {
    pub(super) graph: &'a SignedGraph,
    /// Whether a face lies on the other side than as stored.
    is_turned: Vec<bool>,
    /// The signed edges that clash and that turning a face can mend: not those of a face with itself.
    clashing: BTreeSet<u32>,
}

impl<'a> Sides<'a> {
    /// Sides chosen before.
    pub(super) fn given(graph: &'a SignedGraph, is_turned: Vec<bool>) -> Self {
        let mut sides = Sides { graph, is_turned, clashing: BTreeSet::new() };
        let is_between_two = |signed_edge: &u32| {
            graph.signed_edge(*signed_edge).ends[0] != graph.signed_edge(*signed_edge).ends[1]
        };
        let signed_edges = (0..graph.signed_edges().len() as u32).filter(is_between_two);
        sides.clashing = signed_edges.filter(|&signed_edge| sides.clashes(signed_edge)).collect();
        sides
    }

    pub(super) fn into_turned(self) -> Vec<bool> {
        self.is_turned
    }

    /// Turns some faces.
    ///
    /// *Cost*: O(d log k) for d ways out of them and k signed edges that clash.
    pub(super) fn turn(&mut self, faces: &[u32]) {
        for &face in faces {
            self.is_turned[face as usize] ^= true;
            for arc in self.graph.arcs(face).iter().filter(|arc| arc.to != face) {
                if !self.clashing.remove(&arc.signed_edge) {
                    self.clashing.insert(arc.signed_edge);
                }
            }
        }
    }

    /// Whether orientation does not pass across a signed edge.
    #[inline]
    pub(super) fn clashes(&self, signed_edge: u32) -> bool {
        let signed_edge = self.graph.signed_edge(signed_edge);
        let [one, other] = signed_edge.ends.map(|face| self.is_turned[face as usize]);
        one ^ other ^ signed_edge.is_mirrored
    }

    /// The signed edges that clash and that turning a face can mend, ascending.
    pub(super) fn clashing(&self) -> impl DoubleEndedIterator<Item = u32> + Clone + '_ {
        self.clashing.iter().copied()
    }

    /// How much clashes that turning faces can mend.
    pub(super) fn cost(&self) -> u64 {
        self.clashing().map(|signed_edge| self.graph.signed_edge(signed_edge).weight).sum()
    }

    /// Whether turning a face leaves less that clashes.
    pub(super) fn is_better_turned(&self, face: u32) -> bool {
        let signed_edges = self.graph.arcs(face).iter().filter(|arc| arc.to != face);
        let (mut clashing, mut agreeing) = (0, 0);
        for &Arc { signed_edge, .. } in signed_edges {
            *(if self.clashes(signed_edge) { &mut clashing } else { &mut agreeing }) +=
                self.graph.signed_edge(signed_edge).weight;
        }
        clashing > agreeing
    }
}

/// The faces that hang together, and sides for them, by walks from the lowest faces: across the heaviest signed edges
/// first, of equal ones across the one that was come to first.
pub(super) struct Walk {
    pub(super) components: Vec<Vec<u32>>,
    pub(super) is_turned: Vec<bool>,
}

impl Walk {
    /// *Cost*: O(n log w) for w different weights.
    pub(super) fn over(graph: &SignedGraph) -> Self {
        let mut walk = Walk { components: Vec::new(), is_turned: vec![false; graph.face_count()] };
        let mut is_seen = vec![false; graph.face_count()];
        let mut waiting = Waiting::default();
        for lowest in graph.faces() {
            if std::mem::replace(&mut is_seen[lowest as usize], true) {
                continue;
            }
            let mut faces = vec![lowest];
            waiting.add_from(graph, lowest);
            while let Some((from, Arc { signed_edge, to })) = waiting.next() {
                if std::mem::replace(&mut is_seen[to as usize], true) {
                    continue;
                }
                walk.is_turned[to as usize] =
                    walk.is_turned[from as usize] ^ graph.signed_edge(signed_edge).is_mirrored;
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
    fn add_from(&mut self, graph: &SignedGraph, face: u32) {
        for &arc in graph.arcs(face) {
            self.0.entry(graph.signed_edge(arc.signed_edge).weight).or_default().push_back((face, arc));
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
