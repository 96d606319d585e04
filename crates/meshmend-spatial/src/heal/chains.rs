//! The vertices that cut each boundary edge, and the pieces that they cut it into.

use meshmend_core::{Id, VertexId};
use meshmend_geometry::vector::Point;

use crate::exact::{Sign, compare_along};
use crate::t_junctions::{Boundary, compare_distance};

/// For each boundary edge the vertices that cut it, in the order of their feet, then distance, then id.
pub(super) type Cuts = Vec<Vec<VertexId>>;

/// Two vertices that a side would run between, the lower one first.
pub(super) type Piece = [VertexId; 2];

/// Puts the vertices on an edge in their order along it.
pub(super) fn sort_along(positions: &[Point], ends: [VertexId; 2], vertices: &mut [VertexId]) {
    let line = ends.map(|end| positions[end.index()]);
    vertices.sort_by(|&one, &other| {
        let [a, b] = [one, other].map(|vertex| positions[vertex.index()]);
        let by_foot = match compare_along(line, a, b) {
            Sign::Negative => std::cmp::Ordering::Less,
            Sign::Zero => std::cmp::Ordering::Equal,
            Sign::Positive => std::cmp::Ordering::Greater,
        };
        by_foot.then_with(|| compare_distance(line, a, b)).then(one.cmp(&other))
    });
}

/// The pieces into which some vertices cut an edge, in order.
pub(super) fn pieces(ends: [VertexId; 2], vertices: &[VertexId]) -> impl Iterator<Item = Piece> + '_ {
    let all = std::iter::once(ends[0]).chain(vertices.iter().copied()).chain([ends[1]]);
    let next = vertices.iter().copied().chain([ends[1]]);
    all.zip(next).map(|(from, to)| [from.min(to), from.max(to)])
}

/// All pieces with the edges that have them, ascending.
pub(super) struct Pieces {
    sides: Vec<(Piece, u32)>,
}

impl Pieces {
    /// The pieces of all boundary edges, each cut by some vertices.
    pub(super) fn of(boundary: &Boundary, cuts: &Cuts) -> Self {
        let mut sides: Vec<(Piece, u32)> = Vec::new();
        for (edge, (side, vertices)) in (0u32..).zip(boundary.edges().iter().zip(cuts)) {
            sides.extend(pieces(side.ends, vertices).map(|piece| (piece, edge)));
        }
        sides.sort_unstable();
        Pieces { sides }
    }

    /// The edges that have a piece, ascending.
    pub(super) fn edges_with(&self, piece: Piece) -> &[(Piece, u32)] {
        let first = self.sides.partition_point(|(other, _)| *other < piece);
        let end = first + self.sides[first..].partition_point(|(other, _)| *other == piece);
        &self.sides[first..end]
    }

    /// Each piece with the edges that have it.
    pub(super) fn iter(&self) -> impl Iterator<Item = &[(Piece, u32)]> {
        self.sides.chunk_by(|one, other| one.0 == other.0)
    }

    /// Whether exactly two sides would run between the ends of a piece, given the edges that have it.
    pub(super) fn has_two_sides(boundary: &Boundary, here: &[(Piece, u32)]) -> bool {
        matches!(here, [(piece, _), _] if boundary.inner_degree(*piece) == 0)
    }
}
