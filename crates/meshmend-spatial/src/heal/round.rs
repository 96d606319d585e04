//! What one round of healing puts in.

use std::collections::BTreeSet;

use meshmend_core::{FaceId, VertexId};
use meshmend_geometry::vector::Point;

use super::chains::{Cuts, Piece, Pieces, pieces, sort_along};
use super::crowd::Crowd;
use super::lie::lie_on_each_other;
use super::not_healed::NotHealed;
use crate::t_junctions::{Boundary, OnEdges, is_thin};

/// The decisions of a round.
pub(super) struct Round {
    /// The vertices that become corners on each boundary edge, in order along it.
    pub(super) chosen: Cuts,
    /// Why edges with aligned vertices stay as they are.
    pub(super) refused: Vec<Option<NotHealed>>,
    /// Whether a vertex is aligned, for each pair of an edge and a vertex on it.
    pub(super) is_aligned: Vec<bool>,
}

/// What all decisions of a round look at.
struct Ground<'a> {
    positions: &'a [Point],
    boundary: &'a Boundary,
    within: f64,
    /// The aligned vertices of each boundary edge.
    aligned: Cuts,
}

impl Round {
    pub(super) fn decided(positions: &[Point], boundary: &Boundary, on: &OnEdges, within: f64) -> Self {
        let mut aligned: Cuts = vec![Vec::new(); boundary.edges().len()];
        let mut is_aligned = Vec::with_capacity(on.pairs().len());
        for &(edge, vertex) in on.pairs() {
            let is_it = on.is_aligned(boundary, edge, vertex);
            is_aligned.push(is_it);
            if is_it {
                aligned[edge as usize].push(vertex);
            }
        }
        let mut refused = vec![None; aligned.len()];
        for (edge, vertices) in aligned.iter_mut().enumerate().filter(|(_, vertices)| !vertices.is_empty()) {
            sort_along(positions, boundary.edges()[edge].ends, vertices);
            refused[edge] = is_thin(positions, boundary, edge as u32, within).then_some(NotHealed::Thin);
        }
        let ground = Ground { positions, boundary, within, aligned };
        let mut crowd: Option<Crowd> = None;
        let chosen = loop {
            let (chosen, objections) = ground.chosen(&refused, &mut crowd);
            if objections.is_empty() {
                break chosen;
            }
            objections.into_iter().for_each(|(edge, reason)| refused[edge as usize] = Some(reason));
        };
        Round { chosen, refused, is_aligned }
    }
}

impl Ground<'_> {
    /// What would be put in on edges that are not refused, and the edges that object to that.
    fn chosen(
        &self,
        refused: &[Option<NotHealed>],
        crowd: &mut Option<Crowd>,
    ) -> (Cuts, Vec<(u32, NotHealed)>) {
        let live = |(vertices, refused): (&Vec<VertexId>, &Option<NotHealed>)| {
            if refused.is_none() { vertices.clone() } else { Vec::new() }
        };
        let live: Cuts = self.aligned.iter().zip(refused).map(live).collect();
        let pieces_now = Pieces::of(self.boundary, &live);
        let chosen = self.ends_of_good(&pieces_now, &live);
        let repeated = self.repeated(&chosen);
        if !repeated.is_empty() {
            return (chosen, repeated.into_iter().map(|edge| (edge, NotHealed::Repeated)).collect());
        }
        let crowded = self.crowded(&pieces_now, &chosen, crowd);
        (chosen, crowded.into_iter().map(|edge| (edge, NotHealed::Crowded)).collect())
    }

    /// The vertices on each edge that are ends of good pieces.
    fn ends_of_good(&self, pieces_now: &Pieces, live: &Cuts) -> Cuts {
        let mut ends: BTreeSet<(u32, VertexId)> = BTreeSet::new();
        for here in pieces_now.iter() {
            let &[(piece, one), (_, other)] = here else { continue };
            let edges = [one, other].map(|edge| self.boundary.edges()[edge as usize]);
            let is_good = Pieces::has_two_sides(self.boundary, here)
                && edges[0].face != edges[1].face
                && !lie_on_each_other(self.positions, self.boundary, [one, other], piece, self.within);
            if !is_good {
                continue;
            }
            for (place, edge) in [(one, edges[0]), (other, edges[1])] {
                ends.extend(piece.iter().filter(|end| !edge.ends.contains(end)).map(|&end| (place, end)));
            }
        }
        let kept = |(edge, vertices): (u32, &Vec<VertexId>)| {
            vertices.iter().copied().filter(|&vertex| ends.contains(&(edge, vertex))).collect()
        };
        (0u32..).zip(live).map(kept).collect()
    }

    /// The edges of faces that would get a vertex at two of their edges.
    fn repeated(&self, chosen: &Cuts) -> Vec<u32> {
        let mut corners: Vec<(FaceId, VertexId, u32)> = Vec::new();
        for (edge, vertices) in (0u32..).zip(chosen) {
            let face = self.boundary.edges()[edge as usize].face;
            corners.extend(vertices.iter().map(|&vertex| (face, vertex, edge)));
        }
        corners.sort_unstable();
        let same = |one: &(FaceId, VertexId, u32), other: &(FaceId, VertexId, u32)| {
            (one.0, one.1) == (other.0, other.1)
        };
        let repeated = corners.chunk_by(same).filter(|chunk| chunk.len() > 1);
        repeated.flatten().map(|&(_, _, edge)| edge).collect()
    }

    /// The edges of which a piece that would remain and is not good runs along others, by position or by index.
    fn crowded(&self, pieces_now: &Pieces, chosen: &Cuts, crowd: &mut Option<Crowd>) -> Vec<u32> {
        let final_pieces = Pieces::of(self.boundary, chosen);
        let is_crowded = |edge: u32, piece: Piece, crowd: &mut Option<Crowd>| {
            let here = pieces_now.edges_with(piece);
            let is_good = Pieces::has_two_sides(self.boundary, here);
            let sides = final_pieces.edges_with(piece).len() + self.boundary.inner_degree(piece);
            let is_own = is_good && here.iter().any(|&(_, other)| other == edge);
            if sides > 2 && !is_own {
                return true;
            }
            !is_good && {
                let crowd =
                    crowd.get_or_insert_with(|| Crowd::of(self.positions, self.boundary, self.within));
                crowd.runs_along(self.positions, self.boundary, edge, piece)
            }
        };
        let mut crowded = Vec::new();
        for (edge, vertices) in (0u32..).zip(chosen).filter(|(_, vertices)| !vertices.is_empty()) {
            let ends = self.boundary.edges()[edge as usize].ends;
            if pieces(ends, vertices).any(|piece| is_crowded(edge, piece, crowd)) {
                crowded.push(edge);
            }
        }
        crowded
    }
}
