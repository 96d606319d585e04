//! A part of the faces as a mesh in memory.
//!
//! Vertices have new numbers in the same order, so that edges, which are numbered by their ends, are in the same order too. The
//! star of every vertex in the part's range is whole; that of others need not be.

use std::convert::Infallible;
use std::ops::Range;

use meshmend_core::{
    Complex, Connectivity, EdgeId, EdgeUse, FaceId, FaceTable, FaceTableBuilder, Id, VertexId,
};
use rayon::prelude::*;

use crate::face_parts::{are_triangles, each_face};

/// A part in memory.
pub(crate) struct Part {
    pub(crate) kernel: EdgeUse,
    /// The number of each face.
    faces: Vec<u32>,
    /// The vertices below the range and those beyond it, ascending.
    below: Vec<u32>,
    beyond: Vec<u32>,
    range: (u32, u32),
}

impl Part {
    /// The mesh of the faces that touch a range of vertices, by the numbers of a part.
    pub(crate) fn of(numbers: Vec<u32>, range: (u32, u32)) -> Self {
        let is_triangles = are_triangles(&numbers);
        let room = numbers.len() / 4;
        let (mut faces, mut corners) = (Vec::with_capacity(room), Vec::with_capacity(3 * room));
        let mut ends = Vec::new();
        let Ok(()) = each_face(&numbers, |face, vertices| {
            faces.push(face);
            corners.extend_from_slice(vertices);
            if !is_triangles {
                ends.push(corners.len());
            }
            Ok::<(), Infallible>(())
        });
        drop(numbers);
        let (below, beyond) = renumber(&mut corners, range);
        let count = below.len() + (range.1 - range.0) as usize + beyond.len();
        let corners: Vec<VertexId> = corners.into_iter().map(VertexId).collect();
        let table = if is_triangles {
            FaceTable::triangles(count, corners)
        } else {
            let mut builder = FaceTableBuilder::default();
            let mut first = 0;
            for end in ends {
                builder.push_face(corners[first..end].iter().copied());
                first = end;
            }
            builder.build(count)
        };
        // The vertices are below the count, and a part has fewer corners than a table holds.
        let table = table.unwrap_or_else(|_| FaceTable::empty(count));
        let kernel = EdgeUse::assemble(&Complex::of(&table.into()));
        Part { kernel, faces, below, beyond, range }
    }

    /// The first vertex of the range, and the one beyond its last.
    pub(crate) fn range(&self) -> [u32; 2] {
        [self.range.0, self.range.1]
    }

    /// The vertices of the range, by their numbers here.
    pub(crate) fn own(&self) -> Range<usize> {
        self.below.len()..self.below.len() + (self.range.1 - self.range.0) as usize
    }

    /// The number of a vertex.
    #[inline]
    pub(crate) fn vertex(&self, here: VertexId) -> VertexId {
        let own = self.own();
        VertexId(match here.index() {
            place if place < own.start => self.below[place],
            place if place < own.end => self.range.0 + (place - own.start) as u32,
            place => self.beyond[place - own.end],
        })
    }

    /// The number of a face.
    #[inline]
    pub(crate) fn face(&self, here: FaceId) -> FaceId {
        FaceId(self.faces[here.index()])
    }

    /// The edges whose lower end is in the range.
    pub(crate) fn own_edges(&self) -> impl Iterator<Item = EdgeId> + Clone + use<> {
        let own = self.own();
        let lower = |edge: usize| self.kernel.edge_ends(EdgeId::new(edge))[0].index();
        // Edges are ordered by their lower end.
        let at = |vertex: usize| first_not(self.kernel.edge_count(), |edge| lower(edge) < vertex);
        (at(own.start)..at(own.end)).map(EdgeId::new)
    }
}

/// The first of so many places at which something does not hold that holds up to there.
pub(crate) fn first_not(count: usize, holds: impl Fn(usize) -> bool) -> usize {
    let (mut low, mut high) = (0, count);
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) { low = middle + 1 } else { high = middle }
    }
    low
}

/// Numbers the vertices anew: those below the range, then the whole range, then those beyond it. Returns the first and the last.
fn renumber(corners: &mut [u32], (first, end): (u32, u32)) -> (Vec<u32>, Vec<u32>) {
    let is_own = |vertex: u32| (first..end).contains(&vertex);
    let outside = (0u32..).zip(&*corners).filter(|&(_, &vertex)| !is_own(vertex));
    let mut outside: Vec<u64> =
        outside.map(|(at, &vertex)| u64::from(vertex) << 32 | u64::from(at)).collect();
    outside.par_sort_unstable();
    let split = outside.partition_point(|&pair| (pair >> 32) < u64::from(first));
    let different = |pairs: &[u64]| {
        let runs = pairs.chunk_by(|one, other| one >> 32 == other >> 32);
        runs.map(|run| (run[0] >> 32) as u32).collect::<Vec<u32>>()
    };
    let (below, beyond) = (different(&outside[..split]), different(&outside[split..]));
    let own = below.len() as u32;
    for vertex in corners.iter_mut().filter(|vertex| is_own(**vertex)) {
        *vertex = own + (*vertex - first);
    }
    for (pairs, before) in [(&outside[..split], 0), (&outside[split..], own + (end - first))] {
        for (place, run) in (before..).zip(pairs.chunk_by(|one, other| one >> 32 == other >> 32)) {
            run.iter().for_each(|&pair| corners[pair as u32 as usize] = place);
        }
    }
    (below, beyond)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_order_and_come_back() {
        let numbers = vec![5, 9, 3, 70, 7, 4, 1, 9, 8, 1, 30, 5];
        let part = Part::of(numbers, (4, 7));
        assert_eq!(part.own(), 2..5);
        let all: Vec<u32> =
            (0..part.kernel.vertex_count() as u32).map(|v| part.vertex(VertexId(v)).0).collect();
        assert_eq!(all, [1, 3, 4, 5, 6, 9, 30, 70]);
        let corners: Vec<u32> =
            part.kernel.corners().map(|c| part.vertex(part.kernel.corner_vertex(c)).0).collect();
        assert_eq!(corners, [9, 3, 70, 4, 1, 9, 1, 30, 5]);
        let ends = part.own_edges().map(|edge| part.kernel.edge_ends(edge).map(|v| part.vertex(v).0));
        assert_eq!(ends.collect::<Vec<_>>(), [[4, 9], [5, 30]]);
    }
}
