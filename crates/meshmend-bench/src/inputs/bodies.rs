//! Many boxes that touch: half of them share edges, half share vertices alone.
//!
//! ```text
//!   ▓ ▓ ▓      the boxes (i, j, k) with i + j + k even share their twelve edges with one another;
//!    ▓ ▓       those whose i, j, k are all even or all odd share their eight vertices
//!   ▓ ▓ ▓
//! ```

use super::{Known, Raw};

/// How many cells the side of a box has each way.
const CELLS: usize = 4;
const BOX_FACES: usize = 6 * CELLS * CELLS * 2;
const BOX_VERTICES: usize = 6 * CELLS * CELLS + 2;
const BOX_EDGES: usize = BOX_FACES / 2 * 3;

/// Two blocks of boxes side by side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Bodies {
    /// Places for boxes in the block whose boxes share edges.
    edges: [usize; 3],
    /// Places for boxes in the block whose boxes share vertices.
    vertices: [usize; 3],
}

impl Bodies {
    /// The boxes of about so many faces.
    pub(super) fn of_about(faces: usize) -> Self {
        // Every other place of the one block is taken, and every fourth one of the other.
        let half = faces / BOX_FACES / 2;
        Bodies { edges: block(2 * half), vertices: block(4 * half) }
    }

    pub(super) fn known(&self) -> Known {
        let boxes = (self.in_edges().count() + self.in_vertices().count()) as u64;
        let shared = (self.shared_box_edges() * CELLS) as u64;
        Known {
            faces: boxes * BOX_FACES as u64,
            mended_faces: boxes * BOX_FACES as u64,
            mended_vertices: boxes * BOX_VERTICES as u64,
            edges: boxes * BOX_EDGES as u64 - shared,
            boundary_edges: 0,
            non_manifold_edges: shared,
            crossing_faces: 0,
        }
    }

    pub(super) fn raw(&self) -> Raw {
        let mut raw = Raw::default();
        Lattice::new(self.edges, 0.0).add(self.in_edges(), &mut raw);
        let beside = ((self.edges[0] + 2) * CELLS) as f64;
        Lattice::new(self.vertices, beside).add(self.in_vertices(), &mut raw);
        raw
    }

    fn in_edges(&self) -> impl Iterator<Item = [usize; 3]> {
        places(self.edges).filter(|place| is_in_edges(*place))
    }

    fn in_vertices(&self) -> impl Iterator<Item = [usize; 3]> {
        places(self.vertices).filter(|[i, j, k]| i % 2 == j % 2 && j % 2 == k % 2)
    }

    /// How many edges of boxes are shared by two, which lie across from one another.
    fn shared_box_edges(&self) -> usize {
        let is_there = |place: [usize; 3]| (0..3).all(|axis| place[axis] < self.edges[axis]);
        let shared = |place: [usize; 3]| {
            let across = [(0, 1), (1, 2), (2, 0)].into_iter().flat_map(move |(one, other)| {
                let mut ahead = place;
                ahead[one] += 1;
                ahead[other] += 1;
                let mut aside = place;
                aside[one] += 1;
                // Below the first place there is none; the number wraps round and is nowhere.
                aside[other] = aside[other].wrapping_sub(1);
                [ahead, aside]
            });
            across.filter(|&other| is_there(other)).count()
        };
        self.in_edges().map(shared).sum()
    }
}

fn is_in_edges([i, j, k]: [usize; 3]) -> bool {
    (i + j + k) % 2 == 0
}

/// The sides of a block of about so many places.
fn block(places: usize) -> [usize; 3] {
    let side = (places as f64).cbrt().round().max(2.0) as usize;
    [side, side, (places as f64 / (side * side) as f64).round().max(2.0) as usize]
}

fn places([n, m, l]: [usize; 3]) -> impl Iterator<Item = [usize; 3]> {
    (0..n).flat_map(move |i| (0..m).flat_map(move |j| (0..l).map(move |k| [i, j, k])))
}

/// The points of the boxes' cells, and which vertex each one is.
struct Lattice {
    size: [usize; 3],
    /// Where the lattice begins on the first axis.
    start: f64,
    vertex: Vec<u32>,
}

const NO_VERTEX: u32 = u32::MAX;

impl Lattice {
    fn new(block: [usize; 3], start: f64) -> Self {
        let size = block.map(|places| places * CELLS + 1);
        Lattice { size, start, vertex: vec![NO_VERTEX; size.iter().product()] }
    }

    fn add(&mut self, boxes: impl Iterator<Item = [usize; 3]>, raw: &mut Raw) {
        for place in boxes {
            for axis in 0..3 {
                self.add_side(place, axis, 0, raw);
                self.add_side(place, axis, CELLS, raw);
            }
        }
    }

    /// Adds the side of a box that looks along an axis, at a depth of 0 or of the whole box.
    fn add_side(&mut self, place: [usize; 3], axis: usize, depth: usize, raw: &mut Raw) {
        let mut point = |u: usize, v: usize| {
            let mut point = place.map(|i| i * CELLS);
            point[axis] += depth;
            point[(axis + 1) % 3] += u;
            point[(axis + 2) % 3] += v;
            self.vertex(point, &mut raw.positions)
        };
        for (u, v) in (0..CELLS).flat_map(|u| (0..CELLS).map(move |v| (u, v))) {
            let [a, b, c, d] = [(u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)].map(|(u, v)| point(u, v));
            let outward = if depth == 0 { [[a, c, b], [a, d, c]] } else { [[a, b, c], [a, c, d]] };
            raw.triangles.extend(outward);
        }
    }

    fn vertex(&mut self, [i, j, k]: [usize; 3], positions: &mut Vec<[f64; 3]>) -> u32 {
        let vertex = &mut self.vertex[(i * self.size[1] + j) * self.size[2] + k];
        if *vertex == NO_VERTEX {
            *vertex = positions.len() as u32;
            positions.push([self.start + i as f64, j as f64, k as f64]);
        }
        *vertex
    }
}
