//! Faces that come back to a vertex: which of them have holes, and how such faces are cut.
//!
//! If all loops of a face turn as the whole face does, the face is split into them. A loop that turns against the whole is
//! the rim of a hole, and splitting would fill it: such a face is cut along diagonals instead.

use std::collections::{BTreeMap, BTreeSet};

use meshmend_core::{EdgeTable, PolygonMesh, VertexId, canonical_rotation};
use meshmend_geometry::polygon::{Polygon, has_hole, simple_pieces};
use meshmend_geometry::words::Loops;

/// What a face that comes back to a vertex is cut into, as places of its corners.
pub(super) enum Parts {
    /// The face is split into its loops.
    Loops,
    /// The face has a hole, and is cut into these.
    Pieces(Vec<Vec<usize>>),
    /// A loop turns as the rim of a hole does, but the face crosses itself: it is split into its loops.
    Crossing,
}

/// Cuts faces with holes. Faces with the same cycle of vertices are cut alike, so that repeats can be found.
pub(super) struct HoleCutter<'a> {
    mesh: &'a PolygonMesh,
    edges: &'a EdgeTable,
    /// For each cycle of vertices, in its least rotation, the pieces that were found.
    known: BTreeMap<Vec<VertexId>, Option<Vec<Vec<usize>>>>,
    /// The sides of all pieces, the smaller vertex first.
    taken: BTreeSet<[VertexId; 2]>,
}

impl<'a> HoleCutter<'a> {
    pub(super) fn new(mesh: &'a PolygonMesh) -> Self {
        let edges = mesh.complex().edges();
        HoleCutter { mesh, edges, known: BTreeMap::new(), taken: BTreeSet::new() }
    }

    /// What a face with several loops is cut into.
    ///
    /// *Cost*: linear in its corners if it has no hole, else as for [`simple_pieces`].
    pub(super) fn parts(&mut self, vertices: &[VertexId], found: &Loops) -> Parts {
        if !self.has_hole(vertices, found) {
            return Parts::Loops;
        }
        let mut word: Vec<usize> = found.word.clone();
        let start = canonical_rotation(&word.iter().map(|&place| vertices[place]).collect::<Vec<_>>());
        word.rotate_left(start);
        let cycle: Vec<VertexId> = word.iter().map(|&place| vertices[place]).collect();
        if !self.known.contains_key(&cycle) {
            let pieces = self.cut(&cycle);
            self.known.insert(cycle.clone(), pieces);
        }
        match self.known.get(&cycle) {
            Some(Some(pieces)) => Parts::Pieces(in_face_order(pieces, &word)),
            _ => Parts::Crossing,
        }
    }

    fn has_hole(&self, vertices: &[VertexId], found: &Loops) -> bool {
        let points = |places: &[usize]| -> Vec<[f64; 3]> {
            places.iter().map(|&place| self.mesh.position(vertices[place])).collect()
        };
        has_hole(&points(&found.word), found.loops.iter().map(|places| points(places)))
    }

    fn cut(&mut self, cycle: &[VertexId]) -> Option<Vec<Vec<usize>>> {
        let points: Vec<[f64; 3]> = cycle.iter().map(|&vertex| self.mesh.position(vertex)).collect();
        let is_taken = |one: usize, other: usize| {
            let ends = sorted(cycle[one], cycle[other]);
            self.edges.all_ends().binary_search(&ends).is_ok() || self.taken.contains(&ends)
        };
        let pieces = simple_pieces(Polygon { points: &points, vertices: cycle }, &is_taken)?;
        for piece in &pieces {
            let next = piece.iter().cycle().skip(1);
            self.taken.extend(piece.iter().zip(next).map(|(&one, &other)| sorted(cycle[one], cycle[other])));
        }
        Some(pieces)
    }
}

fn sorted(one: VertexId, other: VertexId) -> [VertexId; 2] {
    [one.min(other), one.max(other)]
}

/// Pieces of a word as places of the face. Each begins at its lowest place, and they are sorted by it.
fn in_face_order(pieces: &[Vec<usize>], word: &[usize]) -> Vec<Vec<usize>> {
    let mut found: Vec<Vec<usize>> =
        pieces.iter().map(|piece| piece.iter().map(|&at| word[at]).collect()).collect();
    for piece in &mut found {
        let least = piece.iter().enumerate().min_by_key(|(_, place)| **place).map_or(0, |(at, _)| at);
        piece.rotate_left(least);
    }
    found.sort_unstable();
    found
}
