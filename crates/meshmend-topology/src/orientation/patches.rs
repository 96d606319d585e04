//! Which faces hang together across edges with two sides, and which way does each face?
//!
//! A *patch* is a class of faces joined across edges of degree 2. A breadth-first walk from the patch's lowest
//! face, neighbours in corner order, gives each face a *side*: the same as its predecessor's when the two sides
//! along their edge run opposite ways, the other one when they run the same way. The patch is *orientable* when
//! no edge of degree 2 contradicts the sides that the walk gave.

use meshmend_core::{Column, Connectivity, FaceId, Id};

use crate::PatchId;
use crate::orientation::crossings::Crossings;

/// Which way a face lies, against the lowest face of its patch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Side {
    /// As the lowest face.
    Same,
    /// The other way round.
    Reversed,
}

impl Side {
    /// The other side.
    pub fn other(self) -> Self {
        match self {
            Side::Same => Side::Reversed,
            Side::Reversed => Side::Same,
        }
    }

    /// The side that a face must have to agree with one of this side, across an edge whose two sides run the
    /// same way or not.
    #[inline]
    pub(crate) fn across(self, is_mirrored: bool) -> Self {
        if is_mirrored { self.other() } else { self }
    }
}

/// The patches of a complex, numbered by lowest face.
#[derive(Clone, Debug)]
pub struct Patches {
    /// For each face its patch, doubled, plus one where its side is the other one; `NO_PATCH` for a degenerate one.
    of_face: Column<FaceId, u32>,
    /// Where each patch begins in `order`, and one more.
    starts: Vec<u32>,
    order: Vec<FaceId>,
    is_orientable: Column<PatchId, bool>,
    crossings: Crossings,
}

const NO_PATCH: u32 = u32::MAX;

impl Patches {
    /// How many patches there are.
    pub fn count(&self) -> usize {
        self.is_orientable.len()
    }

    /// Every patch, ascending.
    pub fn ids(&self) -> impl ExactSizeIterator<Item = PatchId> + Clone + use<> {
        (0..self.count()).map(PatchId::new)
    }

    /// The patch of a face; `None` for a degenerate one.
    #[inline]
    pub fn of_face(&self, face: FaceId) -> Option<PatchId> {
        let word = self.of_face[face];
        (word != NO_PATCH).then_some(PatchId(word >> 1))
    }

    /// The faces of a patch in the order of the breadth-first walk, its lowest face first.
    pub fn faces(&self, patch: PatchId) -> &[FaceId] {
        &self.order[self.starts[patch.index()] as usize..self.starts[patch.index() + 1] as usize]
    }

    /// The side that the walk gave a face; that of the lowest for a degenerate one.
    #[inline]
    pub fn side(&self, face: FaceId) -> Side {
        let word = self.of_face[face];
        if word != NO_PATCH && word & 1 == 1 { Side::Reversed } else { Side::Same }
    }

    /// Whether the faces of a patch can be flipped so that none of its edges is inconsistent.
    pub fn is_orientable(&self, patch: PatchId) -> bool {
        self.is_orientable[patch]
    }

    pub(crate) fn crossings(&self) -> &Crossings {
        &self.crossings
    }
}

/// The patches of a complex, each with its sides and whether it is orientable.
///
/// *Cost*: linear in the corners; 8 bytes a face and 4 a corner.
pub fn patches<K: Connectivity>(kernel: &K) -> Patches {
    let mut found = Patches {
        of_face: Column::filled(NO_PATCH, kernel.face_count()),
        starts: vec![0],
        order: Vec::with_capacity(kernel.face_count()),
        is_orientable: Column::default(),
        crossings: Crossings::of(kernel),
    };
    for face in kernel.faces() {
        if found.of_face[face] == NO_PATCH && kernel.is_proper_face(face) {
            walk(kernel, face, &mut found);
        }
    }
    found
}

/// Adds the patch of a face that is in none yet.
fn walk<K: Connectivity>(kernel: &K, lowest: FaceId, found: &mut Patches) {
    let patch = found.count() as u32;
    let mut is_orientable = true;
    let mut next = found.order.len();
    // Each patch has corners, of which there are fewer than 2³¹, so the doubled number fits.
    found.of_face[lowest] = patch << 1;
    found.order.push(lowest);
    while let Some(&face) = found.order.get(next) {
        next += 1;
        let own = found.of_face[face];
        for corner in kernel.face_corners(face) {
            let Some(crossing) = found.crossings.across(corner) else { continue };
            let neighbour = kernel.corner_face(crossing.opposite);
            let word = own ^ u32::from(crossing.is_mirrored);
            let known = &mut found.of_face[neighbour];
            if *known == NO_PATCH {
                *known = word;
                found.order.push(neighbour);
            } else {
                is_orientable &= *known == word;
            }
        }
    }
    found.starts.push(found.order.len() as u32);
    found.is_orientable.push(is_orientable);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{kernel, moebius_band, torus};

    #[test]
    fn patches_end_at_non_manifold_edges_and_at_vertices() {
        // Three triangles on an edge, and a fourth that touches one of them in a vertex.
        let found = patches(&kernel(7, &[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4], &[4, 5, 6]]));
        assert_eq!(found.count(), 4);
        let pair = patches(&kernel(4, &[&[2, 1, 3], &[], &[0, 1, 2]]));
        assert_eq!(pair.faces(PatchId(0)), [FaceId(0), FaceId(2)]);
        assert_eq!(pair.of_face(FaceId(1)), None);
    }

    #[test]
    fn sides_tell_which_faces_to_flip() {
        let found = patches(&kernel(5, &[&[0, 1, 2], &[1, 2, 3], &[2, 3, 4]]));
        assert!(found.is_orientable(PatchId(0)));
        assert_eq!([0, 1, 2].map(|f| found.side(FaceId(f))), [Side::Same, Side::Reversed, Side::Same]);
    }

    #[test]
    fn a_moebius_band_has_no_sides() {
        assert!(!patches(&moebius_band(7).kernel()).is_orientable(PatchId(0)));
        assert!(patches(&torus(3, 4).kernel()).is_orientable(PatchId(0)));
    }
}
