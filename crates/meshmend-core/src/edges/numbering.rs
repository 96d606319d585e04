//! How edges are numbered: sides are grouped by their smaller vertex, and each small group is sorted by itself.
//!
//! That is several times as fast as one sort of all sides.

use std::ops::Range;

use super::edge_table::{EdgeSide, EdgeTable};
use super::grouping::{Collect, Groups, Records, Strategy, joined};
use crate::{EdgeId, FaceId, FaceTable, Id, VertexId};

impl EdgeTable {
    /// Numbers the edges of a normalised table.
    ///
    /// *Cost*: O(n + Σ d log d) over the buckets' sizes d; four arrays, and one or two temporary ones of 8 to 12 bytes
    /// a corner.
    pub(crate) fn build(faces: &FaceTable) -> Self {
        build(faces, Strategy::for_table(faces))
    }
}

/// The same table whichever way it is built.
fn build(faces: &FaceTable, strategy: Strategy) -> EdgeTable {
    let sides: Vec<FaceSides<'_>> =
        strategy.shares(faces.face_count()).into_iter().map(|range| FaceSides { faces, range }).collect();
    let mut parts: Vec<Part> = strategy.collect(faces.vertex_count(), &sides);
    finish(&mut parts);
    let mut corner_edge = vec![EdgeId(0); faces.corner_count()];
    strategy.scatter(&mut corner_edge, &parts);
    let edge_count = parts.iter().map(|part| part.ends.len()).sum::<usize>();
    let (mut ends, mut starts, mut edge_sides) = (Vec::new(), Vec::new(), Vec::new());
    let count = parts.len();
    for (place, mut part) in parts.into_iter().enumerate() {
        let first_side = part.before.1;
        part.starts.iter_mut().for_each(|start| *start += first_side);
        // The end of the sides is where those of the next part begin.
        part.starts.truncate(part.ends.len() + usize::from(place + 1 == count));
        ends.push(part.ends);
        starts.push(part.starts);
        edge_sides.push(part.edge_sides);
    }
    let (edge_sides, (ends, starts)) = strategy.both(
        || joined(edge_sides, faces.corner_count()),
        || (joined(ends, edge_count), joined(starts, edge_count + 1)),
    );
    EdgeTable { ends: ends.into(), corner_edge: corner_edge.into(), starts, edge_sides }
}

/// A side on its way to its edge, whose smaller vertex is its key.
#[derive(Clone, Copy, Default)]
struct Side {
    high: VertexId,
    side: EdgeSide,
}

/// The sides of some faces, by ascending corner.
struct FaceSides<'a> {
    faces: &'a FaceTable,
    range: Range<usize>,
}

impl Records<Side> for FaceSides<'_> {
    #[inline]
    fn for_each(&self, mut visit: impl FnMut(u32, Side)) {
        let vertices = self.faces.corner_vertices();
        let mut side = |corner: usize, from: VertexId, to: VertexId| {
            let side = EdgeSide((corner as u32) << 1 | u32::from(from < to));
            visit(from.min(to).0, Side { high: from.max(to), side });
        };
        if self.faces.is_all_triangles() {
            let own = &vertices[3 * self.range.start..3 * self.range.end];
            for (face, corners) in self.range.clone().zip(own.chunks_exact(3)) {
                let [a, b, c] = [corners[0], corners[1], corners[2]];
                side(3 * face, a, b);
                side(3 * face + 1, b, c);
                side(3 * face + 2, c, a);
            }
            return;
        }
        for face in self.range.clone() {
            let range = self.faces.corner_range(FaceId::new(face));
            for corner in range.clone() {
                let next = if corner + 1 == range.end { range.start } else { corner + 1 };
                side(corner, vertices[corner], vertices[next]);
            }
        }
    }
}

/// The edges whose smaller vertex is in a range.
#[derive(Default)]
struct Part {
    ends: Vec<[VertexId; 2]>,
    /// Where the sides of each edge begin, and in the end where the last ones end.
    starts: Vec<u32>,
    edge_sides: Vec<EdgeSide>,
    /// How many edges and sides the parts before have.
    before: (u32, u32),
    /// The sides that are being added as (larger vertex, [`EdgeSide`]), by smaller vertex.
    sides: Groups<u64>,
}

impl Collect<Side> for Part {
    /// Makes room for sides, and for as many edges as they have in a closed mesh.
    fn reserve(&mut self, sides: usize) {
        self.edge_sides.reserve(sides);
        self.ends.reserve(sides / 2 + 1);
        self.starts.reserve(sides / 2 + 2);
    }

    fn add(&mut self, lows: Range<u32>, sides: &impl Records<Side>) {
        let mut grouped = std::mem::take(&mut self.sides);
        grouped.clear();
        grouped.add_as(lows.clone(), sides, |side| u64::from(side.high.0) << 32 | u64::from(side.side.0));
        self.reserve(grouped.items.len());
        for (low, bounds) in lows.zip(grouped.starts.windows(2)) {
            let group = &mut grouped.items[bounds[0] as usize..bounds[1] as usize];
            group.sort_unstable();
            self.add_vertex(VertexId(low), group);
        }
        self.sides = grouped;
    }
}

impl Part {
    /// Adds the edges of a smaller vertex.
    #[inline]
    fn add_vertex(&mut self, low: VertexId, sides: &[u64]) {
        let mut last = None;
        for side in sides {
            let (high, side) = (VertexId((side >> 32) as u32), EdgeSide(*side as u32));
            if last != Some(high) {
                last = Some(high);
                self.starts.push(self.edge_sides.len() as u32);
                self.ends.push([low, high]);
            }
            self.edge_sides.push(side);
        }
    }
}

/// Ends each part, and tells it what is before it.
fn finish(parts: &mut [Part]) {
    let mut before = (0, 0);
    for part in parts {
        let sides = part.edge_sides.len() as u32;
        part.sides = Groups::default();
        part.starts.push(sides);
        part.before = before;
        before = (before.0 + part.ends.len() as u32, before.1 + sides);
    }
}

/// The edges by their corners.
impl Records<EdgeId> for Part {
    #[inline]
    fn for_each(&self, mut visit: impl FnMut(u32, EdgeId)) {
        for (edge, bounds) in (self.before.0..).zip(self.starts.windows(2)) {
            let sides = &self.edge_sides[bounds[0] as usize..bounds[1] as usize];
            sides.iter().for_each(|side| visit(side.corner().0, EdgeId(edge)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceTableBuilder;

    /// Faces of up to five corners anywhere among the vertices.
    fn faces_of(vertex_count: u32, most_corners: u32) -> FaceTable {
        let mut state = 1u32;
        let mut next = |below: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % below
        };
        let mut builder = FaceTableBuilder::default();
        for _ in 0..2 * vertex_count {
            let first = next(vertex_count);
            let steps = (0..3 + next(most_corners - 2)).map(|_| 1 + next(vertex_count / 7 + 1));
            let corners =
                steps.scan(first, |at, step| Some(std::mem::replace(at, (*at + step) % vertex_count)));
            let mut corners: Vec<u32> = corners.collect();
            corners.dedup();
            if corners.len() > 2 && corners.first() != corners.last() {
                builder.push_face(corners.into_iter().map(VertexId));
            }
        }
        builder.build(vertex_count as usize).unwrap()
    }

    #[test]
    #[cfg_attr(miri, ignore = "the interpreter refuses the pool of threads, which is not ours")]
    fn whichever_way_they_are_built_they_are_the_same_edges() {
        let strategy = |threads, is_scattered| Strategy { threads, is_scattered };
        // The last has three ranges of vertices and more of corners.
        for (vertex_count, most_corners) in [(3, 3), (4, 3), (7, 5), (50, 3), (10_000, 3), (9000, 5)] {
            let faces = faces_of(vertex_count, most_corners);
            assert!(faces.face_count() > 0 && faces.is_all_triangles() == (most_corners == 3));
            let table = build(&faces, strategy(1, false));
            for threads in [1, 2, 3, 60] {
                assert_eq!(build(&faces, strategy(threads, true)), table);
                assert_eq!(build(&faces, strategy(threads, false)), table);
            }
        }
        assert_eq!(build(&FaceTable::empty(0), strategy(3, false)).edge_count(), 0);
        assert_eq!(build(&FaceTable::empty(0), strategy(3, true)).edge_count(), 0);
    }
}
