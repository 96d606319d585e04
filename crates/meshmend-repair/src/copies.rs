//! Faces that repeat another one, in the same direction, and are kept because they differ from it.
//!
//! A decal lies on a body, and a second object on a first one, without being sewn to it: two sides of such faces are never
//! matched with each other. If such faces have neighbours, each is matched among the faces of its *rank*. The first of the
//! differing faces has rank 0, as have all faces that repeat no other; the next one has rank 1, and so on.

use meshmend_core::{Column, Connectivity, CornerId, FaceId, PolygonMesh};
use meshmend_topology::{AlikeFace, alike_faces};

use crate::Context;
use crate::telling::{Looks, Telling};

/// Stands for the cycle of a face that no differing face has in common with it.
const NONE: u32 = u32::MAX;

/// Which faces repeat others and differ from them.
#[derive(Clone, Debug)]
pub(crate) struct Copies {
    copies: Column<FaceId, Copied>,
}

#[derive(Clone, Copy, Debug)]
struct Copied {
    /// The number of the directed cycle.
    cycle: u32,
    rank: u32,
}

impl Copies {
    /// The differing repeats among the faces of a mesh, if there are any.
    ///
    /// *Cost*: that of [`alike_faces`] if some layer tells faces apart, else constant.
    pub(crate) fn find<K: Connectivity>(
        kernel: &K,
        mesh: &PolygonMesh,
        context: &Context<'_>,
    ) -> Option<Self> {
        if context.known.is_some_and(|report| report.duplicate_faces.same == 0) {
            return None;
        }
        let telling = Telling::of(mesh, context.telling)?;
        Self::among(kernel, mesh, &alike_faces(kernel), &telling)
    }

    /// The differing repeats among groups of faces that are alike up to direction, if there are any.
    pub(crate) fn among<K: Connectivity>(
        kernel: &K,
        mesh: &PolygonMesh,
        alike: &[Vec<AlikeFace>],
        telling: &Telling<'_>,
    ) -> Option<Self> {
        let mut found: Vec<(FaceId, Copied)> = Vec::new();
        let mut cycle = 0;
        for (group, is_reversed) in alike.iter().flat_map(|group| [(group, false), (group, true)]) {
            let faces: Vec<FaceId> = group
                .iter()
                .filter(|alike| alike.is_reversed == is_reversed)
                .map(|alike| alike.face)
                .collect();
            if faces.len() < 2 {
                continue;
            }
            let looks: Vec<Looks> = faces.iter().map(|&face| looks(kernel, mesh, face)).collect();
            let ranks = ranks(&telling.first_alike(&looks));
            if ranks.iter().any(|&rank| rank > 0) {
                found.extend(faces.iter().zip(ranks).map(|(&face, rank)| (face, Copied { cycle, rank })));
                cycle += 1;
            }
        }
        if found.is_empty() {
            return None;
        }
        let mut copies = Column::filled(Copied { cycle: NONE, rank: 0 }, kernel.face_count());
        found.into_iter().for_each(|(face, copied)| copies[face] = copied);
        Some(Copies { copies })
    }

    /// Whether two faces run round the same vertices in the same direction, and differ.
    pub(crate) fn are_apart(&self, one: FaceId, other: FaceId) -> bool {
        let (one, other) = (self.copies[one], self.copies[other]);
        one.cycle != NONE && one.cycle == other.cycle && one.rank != other.rank
    }

    /// How many differing faces come before a face.
    pub(crate) fn rank(&self, face: FaceId) -> u32 {
        self.copies[face].rank
    }

    /// The faces of rank 1 and more.
    pub(crate) fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.copies.iter().filter(|(_, copied)| copied.rank > 0).map(|(face, _)| face)
    }
}

/// A face of a complex as it is compared.
pub(crate) fn looks<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, face: FaceId) -> Looks {
    let complex = mesh.complex();
    let named = |corner: CornerId| (kernel.corner_vertex(corner), complex.stored_corner(corner));
    Looks::new(face, kernel.face_corners(face).map(named).collect())
}

/// For each place the number of its class, in the order in which classes first appear. Given is for each place the first
/// place of its class.
fn ranks(first_alike: &[usize]) -> Vec<u32> {
    let mut ranks: Vec<u32> = Vec::with_capacity(first_alike.len());
    let mut next = 0;
    for (place, &first) in first_alike.iter().enumerate() {
        if first == place {
            ranks.push(next);
            next += 1;
        } else {
            ranks.push(ranks[first]);
        }
    }
    ranks
}
