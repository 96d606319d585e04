//! Patches that merge and drop out, each kept consistently oriented with as few flips as can be.
//!
//! A patch is made of pieces that were consistent before they merged, so a merge flips whole pieces, never more than
//! half of the faces: each flip of a face at least doubles its patch, and all flips together are O(n log n).

use std::cmp::Reverse;

use meshmend_core::{Column, Connectivity, FaceId, Joined, PolygonMesh, SidedClasses, Unjudged};

use super::live_matching::Pair;
use super::repeats::{Cycles, Owners};
use crate::matching::run_the_same_way;
use meshmend_geometry::SignedVolume;

/// How the side of a patch is chosen.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Sides {
    /// As stored: nothing is flipped.
    Stored,
    /// As most faces have it; on a tie as the lowest face has it.
    Majority,
    /// Outward for closed patches, else by majority.
    Outward,
}

/// What happens to sides that contradict.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Contradiction {
    /// The patch is twisted, and nothing in it is flipped from then on.
    Twists,
    /// The pair is not joined: it is part of a seam.
    Cuts,
}

pub(crate) struct Patches<'a, K> {
    kernel: &'a K,
    mesh: &'a PolygonMesh,
    cycles: &'a Cycles,
    sides: Sides,
    contradiction: Contradiction,
    sets: SidedClasses<FaceId>,
    owners: Owners,
    pub(crate) is_alive: Column<FaceId, bool>,
    pub(crate) is_flipped: Column<FaceId, bool>,
    /// The members of each patch, as rings; and the pieces of a patch that is being merged, likewise.
    next_member: Column<FaceId, FaceId>,
    next_piece: Column<FaceId, FaceId>,
    patch: Column<FaceId, Patch>,
}

/// What is known of a patch, at its root.
#[derive(Clone, Copy)]
struct Patch {
    size: u32,
    lowest: FaceId,
    label: FaceId,
    free_uses: u32,
    /// A face is flipped when it is turned against its root, or this is set, but not both.
    is_turned: bool,
    is_twisted: bool,
    is_cut: bool,
}

impl<'a, K: Connectivity> Patches<'a, K> {
    /// Each alive face a patch of its own.
    pub(crate) fn new(
        kernel: &'a K,
        mesh: &'a PolygonMesh,
        cycles: &'a Cycles,
        (sides, contradiction): (Sides, Contradiction),
        (is_alive, is_flipped): (Column<FaceId, bool>, Column<FaceId, bool>),
    ) -> Self {
        let count = kernel.face_count();
        let mut owners = Owners::new(cycles, count);
        let each = || (0..count as u32).map(FaceId);
        if !cycles.is_empty() {
            for face in each().filter(|&f| is_alive[f]) {
                owners.enter(cycles.slot(face, is_flipped[face]), face);
                owners.ask_again(face);
            }
        }
        let patch = |face| Patch {
            size: 1,
            lowest: face,
            label: face,
            free_uses: kernel.face_corners(face).count() as u32,
            is_turned: is_flipped[face],
            is_twisted: false,
            is_cut: false,
        };
        Patches {
            patch: each().map(patch).collect(),
            sets: SidedClasses::new(count),
            next_member: each().collect(),
            next_piece: each().collect(),
            kernel,
            mesh,
            cycles,
            sides,
            contradiction,
            owners,
            is_alive,
            is_flipped,
        }
    }

    /// Joins patches across newly matched sides, and orients what has come together.
    pub(crate) fn merge(&mut self, pairs: &[Pair]) {
        let (mut touched, mut twisted) = (Vec::new(), Vec::new());
        let mut matched = Vec::new();
        for &(one, other) in pairs {
            let (f, g) = (self.kernel.corner_face(one), self.kernel.corner_face(other));
            match self.sets.join(f, g, run_the_same_way(self.kernel, one, other)) {
                Joined::Merged { root, child } => {
                    swap(&mut self.next_piece, root, child);
                    touched.push(root);
                }
                Joined::Agrees => {}
                Joined::Contradicts { root } => {
                    twisted.push(root);
                    continue;
                }
            }
            if self.sides == Sides::Outward {
                matched.push(f);
            }
        }
        for faces in [&mut touched, &mut twisted, &mut matched] {
            faces.iter_mut().for_each(|face| *face = self.sets.find(*face).0);
            faces.sort_unstable();
        }
        let mut roots = [touched, twisted.clone(), matched.clone()].concat();
        roots.sort_unstable();
        roots.dedup();
        for root in roots {
            let matched_uses = 2 * run_length(&matched, root);
            self.gather(root, twisted.binary_search(&root).is_ok(), matched_uses as u32);
        }
    }

    /// Makes one patch of the pieces that were joined under a root.
    fn gather(&mut self, root: FaceId, contradicts: bool, matched_uses: u32) {
        let pieces = ring(&self.next_piece, root);
        let known: Vec<Patch> = pieces.iter().map(|&p| self.patch[p]).collect();
        let largest =
            known.iter().max_by_key(|p| (p.size, Reverse(p.label))).copied().unwrap_or(self.patch[root]);
        let size = known.iter().map(|p| p.size).sum();
        let free: u32 = known.iter().map(|p| p.free_uses).sum();
        let cuts = self.contradiction == Contradiction::Cuts;
        let mut whole = Patch {
            size,
            lowest: known.iter().map(|p| p.lowest).min().unwrap_or(root),
            label: largest.label,
            free_uses: free.saturating_sub(matched_uses),
            is_turned: false,
            is_twisted: known.iter().any(|p| p.is_twisted) || (contradicts && !cuts),
            is_cut: known.iter().any(|p| p.is_cut) || (contradicts && cuts),
        };
        let turned: Vec<bool> =
            pieces.iter().zip(&known).map(|(&p, k)| self.sets.find(p).1 ^ k.is_turned).collect();
        for (&piece, known) in pieces.iter().zip(&known) {
            if known.label != whole.label && !self.cycles.is_empty() {
                self.relabel(piece, known.label, whole.label);
            }
        }
        if self.sides != Sides::Stored && !whole.is_twisted {
            whole.is_turned = self.chosen_side(&pieces, &known, &turned, &whole);
            for (&piece, _) in pieces.iter().zip(&turned).filter(|(_, turned)| **turned != whole.is_turned) {
                self.flip(piece, whole.label);
            }
        }
        for &piece in &pieces {
            self.next_piece[piece] = piece;
            if piece != root {
                swap(&mut self.next_member, root, piece);
            }
        }
        self.patch[root] = whole;
        if !self.cycles.is_empty() && self.owners.is_duplicate(whole.label) {
            self.owners.ask_again(whole.label);
        }
    }

    /// Whether the faces that agree with the root are to be flipped.
    ///
    /// A piece of which `turned` is set has to be flipped if the answer is no, and the others if it is yes.
    fn chosen_side(&self, pieces: &[FaceId], known: &[Patch], turned: &[bool], whole: &Patch) -> bool {
        if self.sides == Sides::Outward && whole.free_uses == 0 && !whole.is_cut {
            let mut volume = SignedVolume::default();
            for (&piece, turned) in pieces.iter().zip(turned) {
                for face in ring(&self.next_member, piece) {
                    let is_flipped = self.is_flipped[face] ^ turned;
                    volume.add_face(self.mesh, self.kernel.face_corners(face), is_flipped);
                }
            }
            if volume.sign() != 0 {
                return volume.sign() < 0;
            }
        }
        let of_turned = |(patch, turned): (&Patch, &bool)| if *turned { patch.size } else { 0 };
        let flips_if_not: u32 = known.iter().zip(turned).map(of_turned).sum();
        match (2 * u64::from(flips_if_not)).cmp(&u64::from(whole.size)) {
            std::cmp::Ordering::Less => false,
            std::cmp::Ordering::Greater => true,
            std::cmp::Ordering::Equal => {
                known.iter().zip(turned).any(|(patch, &turned)| patch.lowest == whole.lowest && turned)
            }
        }
    }

    fn flip(&mut self, piece: FaceId, label: FaceId) {
        for face in ring(&self.next_member, piece) {
            if !self.cycles.is_empty() {
                self.owners.leave(self.cycles.slot(face, self.is_flipped[face]), label);
                self.owners.enter(self.cycles.slot(face, !self.is_flipped[face]), label);
            }
            self.is_flipped[face] ^= true;
        }
    }

    fn relabel(&mut self, piece: FaceId, from: FaceId, to: FaceId) {
        for face in ring(&self.next_member, piece) {
            let slot = self.cycles.slot(face, self.is_flipped[face]);
            self.owners.leave(slot, from);
            self.owners.enter(slot, to);
        }
    }

    /// Drops patches each of whose faces is doubled, the same way, in another patch: the smallest first, of equal
    /// ones the one with the higher lowest face. Gives the faces that go.
    ///
    /// One round is enough until patches merge or are flipped: who is not asked again still has the face that no
    /// other patch doubles.
    pub(crate) fn drop_duplicates(&mut self) -> Vec<FaceId> {
        let mut candidates: Vec<(u32, Reverse<FaceId>, FaceId)> = Vec::new();
        for label in self.owners.take_unblocked() {
            let patch = self.patch[self.sets.find(label).0];
            if patch.label == label && self.is_alive[label] && self.owners.is_duplicate(label) {
                candidates.push((patch.size, Reverse(patch.lowest), label));
            }
        }
        candidates.sort_unstable();
        candidates.dedup();
        let mut gone = Vec::new();
        for (_, _, label) in candidates {
            if !self.owners.is_duplicate(label) {
                continue;
            }
            for face in ring(&self.next_member, label) {
                self.is_alive[face] = false;
                self.owners.leave(self.cycles.slot(face, self.is_flipped[face]), label);
                gone.push(face);
            }
        }
        gone
    }

    /// The faces of each alive patch without a free use and with a consistent side, by lowest root. Free uses are
    /// counted with [`Sides::Outward`] alone.
    pub(crate) fn closed(&mut self) -> Vec<Vec<FaceId>> {
        let faces = (0..self.kernel.face_count() as u32).map(FaceId);
        let closed = faces.filter(|&f| {
            let patch = self.patch[f];
            let is_root = self.is_alive[f] && self.sets.find(f).0 == f;
            is_root
                && patch.free_uses == 0
                && !patch.is_twisted
                && !patch.is_cut
                && self.kernel.is_proper_face(f)
        });
        closed.map(|root| ring(&self.next_member, root)).collect()
    }

    /// The faces of each alive patch that has a consistent side but no outer one, and why, by lowest root. Asked only with
    /// [`Sides::Outward`].
    pub(crate) fn unjudged(&mut self) -> Vec<(Vec<FaceId>, Unjudged)> {
        let mut found = Vec::new();
        for face in (0..self.kernel.face_count() as u32).map(FaceId) {
            let patch = self.patch[face];
            let is_root = self.is_alive[face] && self.sets.find(face).0 == face;
            if !is_root || patch.is_twisted || patch.is_cut || !self.kernel.is_proper_face(face) {
                continue;
            }
            if patch.free_uses > 0 {
                found.push((ring(&self.next_member, face), Unjudged::Open));
            } else if self.volume_of(face).sign() == 0 {
                found.push((ring(&self.next_member, face), Unjudged::NoVolume));
            }
        }
        found
    }

    /// The volume that the patch of a root encloses.
    fn volume_of(&self, root: FaceId) -> SignedVolume {
        let mut volume = SignedVolume::default();
        for face in ring(&self.next_member, root) {
            volume.add_face(self.mesh, self.kernel.face_corners(face), self.is_flipped[face]);
        }
        volume
    }

    /// Turns all faces of a patch.
    pub(crate) fn turn(&mut self, faces: &[FaceId]) {
        faces.iter().for_each(|&face| self.is_flipped[face] ^= true);
    }

    /// The lowest face of each alive patch that has no consistent side, or that was cut to have one, ascending.
    pub(crate) fn non_orientable(&mut self) -> Vec<FaceId> {
        let roots = (0..self.kernel.face_count() as u32).map(FaceId).filter(|&f| self.is_alive[f]);
        let mut found: Vec<FaceId> = roots
            .filter(|&f| self.sets.find(f).0 == f && (self.patch[f].is_twisted || self.patch[f].is_cut))
            .map(|f| self.patch[f].lowest)
            .collect();
        found.sort_unstable();
        found
    }
}

/// The members of a ring, beginning with the given one.
fn ring(next: &Column<FaceId, FaceId>, first: FaceId) -> Vec<FaceId> {
    let mut members = vec![first];
    let mut at = next[first];
    while at != first {
        members.push(at);
        at = next[at];
    }
    members
}

/// How often a value stands in a sorted list.
fn run_length(sorted: &[FaceId], value: FaceId) -> usize {
    sorted.partition_point(|&v| v <= value) - sorted.partition_point(|&v| v < value)
}

/// Makes one ring of two.
fn swap(next: &mut Column<FaceId, FaceId>, one: FaceId, other: FaceId) {
    let after = next[one];
    next[one] = next[other];
    next[other] = after;
}
