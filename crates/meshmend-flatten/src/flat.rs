//! What has to lie flat on a side of a square.
//!
//! ```text
//!        ┌───────────┐
//!        │           │      all that the edge a-b cuts off has its boundary between a and b, on one straight side,
//!        │           │      and so nowhere else to be
//!        └──a─────b──┘
//!           └──x──┘
//! ```
//!
//! A free node is flat on a side when every way from it to the rest of the boundary leads through a node of that
//! side. The theorem puts it exactly on the side, rounding only nearly; so it is put there.

use meshmend_core::FaceId;

use crate::boundary_placement::Cell;
use crate::discs::Discs;
use crate::laplacian::Laplacian;

/// The nodes on a side of a square, those of the boundary too.
#[derive(Debug, Default)]
pub(crate) struct Flat {
    /// The sides of each node as bits; empty where there is no square.
    sides: Vec<u8>,
    /// The free nodes that are flat: which of their coordinates, and what it is.
    pressed: Vec<(u32, usize, f64)>,
}

const NONE: u32 = u32::MAX;

impl Flat {
    /// Those of discs whose rims are on squares; only the points of the rims count.
    pub(crate) fn find(laplacian: &Laplacian, discs: &Discs, cells: &[Cell], points: &[[f64; 2]]) -> Self {
        let neighbours = Neighbours::of(laplacian, points.len());
        let disc_of = neighbours.reach(discs.rim_nodes(), |_| true);
        let free = || (0..points.len() as u32).filter(|&node| laplacian.is_free(node as usize));
        let mut flat = Flat { sides: vec![0; points.len()], pressed: Vec::new() };
        for side in 0..4 {
            let line = |disc: u32| cells[disc as usize].line(side);
            let is_on = |node: u32, (axis, value): (usize, f64)| points[node as usize][axis] == value;
            let (on, off): (Vec<_>, Vec<_>) =
                discs.rim_nodes().partition(|&(node, disc)| is_on(node, line(disc)));
            on.iter().for_each(|&(node, _)| flat.sides[node as usize] |= 1 << side);
            let reached = neighbours.reach(off.into_iter(), |node| laplacian.is_free(node as usize));
            for node in free().filter(|&node| reached[node as usize] == NONE) {
                let (axis, value) = line(disc_of[node as usize]);
                flat.sides[node as usize] |= 1 << side;
                flat.pressed.push((node, axis, value));
            }
        }
        flat
    }

    /// Puts the flat nodes exactly on their sides.
    pub(crate) fn press(&self, points: &mut [[f64; 2]]) {
        self.pressed.iter().for_each(|&(node, axis, value)| points[node as usize][axis] = value);
    }

    /// Whether a node lies on a side and has to stay there.
    pub(crate) fn holds(&self, node: u32) -> bool {
        self.sides.get(node as usize).is_some_and(|&sides| sides != 0)
    }

    /// How many faces can't but collapse.
    pub(crate) fn collapsed_faces(&self, discs: &Discs) -> usize {
        if self.sides.is_empty() {
            return 0;
        }
        let sides =
            |triangle: &[u32; 3]| triangle.iter().fold(!0, |all, &node| all & self.sides[node as usize]);
        let triangles = discs.triangles.iter().zip(&discs.face_of);
        let mut faces: Vec<FaceId> =
            triangles.filter(|(triangle, _)| sides(triangle) != 0).map(|(_, &face)| face).collect();
        faces.dedup();
        faces.len()
    }
}

/// The nodes that an edge joins to each node.
struct Neighbours {
    starts: Vec<u32>,
    nodes: Vec<u32>,
}

impl Neighbours {
    fn of(laplacian: &Laplacian, node_count: usize) -> Self {
        let mut starts = vec![0u32; node_count + 1];
        laplacian.ends.iter().flatten().for_each(|&node| starts[node as usize + 1] += 1);
        (0..node_count).for_each(|node| starts[node + 1] += starts[node]);
        let mut nodes = vec![0; 2 * laplacian.ends.len()];
        let mut next = starts.clone();
        for &[a, b] in &laplacian.ends {
            for (from, to) in [(a, b), (b, a)] {
                nodes[next[from as usize] as usize] = to;
                next[from as usize] += 1;
            }
        }
        Neighbours { starts, nodes }
    }

    /// The label of the start from which each node is reached through nodes that may be entered, or `NONE`.
    fn reach(&self, starts: impl Iterator<Item = (u32, u32)>, may_enter: impl Fn(u32) -> bool) -> Vec<u32> {
        let mut label = vec![NONE; self.starts.len() - 1];
        let mut open = Vec::new();
        for (node, name) in starts {
            label[node as usize] = name;
            open.push(node);
        }
        while let Some(node) = open.pop() {
            let range = self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize;
            for &next in &self.nodes[range] {
                if label[next as usize] == NONE && may_enter(next) {
                    label[next as usize] = label[node as usize];
                    open.push(next);
                }
            }
        }
        label
    }
}
