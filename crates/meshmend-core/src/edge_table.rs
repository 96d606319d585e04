//! The canonical numbering of a complex's edges, and which corners use which edge.
//!
//! ```text
//! ends          (v0,v1) (v0,v2) (v1,v2) ...      sorted by (smaller vertex, larger vertex)
//! corner_edge   c0 → e0   c1 → e2   ...          the side that begins at the corner
//! edge_sides    e0: c0 c7 | e1: c2 | ...         ascending corners, grouped by edge, each with its side's direction
//! ```
//!
//! Bytes a triangle of a closed mesh: 12 + 12 + 12 + 6 = 42.
//!
//! Building it is what costs, not asking it: sides are bucketed by their smaller vertex, and each small bucket is
//! sorted by itself. That is several times faster than one sort of all sides while the mesh's numbering is local.

use std::ops::Range;

use rayon::prelude::*;

use crate::{Column, CornerId, EdgeId, FaceTable, Id, VertexId};

/// The edges of a table whose every side joins two different vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeTable {
    ends: Column<EdgeId, [VertexId; 2]>,
    corner_edge: Column<CornerId, EdgeId>,
    starts: Vec<u32>,
    edge_sides: Vec<EdgeSide>,
}

/// A corner whose side runs along an edge, and which way: one word, as there are fewer than 2³¹ corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeSide(u32);

impl EdgeSide {
    /// The corner at which the side begins.
    #[inline]
    pub fn corner(self) -> CornerId {
        CornerId(self.0 >> 1)
    }

    /// Whether the side runs from the smaller to the larger vertex.
    #[inline]
    pub fn is_forward(self) -> bool {
        self.0 & 1 == 1
    }
}

impl EdgeTable {
    /// Numbers the edges of a normalised table.
    ///
    /// *Cost*: O(n + Σ d log d) over the buckets' sizes d; four arrays and one temporary of 8 bytes a corner. Each thread
    /// looks at all sides, and takes a range of smaller vertices.
    pub(crate) fn build(faces: &FaceTable) -> Self {
        let threads =
            if faces.corner_count() < LARGE { 1 } else { rayon::current_num_threads().min(MOST_PARTS) };
        Self::build_in_parts(faces, threads)
    }

    fn build_in_parts(faces: &FaceTable, count: usize) -> Self {
        let bound = |part: usize| (faces.vertex_count() as u64 * part as u64 / count as u64) as u32;
        let part = |part: usize| Part::of(faces, bound(part)..bound(part + 1));
        // A small mesh is no reason to start threads.
        let parts: Vec<Part> =
            if count == 1 { vec![part(0)] } else { (0..count).into_par_iter().map(part).collect() };
        let corner_edge = number_corners(&parts, faces.corner_count());
        let Part { ends, starts, edge_sides } = Part::joined(parts);
        EdgeTable { ends: ends.into(), corner_edge, starts, edge_sides }
    }

    /// How many edges there are.
    pub fn edge_count(&self) -> usize {
        self.ends.len()
    }

    /// Every edge, ascending.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = EdgeId> + Clone + use<> {
        (0..self.ends.len()).map(EdgeId::new)
    }

    /// The two vertices of an edge, the smaller one first.
    #[inline]
    pub fn ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.ends[edge]
    }

    /// All edges' ends, by ascending edge.
    pub fn all_ends(&self) -> &[[VertexId; 2]] {
        self.ends.values()
    }

    /// The edge that a corner's side runs along.
    #[inline]
    pub fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.corner_edge[corner]
    }

    /// The corners whose sides run along an edge, ascending.
    #[inline]
    pub fn edge_corners(&self, edge: EdgeId) -> impl ExactSizeIterator<Item = CornerId> + Clone {
        self.edge_sides(edge).iter().map(|side| side.corner())
    }

    /// The same, each with the direction of its side.
    #[inline]
    pub fn edge_sides(&self, edge: EdgeId) -> &[EdgeSide] {
        let e = edge.index();
        &self.edge_sides[self.starts[e] as usize..self.starts[e + 1] as usize]
    }

    /// Bytes on the heap.
    pub fn heap_bytes(&self) -> usize {
        self.ends.heap_bytes()
            + self.corner_edge.heap_bytes()
            + self.starts.capacity() * size_of::<u32>()
            + self.edge_sides.capacity() * size_of::<EdgeSide>()
    }
}

/// Tables of fewer corners are built on one thread.
const LARGE: usize = 1 << 16;
/// More parts than this would mostly look at sides that are not theirs.
const MOST_PARTS: usize = 8;

/// The edges whose smaller vertex is in a range.
#[derive(Default)]
struct Part {
    ends: Vec<[VertexId; 2]>,
    /// Where the sides of each edge begin, and one more.
    starts: Vec<u32>,
    edge_sides: Vec<EdgeSide>,
}

impl Part {
    fn of(faces: &FaceTable, lows: Range<u32>) -> Self {
        let (bucket_starts, sides) = bucket_sides(faces, lows.clone());
        let mut part = Part {
            ends: Vec::with_capacity(sides.len() / 2 + 1),
            starts: Vec::with_capacity(sides.len() / 2 + 2),
            edge_sides: Vec::with_capacity(sides.len()),
        };
        for (low, bucket) in lows.zip(bucket_starts.windows(2)) {
            let mut last = None;
            for &side in &sides[bucket[0] as usize..bucket[1] as usize] {
                let (high, side) = (VertexId((side >> 32) as u32), EdgeSide(side as u32));
                if last != Some(high) {
                    last = Some(high);
                    part.starts.push(part.edge_sides.len() as u32);
                    part.ends.push([VertexId(low), high]);
                }
                part.edge_sides.push(side);
            }
        }
        part.starts.push(part.edge_sides.len() as u32);
        part
    }

    /// One after the other.
    fn joined(mut parts: Vec<Part>) -> Part {
        if parts.len() == 1 {
            let mut whole = parts.swap_remove(0);
            whole.ends.shrink_to_fit();
            whole.starts.shrink_to_fit();
            return whole;
        }
        let edges = parts.iter().map(|part| part.ends.len()).sum::<usize>();
        let sides = parts.iter().map(|part| part.edge_sides.len()).sum();
        let mut whole = Part {
            ends: Vec::with_capacity(edges),
            starts: Vec::with_capacity(edges + 1),
            edge_sides: Vec::with_capacity(sides),
        };
        for part in parts {
            let first = whole.edge_sides.len() as u32;
            whole.ends.extend(part.ends);
            whole.starts.extend(part.starts[..part.starts.len() - 1].iter().map(|start| first + start));
            whole.edge_sides.extend(part.edge_sides);
        }
        whole.starts.push(sides as u32);
        whole
    }
}

/// The edge of each corner. Each thread looks at all edges, and takes a range of corners.
fn number_corners(parts: &[Part], corner_count: usize) -> Column<CornerId, EdgeId> {
    let mut corner_edge = vec![EdgeId(0); corner_count];
    let share = corner_count.div_ceil(parts.len()).max(1);
    let number = |(chunk, corner_edge): (usize, &mut [EdgeId])| {
        let mut edge = 0;
        for part in parts {
            for bounds in part.starts.windows(2) {
                for side in &part.edge_sides[bounds[0] as usize..bounds[1] as usize] {
                    let place = side.corner().index().wrapping_sub(chunk * share);
                    if let Some(slot) = corner_edge.get_mut(place) {
                        *slot = EdgeId(edge);
                    }
                }
                edge += 1;
            }
        }
    };
    if parts.len() == 1 {
        number((0, &mut corner_edge));
    } else {
        corner_edge.par_chunks_mut(share).enumerate().for_each(number);
    }
    corner_edge.into()
}

/// The sides whose smaller vertex is in a range, as (larger vertex, [`EdgeSide`]), grouped by smaller vertex and sorted
/// within each group.
fn bucket_sides(faces: &FaceTable, lows: Range<u32>) -> (Vec<u32>, Vec<u64>) {
    let mut starts = vec![0u32; lows.len()];
    // Lower vertices come out far beyond the end.
    let bucket = |from: VertexId, to: VertexId| from.min(to).0.wrapping_sub(lows.start) as usize;
    for_each_side(faces, |_, from, to| {
        if let Some(count) = starts.get_mut(bucket(from, to)) {
            *count += 1;
        }
    });
    let mut total = 0;
    for start in &mut starts {
        total += std::mem::replace(start, total);
    }
    let mut next = starts.clone();
    starts.push(total);
    let mut sides = vec![0u64; total as usize];
    for_each_side(faces, |corner, from, to| {
        if let Some(place) = next.get_mut(bucket(from, to)) {
            sides[*place as usize] =
                u64::from(from.max(to).0) << 32 | u64::from(corner.0 << 1 | u32::from(from < to));
            *place += 1;
        }
    });
    for bucket in starts.windows(2) {
        sides[bucket[0] as usize..bucket[1] as usize].sort_unstable();
    }
    (starts, sides)
}

fn for_each_side(faces: &FaceTable, mut visit: impl FnMut(CornerId, VertexId, VertexId)) {
    let vertices = faces.corner_vertices();
    if faces.is_all_triangles() {
        for (face, corners) in vertices.chunks_exact(3).enumerate() {
            let [a, b, c] = [corners[0], corners[1], corners[2]];
            visit(CornerId::new(3 * face), a, b);
            visit(CornerId::new(3 * face + 1), b, c);
            visit(CornerId::new(3 * face + 2), c, a);
        }
        return;
    }
    for face in faces.faces() {
        let range = faces.corner_range(face);
        for corner in range.clone() {
            let next = if corner + 1 == range.end { range.start } else { corner + 1 };
            visit(CornerId::new(corner), vertices[corner], vertices[next]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg_attr(miri, ignore = "the interpreter refuses the pool of threads, which is not ours")]
    fn however_many_parts_there_are_they_are_the_same_edges() {
        let mut state = 1u32;
        let mut next = |below: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) % below
        };
        for vertex_count in [3, 4, 7, 50] {
            let faces = (0..2 * vertex_count).map(|_| {
                let first = next(vertex_count);
                [first, (first + 1) % vertex_count, (first + 2 + next(vertex_count - 2)) % vertex_count]
            });
            let corners = faces.flatten().map(VertexId).collect();
            let faces = FaceTable::triangles(vertex_count as usize, corners).unwrap();
            let whole = EdgeTable::build_in_parts(&faces, 1);
            for count in [2, 3, 8, 60] {
                assert_eq!(EdgeTable::build_in_parts(&faces, count), whole);
            }
        }
        assert_eq!(EdgeTable::build_in_parts(&FaceTable::empty(0), 3).edge_count(), 0);
    }

    #[test]
    fn edges_are_numbered_by_their_ends_and_list_ascending_corners() {
        let corners = [2, 1, 0, 0, 1, 3, 1, 0, 4].map(VertexId).to_vec();
        let table = EdgeTable::build(&FaceTable::triangles(5, corners).unwrap());
        let ends: Vec<_> = table.all_ends().iter().map(|e| e.map(|v| v.0)).collect();
        assert_eq!(ends, [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [1, 3], [1, 4]]);
        assert!(table.edge_corners(EdgeId(0)).eq([1, 3, 6].map(CornerId)));
        let directions: Vec<bool> =
            table.edge_sides(EdgeId(0)).iter().map(|side| side.is_forward()).collect();
        assert_eq!(directions, [false, true, false]);
        assert_eq!(table.corner_edge(CornerId(7)), EdgeId(3));
    }
}
