//! How short is the shortest way round through a face that comes back mirrored?
//!
//! In the *orientation double cover* there are two copies of each face, and a signed edge leads from a copy to the
//! copy of the neighbour on the same side, or on the other one where it mirrors. A strip that comes back mirrored is
//! a way from one copy of a face to the other. The cover looks the same from both copies, so one search from one of
//! them tells the distances from both, and it need not go farther than half the way.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::orientation::dual_graph::SignedGraph;

/// A copy of a face: twice its place, and one more on the other side.
type Copy = u32;

/// The same face on the other side.
fn other_copy(copy: Copy) -> Copy {
    copy ^ 1
}

/// A search through the double cover of a graph, in memory that is used again.
#[derive(Debug)]
pub(super) struct Search<'a> {
    graph: &'a SignedGraph,
    /// The length of the shortest way known to each copy; `UNREACHED` where there is none.
    distance: Vec<u64>,
    reached: Vec<Copy>,
    front: BinaryHeap<Reverse<(u64, Copy)>>,
    /// How many more ways out of a face may be looked at.
    budget: u64,
}

const UNREACHED: u64 = u64::MAX;

/// The shortest mirrored strips through a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Round {
    pub(super) length: u64,
    /// The place of the lowest face that any of them goes through.
    pub(super) lowest: u32,
}

/// The budget is spent.
#[derive(Debug)]
pub(super) struct Spent;

impl<'a> Search<'a> {
    pub(super) fn new(graph: &'a SignedGraph, budget: u64) -> Self {
        let distance = vec![UNREACHED; 2 * graph.face_count()];
        Search { graph, distance, reached: Vec::new(), front: BinaryHeap::new(), budget }
    }

    /// The shortest mirrored strips through a face, if they are no longer than a bound.
    pub(super) fn round(&mut self, face: u32, bound: u64) -> Result<Option<Round>, Spent> {
        self.begin(face);
        let mut length = bound.saturating_add(1);
        while let Some(copy) = self.settle_next(|distance| distance.saturating_mul(2) <= length)? {
            let here = self.distance[copy as usize];
            for (next, weight) in ways(self.graph, copy) {
                let there = self.distance[other_copy(next) as usize];
                if there != UNREACHED {
                    length = length.min(here + weight + there);
                }
            }
        }
        if length > bound {
            return Ok(None);
        }
        let lowest = self.lowest_face_within(length)?;
        Ok(Some(Round { length, lowest }))
    }

    /// Of the shortest mirrored strips through a face, of this length, the one with the lowest signed edges: the
    /// signed edges from the face on.
    pub(super) fn lowest_signed_edges(&mut self, face: u32, length: u64) -> Vec<u32> {
        self.begin(face);
        self.budget = u64::MAX;
        while let Ok(Some(_)) = self.settle_next(|distance| distance <= length) {}
        // The way on from a copy to the far end is as long as the way from the near end to the other copy.
        let on = |at: Copy, left: u64| {
            self.graph.arcs(at / 2).iter().find_map(|arc| {
                let signed_edge = self.graph.signed_edge(arc.signed_edge);
                let next = 2 * arc.to + (at & 1 ^ u32::from(signed_edge.is_mirrored));
                let rest = left.checked_sub(signed_edge.weight)?;
                (self.distance[other_copy(next) as usize] == rest).then_some((arc.signed_edge, next, rest))
            })
        };
        let (mut at, mut left) = (2 * face, length);
        let mut signed_edges = Vec::new();
        // Every signed edge counts something, so nothing leads on when nothing is left.
        while let Some((signed_edge, next, rest)) = on(at, left) {
            signed_edges.push(signed_edge);
            (at, left) = (next, rest);
        }
        signed_edges
    }

    fn begin(&mut self, face: u32) {
        self.reached.drain(..).for_each(|copy| self.distance[copy as usize] = UNREACHED);
        self.front.clear();
        self.reach(2 * face, 0);
    }

    fn reach(&mut self, copy: Copy, distance: u64) {
        let known = &mut self.distance[copy as usize];
        if distance < *known {
            if *known == UNREACHED {
                self.reached.push(copy);
            }
            *known = distance;
            self.front.push(Reverse((distance, copy)));
        }
    }

    /// Settles the nearest copy that is not settled, and reaches its neighbours; `None` where it is too far.
    fn settle_next(&mut self, is_near: impl Fn(u64) -> bool) -> Result<Option<Copy>, Spent> {
        while let Some(Reverse((distance, copy))) = self.front.pop() {
            if distance > self.distance[copy as usize] {
                continue;
            }
            if !is_near(distance) {
                return Ok(None);
            }
            self.spend(copy)?;
            let graph = self.graph;
            ways(graph, copy).for_each(|(next, weight)| self.reach(next, distance + weight));
            return Ok(Some(copy));
        }
        Ok(None)
    }

    fn spend(&mut self, copy: Copy) -> Result<(), Spent> {
        let looks = self.graph.arcs(copy / 2).len() as u64;
        self.budget = self.budget.checked_sub(looks).ok_or(Spent)?;
        Ok(())
    }

    /// The lowest face on a mirrored strip of the length that the search has just found to be the least: the faces
    /// before and behind the middle of each, and all on the way back from there.
    fn lowest_face_within(&mut self, length: u64) -> Result<u32, Spent> {
        let graph = self.graph;
        let mut on_strip = Vec::new();
        let mut is_on_strip = std::collections::BTreeSet::new();
        for &copy in &self.reached {
            let here = self.distance[copy as usize];
            let meets = ways(graph, copy).any(|(next, weight)| {
                let there = self.distance[other_copy(next) as usize];
                there != UNREACHED && here + weight + there == length
            });
            if meets {
                on_strip.push(copy);
            }
        }
        is_on_strip.extend(on_strip.iter().copied());
        let mut lowest = u32::MAX;
        while let Some(copy) = on_strip.pop() {
            self.spend(copy)?;
            lowest = lowest.min(copy / 2);
            let here = self.distance[copy as usize];
            for (before, weight) in ways(graph, copy) {
                let is_before = self.distance[before as usize].checked_add(weight) == Some(here);
                if is_before && is_on_strip.insert(before) {
                    on_strip.push(before);
                }
            }
        }
        Ok(lowest)
    }
}

/// The neighbours of a copy, and how far they are.
fn ways(graph: &SignedGraph, copy: Copy) -> impl Iterator<Item = (Copy, u64)> + '_ {
    graph.arcs(copy / 2).iter().map(move |arc| {
        let signed_edge = graph.signed_edge(arc.signed_edge);
        (2 * arc.to + (copy & 1 ^ u32::from(signed_edge.is_mirrored)), signed_edge.weight)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orientation::dual_graph::SignedEdge;

    /// A face that is reached by one shorter way after another, and has many neighbours.
    #[test]
    fn each_way_out_of_a_face_is_looked_at_once() {
        let count = 20;
        let signed_edge = |from: u32, to: u32, weight: u32| SignedEdge {
            ends: [from, to],
            is_mirrored: false,
            weight: u64::from(weight),
        };
        let (crowded, ways) = (2 * count + 1, 1..=count);
        let there = ways.clone().map(|way| signed_edge(0, way, way));
        let on = ways.clone().map(|way| signed_edge(way, crowded, 3 * (count - way) + 1));
        let neighbours = ways.map(|way| signed_edge(crowded, count + way, 1));
        let graph = SignedGraph::new(crowded as usize + 1, there.chain(on).chain(neighbours).collect());
        let looks = graph.arc_count() as u64;
        assert_eq!(Search::new(&graph, looks).round(0, 1000).unwrap(), None);
        assert!(Search::new(&graph, looks - 1).round(0, 1000).is_err());
    }
}
