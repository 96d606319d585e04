//! The same question in fewer faces.
//!
//! Faces are joined two by two and lie on sides that agree from then on; signed edges that lead between the same two
//! joined faces are summed up, with opposite signs where one mirrors and the other does not. What clashes for sides
//! of the coarse graph clashes, but for a constant, for the sides of the fine one that they stand for.
//!
//! *Source*: G. Karypis, V. Kumar, *A fast and high quality multilevel scheme for partitioning irregular graphs*,
//! 1998.

use crate::orientation::dual_graph::{Arc, SignedEdge, SignedGraph};

/// A graph with about half the faces of another.
#[derive(Debug)]
pub(super) struct Coarse {
    pub(super) graph: SignedGraph,
    /// How many faces each face stands for.
    size: Vec<u32>,
    /// For each face of the finer graph the one that stands for it, and whether it lies on the other side.
    of_fine: Vec<(u32, bool)>,
}

const UNJOINED: u32 = u32::MAX;

impl Coarse {
    /// Joins the faces of a graph, each of which stands for so many, two by two.
    ///
    /// *Cost*: O(n log n).
    pub(super) fn of(fine: &SignedGraph, size: &[u32]) -> Self {
        let mut coarse =
            Coarse { graph: SignedGraph::new(0, Vec::new()), size: Vec::new(), of_fine: Vec::new() };
        coarse.of_fine = vec![(UNJOINED, false); fine.face_count()];
        for face in fine.faces() {
            if coarse.of_fine[face as usize].0 != UNJOINED {
                continue;
            }
            let joined = coarse.size.len() as u32;
            coarse.of_fine[face as usize] = (joined, false);
            let mut whole = size[face as usize];
            if let Some(Arc { signed_edge, to }) = coarse.partner(fine, size, face) {
                coarse.of_fine[to as usize] = (joined, fine.signed_edge(signed_edge).is_mirrored);
                whole += size[to as usize];
            }
            coarse.size.push(whole);
        }
        coarse.graph = SignedGraph::new(coarse.size.len(), coarse.signed_edges(fine));
        coarse
    }

    /// The next coarser graph.
    pub(super) fn coarser(&self) -> Self {
        Coarse::of(&self.graph, &self.size)
    }

    /// The sides of the finer graph's faces.
    pub(super) fn in_fine(&self, is_turned: &[bool]) -> Vec<bool> {
        self.of_fine.iter().map(|&(face, is_other)| is_turned[face as usize] ^ is_other).collect()
    }

    /// The way to the free neighbour with the heaviest signed edge for its size; of equal ones the first.
    fn partner(&self, fine: &SignedGraph, size: &[u32], face: u32) -> Option<Arc> {
        let is_free = |arc: &&Arc| arc.to != face && self.of_fine[arc.to as usize].0 == UNJOINED;
        let is_better = |one: &Arc, other: &Arc| {
            let weight = |arc: &Arc| u128::from(fine.signed_edge(arc.signed_edge).weight);
            let size = |arc: &Arc| u128::from(size[arc.to as usize]);
            weight(one) * size(other) > weight(other) * size(one)
        };
        let free = fine.arcs(face).iter().filter(is_free).copied();
        free.reduce(|best, next| if is_better(&next, &best) { next } else { best })
    }

    /// The signed edges between different joined faces, parallel ones summed up.
    fn signed_edges(&self, fine: &SignedGraph) -> Vec<SignedEdge> {
        let coarse_edge = |signed_edge: &SignedEdge| {
            let [one, other] = signed_edge.ends.map(|face| self.of_fine[face as usize]);
            let ends = [one.0.min(other.0), one.0.max(other.0)];
            (ends[0] != ends[1]).then_some((
                ends,
                signed_edge.is_mirrored ^ one.1 ^ other.1,
                signed_edge.weight,
            ))
        };
        let mut all: Vec<([u32; 2], bool, u64)> =
            fine.signed_edges().iter().filter_map(coarse_edge).collect();
        all.sort_unstable();
        let summed = all.chunk_by(|one, other| one.0 == other.0).filter_map(|parallel| {
            let weight = |mirrored: bool| -> u64 {
                parallel
                    .iter()
                    .filter(|signed_edge| signed_edge.1 == mirrored)
                    .map(|signed_edge| signed_edge.2)
                    .sum()
            };
            let (plain, mirrored) = (weight(false), weight(true));
            let (ends, is_mirrored) = (parallel[0].0, mirrored > plain);
            (plain != mirrored).then_some(SignedEdge { ends, is_mirrored, weight: plain.abs_diff(mirrored) })
        });
        summed.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn signed_edge(ends: [u32; 2], is_mirrored: bool, weight: u64) -> SignedEdge {
        SignedEdge { ends, is_mirrored, weight }
    }

    #[test]
    fn a_face_is_joined_with_the_neighbour_of_the_heaviest_tie_for_its_size() {
        for (weights, sizes, partner) in [
            ([1, 1], [1, 2], 1),
            ([1, 1], [2, 1], 2),
            ([3, 5], [1, 2], 1),
            ([1, 3], [1, 2], 2),
            ([2, 2], [3, 3], 1),
        ] {
            let signed_edges =
                vec![signed_edge([0, 1], false, weights[0]), signed_edge([0, 2], false, weights[1])];
            let coarse = Coarse::of(&SignedGraph::new(3, signed_edges), &[1, sizes[0], sizes[1]]);
            let joined: Vec<u32> = coarse.of_fine.iter().map(|of| of.0).collect();
            let expected = if partner == 1 { [0, 0, 1] } else { [0, 1, 0] };
            assert_eq!(joined, expected, "{weights:?} {sizes:?}");
        }
    }

    #[test]
    fn parallel_ties_count_what_is_left_of_them() {
        // Faces 2 and 3 are joined on opposite sides, so the signed edge of 1 and 3 turns.
        let firm = [signed_edge([0, 1], false, 9), signed_edge([2, 3], true, 9)];
        for (weights, left) in [
            ([3, 1], vec![signed_edge([0, 1], false, 2)]),
            ([1, 3], vec![signed_edge([0, 1], true, 2)]),
            ([2, 2], vec![]),
        ] {
            let between = [signed_edge([0, 2], false, weights[0]), signed_edge([1, 3], false, weights[1])];
            let coarse = Coarse::of(&SignedGraph::new(4, [firm, between].concat()), &[1; 4]);
            assert_eq!(coarse.graph.signed_edges(), left);
            assert_eq!(coarse.in_fine(&[false, true]), [false, false, true, false]);
        }
    }
}
