//! Which faces are flipped in a mesh without repeated faces, in which no edge has three sides and all patches are
//! orientable.
//!
//! Most meshes are like this. All sides that share an edge are matched, so the patches are those of the topology. They come
//! together at once, so the majority of each decides. Without duplicates no patch goes.

use meshmend_core::{Connectivity, FaceId};
use meshmend_topology::{Patches, Side, patches};

use super::fates::Fates;

/// Which faces are flipped so that each patch runs as most of its faces do, and on a tie as its lowest face does. Returns
/// `None` if an edge has three sides or more, or a patch is not orientable.
pub(super) fn fates<K: Connectivity>(kernel: &K) -> Option<Fates> {
    let mut is_consistent = true;
    for edge in kernel.edges() {
        let mut sides = kernel.edge_sides(edge);
        match (sides.next(), sides.next(), sides.next()) {
            (Some((_, one)), Some((_, other)), None) => is_consistent &= one != other,
            (_, _, None) => {}
            _ => return None,
        }
    }
    let mut fates = Fates::unchanged(kernel.face_count());
    if is_consistent {
        return Some(fates);
    }
    let patches = patches(kernel);
    for patch in patches.ids() {
        if !patches.is_orientable(patch) {
            return None;
        }
        let minority = minority(&patches, patches.faces(patch));
        let faces = patches.faces(patch).iter();
        faces.filter(|&&face| patches.side(face) == minority).for_each(|&face| fates.flip(face));
    }
    Some(fates)
}

/// The side that fewer faces of a patch have, and on a tie not its lowest face.
fn minority(patches: &Patches, faces: &[FaceId]) -> Side {
    let reversed = faces.iter().filter(|&&face| patches.side(face) == Side::Reversed).count();
    if 2 * reversed <= faces.len() { Side::Reversed } else { Side::Same }
}
