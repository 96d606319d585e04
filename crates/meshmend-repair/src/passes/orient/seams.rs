//! Which pairs of sides are left unmatched if a patch is cut to be orientable.
//!
//! The pairs go into a parity union-find one after another, and a pair that contradicts stays unmatched. So the order
//! decides where the seam is, and the pairs of a short seam come last. A pair of rule 1 is only cut if rule 1 alone
//! contradicts: a seam that was cut before is stitched by rule 2, and is cut at the same place again.

use meshmend_core::{Column, Connectivity, CornerId, FaceId, Joined, SidedClasses};
use meshmend_topology::{DualEdge, short_seam};

use super::live_matching::Pair;
use crate::matching::run_the_same_way;
use crate::stored_vertices::StoredVertices;

/// The pairs in their order, except that those of short seams come last. If sides already clash along a seam that is not
/// longer, that one is kept: so a seam that is stitched when the mesh is read again is found at the same place.
///
/// *Cost*: near-linear if no pair contradicts; else that of [`short_seam`] on the classes in which one does.
pub(super) fn seams_last<K: Connectivity>(
    kernel: &K,
    names: &StoredVertices<'_>,
    pairs: Vec<Pair>,
) -> Vec<Pair> {
    let twisted = twisted_classes(kernel, &pairs);
    let class_of = |pair: &Pair| twisted[kernel.corner_face(pair.0)];
    let (classes, dual_edges): (Vec<FaceId>, Vec<DualEdge>) =
        pairs.iter().filter_map(|pair| Some((class_of(pair)?, dual_edge(kernel, names, *pair)))).unzip();
    if dual_edges.is_empty() {
        return pairs;
    }
    let mut is_cut = short_seam(&dual_edges);
    let mut longer = Column::filled(0_i64, kernel.face_count());
    for ((&class, dual), &is_cut) in classes.iter().zip(&dual_edges).zip(&is_cut) {
        longer[class] += i64::from(dual.weight) * (i64::from(is_cut) - i64::from(dual.is_mirrored));
    }
    for ((&class, dual), is_cut) in classes.iter().zip(&dual_edges).zip(&mut is_cut) {
        if longer[class] >= 0 {
            *is_cut = dual.is_mirrored;
        }
    }
    let mut is_cut = is_cut.into_iter();
    let (last, mut first): (Vec<Pair>, Vec<Pair>) =
        pairs.into_iter().partition(|pair| class_of(pair).is_some() && is_cut.next() == Some(true));
    first.extend(last);
    first
}

/// For each face its class, if pairs contradict in it.
fn twisted_classes<K: Connectivity>(kernel: &K, pairs: &[Pair]) -> Column<FaceId, Option<FaceId>> {
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
    kernel.faces().map(|face| Some(sets.find(face).0).filter(|&root| is_twisted[root])).collect()
}

fn dual_edge<K: Connectivity>(kernel: &K, names: &StoredVertices<'_>, (one, other): Pair) -> DualEdge {
    let stored = |corner: CornerId| {
        let (from, to) = (names.of(corner), names.of(kernel.next_corner(corner)));
        (from.min(to), from.max(to))
    };
    // There are fewer pairs than would outweigh one of rule 1.
    let weight = if stored(one) == stored(other) { u32::MAX } else { 1 };
    let faces = [one, other].map(|corner| kernel.corner_face(corner));
    DualEdge { faces, is_mirrored: run_the_same_way(kernel, one, other), weight }
}
