//! Which pairs of sides are left unmatched where a patch is cut to be orientable.
//!
//! The pairs go into a parity union-find one after another, and what contradicts stays unmatched. So the order
//! decides where the seam is, and the pairs of a short one come last. A pair of rule 1 is only cut where rule 1 alone
//! contradicts: what was cut before is stitched by rule 2, and stays cut at the same place.

use meshmend_core::{Column, Connectivity, CornerId, FaceId, Joined, SidedClasses};
use meshmend_topology::{DualEdge, short_seam};

use super::uses::Pair;
use crate::StoredNames;
use crate::matching::run_the_same_way;

/// The pairs in their order, but for those of short seams, which come last.
///
/// *Cost*: near-linear where nothing contradicts; else that of [`short_seam`] on the classes in which something does.
pub(super) fn seams_last<K: Connectivity>(
    kernel: &K,
    names: &StoredNames<'_>,
    pairs: Vec<Pair>,
) -> Vec<Pair> {
    let is_twisted = twisted_faces(kernel, &pairs);
    let is_of_twisted = |pair: &Pair| is_twisted[kernel.corner_face(pair.0)];
    let dual_edges: Vec<DualEdge> =
        pairs.iter().filter(|pair| is_of_twisted(pair)).map(|&pair| dual_edge(kernel, names, pair)).collect();
    if dual_edges.is_empty() {
        return pairs;
    }
    let mut is_cut = short_seam(&dual_edges).into_iter();
    let (last, mut first): (Vec<Pair>, Vec<Pair>) =
        pairs.into_iter().partition(|pair| is_of_twisted(pair) && is_cut.next() == Some(true));
    first.extend(last);
    first
}

/// Whether a face is in a class in which pairs contradict.
fn twisted_faces<K: Connectivity>(kernel: &K, pairs: &[Pair]) -> Column<FaceId, bool> {
    let mut sets = SidedClasses::new(kernel.face_count());
    let mut contradicted = Vec::new();
    for &(one, other) in pairs {
        let (f, g) = (kernel.corner_face(one), kernel.corner_face(other));
        if let Joined::Contradicts { root } = sets.join(f, g, run_the_same_way(kernel, one, other)) {
            contradicted.push(root);
        }
    }
    let mut is_twisted = Column::filled(false, kernel.face_count());
    contradicted.into_iter().for_each(|face| is_twisted[sets.find(face).0] = true);
    kernel.faces().map(|face| is_twisted[sets.find(face).0]).collect()
}

fn dual_edge<K: Connectivity>(kernel: &K, names: &StoredNames<'_>, (one, other): Pair) -> DualEdge {
    let stored = |corner: CornerId| {
        let (from, to) = (names.of(corner), names.of(kernel.next_corner(corner)));
        (from.min(to), from.max(to))
    };
    // There are fewer pairs than would outweigh one of rule 1.
    let weight = if stored(one) == stored(other) { u32::MAX } else { 1 };
    let faces = [one, other].map(|corner| kernel.corner_face(corner));
    DualEdge { faces, is_mirrored: run_the_same_way(kernel, one, other), weight }
}
