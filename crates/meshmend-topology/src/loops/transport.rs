//! Does a closed path come back with its sides exchanged?
//!
//! Each vertex of a surface has one umbrella, which can be given a side: one of its faces says which, and the others
//! follow round the vertex. Along an edge the sides of its two ends agree or not, by any face there. With the sides
//! of the vertices chosen so that they agree along a tree, the loop that one more edge closes with the tree comes back
//! as it went out, and so has an annular neighbourhood, exactly when the edge's ends agree.

use meshmend_core::{Column, Connectivity, CornerId, EdgeId};

use super::forest::Forest;
use crate::Patches;

/// The sides of all umbrellas, chosen to agree along the trees of a forest.
pub(super) struct Transport {
    /// Whether the face of a corner lies the other way round than the umbrella there; empty where every patch is
    /// orientable.
    is_turned: Column<CornerId, bool>,
}

impl Transport {
    /// *Cost*: nothing where every patch is orientable, else linear; 1 byte a corner.
    pub(super) fn along<K: Connectivity>(kernel: &K, patches: &Patches, forest: &Forest) -> Self {
        if patches.ids().all(|patch| patches.is_orientable(patch)) {
            return Transport { is_turned: Column::default() };
        }
        let mut transport = Transport { is_turned: round_umbrellas(kernel, patches) };
        let mut is_vertex_turned = Column::filled(false, kernel.vertex_count());
        for &vertex in &forest.order {
            let Some(edge) = forest.entry(vertex) else { continue };
            let parent = forest.ancestors.parent(vertex);
            is_vertex_turned[vertex] = is_vertex_turned[parent] ^ transport.is_turning(kernel, edge);
        }
        for corner in kernel.corners() {
            transport.is_turned[corner] ^= is_vertex_turned[kernel.corner_vertex(corner)];
        }
        transport
    }

    /// Whether the ends of an edge disagree about their side.
    pub(super) fn is_turning<K: Connectivity>(&self, kernel: &K, edge: EdgeId) -> bool {
        let side = kernel.edge_corners(edge).next().filter(|_| !self.is_turned.is_empty());
        side.is_some_and(|corner| self.is_turned[corner] ^ self.is_turned[kernel.next_corner(corner)])
    }
}

/// For each corner whether its face lies the other way round than the face of the first corner of its umbrella.
fn round_umbrellas<K: Connectivity>(kernel: &K, patches: &Patches) -> Column<CornerId, bool> {
    let mut is_turned = Column::filled(false, kernel.corner_count());
    let mut is_seen = Column::filled(false, kernel.corner_count());
    let mut open: Vec<CornerId> = Vec::new();
    for first in kernel.corners() {
        if std::mem::replace(&mut is_seen[first], true) {
            continue;
        }
        open.push(first);
        while let Some(corner) = open.pop() {
            for (neighbour, is_mirrored) in neighbours(kernel, patches, corner).into_iter().flatten() {
                if !std::mem::replace(&mut is_seen[neighbour], true) {
                    is_turned[neighbour] = is_turned[corner] ^ is_mirrored;
                    open.push(neighbour);
                }
            }
        }
    }
    is_turned
}

/// The corners of the same vertex across the two edges there, each with whether its face is mirrored.
fn neighbours<K: Connectivity>(
    kernel: &K,
    patches: &Patches,
    corner: CornerId,
) -> [Option<(CornerId, bool)>; 2] {
    let at_this_vertex = |side: CornerId, begins_here: bool| {
        let crossing = patches.crossings().across(side)?;
        // The side across begins where this one does if it is mirrored, else where this one ends.
        let opposite_begins_here = crossing.is_mirrored == begins_here;
        let next =
            if opposite_begins_here { crossing.opposite } else { kernel.next_corner(crossing.opposite) };
        Some((next, crossing.is_mirrored))
    };
    [at_this_vertex(corner, true), at_this_vertex(kernel.prev_corner(corner), false)]
}
