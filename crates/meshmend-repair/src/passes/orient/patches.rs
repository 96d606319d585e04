//! The patches of the repair while duplicates go: faces joined across matched sides, and oriented alike.
//!
//! A patch is made of pieces that were consistent before they merged, so a merge flips whole pieces, never more than
//! half of the faces: each flip of a face at least doubles its patch, and all flips together are O(n log n).

use std::cmp::Reverse;

use meshmend_core::{Connectivity, FaceId, Joined, Unjudged};
use meshmend_geometry::SignedVolume;

use super::fates::Fates;
use super::live_matching::Pair;
use super::ownership::Ownership;
use super::patch_table::{Consistency, Patch, PatchTable, Piece};
use super::subject::Subject;
use crate::matching::run_the_same_way;

/// How the orientation of a patch is chosen.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Choice {
    /// As stored: no face is flipped.
    AsStored,
    /// The one that flips fewer faces; on a tie the one that keeps the lowest face.
    Majority,
    /// Outward for closed patches, else by majority.
    Outward,
}

/// What happens to matched sides that contradict the orientation of their patch.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Contradiction {
    /// The patch is twisted.
    Twists,
    /// The pair is not joined: it is part of a seam.
    Cuts,
}

/// How patches are oriented.
#[derive(Clone, Copy)]
pub(super) struct Policy {
    pub(super) choice: Choice,
    pub(super) contradiction: Contradiction,
}

/// What a matched pair did to a patch.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Event {
    Merged,
    /// The sides were sides of one patch already, and agree.
    Closed,
    Contradicted,
}

/// The patches of the faces that stay.
pub(super) struct Patches<'a, K> {
    subject: &'a Subject<'a, K>,
    policy: Policy,
    table: PatchTable,
    /// Kept only if some faces have the same cycle: else no patch is a duplicate.
    ownership: Option<Ownership<'a>>,
    fates: Fates,
}

impl<'a, K: Connectivity> Patches<'a, K> {
    /// Each face that stays a patch of its own.
    pub(super) fn new(subject: &'a Subject<'a, K>, policy: Policy, fates: Fates) -> Self {
        let Subject { kernel, repeats, .. } = subject;
        let count = kernel.face_count();
        let ownership = (!repeats.is_empty()).then(|| {
            let mut ownership = Ownership::new(repeats, count);
            for face in fates.staying() {
                ownership.enter(face, fates.is_flipped(face), face);
                ownership.ask_about(face);
            }
            ownership
        });
        let table = PatchTable::new(count, |face| kernel.face_corners(face).count() as u32);
        Patches { subject, policy, table, ownership, fates }
    }

    pub(super) fn fates(&self) -> &Fates {
        &self.fates
    }

    pub(super) fn into_fates(self) -> Fates {
        self.fates
    }

    /// Joins patches across newly matched sides, and orients what has come together.
    pub(super) fn join_across(&mut self, pairs: &[Pair]) {
        let kernel = self.subject.kernel;
        let mut events: Vec<(FaceId, Event)> = Vec::new();
        for &(one, other) in pairs {
            let (f, g) = (kernel.corner_face(one), kernel.corner_face(other));
            match self.table.join(f, g, run_the_same_way(kernel, one, other)) {
                Joined::Merged { root, .. } => events.push((root, Event::Merged)),
                // A side that is matched may close its patch.
                Joined::Agrees if self.policy.choice == Choice::Outward => events.push((f, Event::Closed)),
                Joined::Agrees => {}
                Joined::Contradicts { root } => events.push((root, Event::Contradicted)),
            }
        }
        events.iter_mut().for_each(|(face, _)| *face = self.table.root(*face));
        events.sort_unstable();
        for of_patch in events.chunk_by(|one, other| one.0 == other.0) {
            self.settle(of_patch[0].0, of_patch);
        }
    }

    /// Makes one patch of the pieces that were joined under a root, and orients it.
    fn settle(&mut self, root: FaceId, events: &[(FaceId, Event)]) {
        let fates = &self.fates;
        let pieces = self.table.pieces(root, |face| fates.is_flipped(face));
        let whole = self.whole(&pieces, events);
        self.relabel(&pieces, whole.label);
        if self.policy.choice != Choice::AsStored && whole.consistency != Consistency::Twisted {
            let is_reversed = self.is_to_be_reversed(&pieces, &whole);
            for piece in pieces.iter().filter(|piece| piece.is_reversed != is_reversed) {
                self.flip(piece.root, whole.label);
            }
        }
        self.table.close(root, &pieces, whole);
        if let Some(ownership) = &mut self.ownership
            && ownership.is_duplicate(whole.label)
        {
            ownership.ask_about(whole.label);
        }
    }

    /// What is known of the patch that pieces make up.
    fn whole(&self, pieces: &[Piece], events: &[(FaceId, Event)]) -> Patch {
        let mut whole = *self.table.patch(pieces[0].root);
        let mut largest = (whole.size, Reverse(whole.label));
        for piece in &pieces[1..] {
            let patch = self.table.patch(piece.root);
            largest = largest.max((patch.size, Reverse(patch.label)));
            whole.size += patch.size;
            whole.lowest = whole.lowest.min(patch.lowest);
            whole.free_sides += patch.free_sides;
            whole.consistency = whole.consistency.max(patch.consistency);
        }
        whole.label = largest.1.0;
        let contradicted = events.iter().filter(|(_, event)| *event == Event::Contradicted).count();
        let matched = 2 * (events.len() - contradicted) as u32;
        whole.free_sides = whole.free_sides.saturating_sub(matched);
        if contradicted > 0 {
            whole.consistency = whole.consistency.max(match self.policy.contradiction {
                Contradiction::Twists => Consistency::Twisted,
                Contradiction::Cuts => Consistency::Cut,
            });
        }
        whole
    }

    /// Whether a patch of pieces is to be reversed. If so, the pieces that are not are to be flipped, else those that are.
    fn is_to_be_reversed(&self, pieces: &[Piece], whole: &Patch) -> bool {
        let is_closed = whole.free_sides == 0 && whole.consistency == Consistency::Consistent;
        if self.policy.choice == Choice::Outward && is_closed {
            match self.volume(pieces).sign() {
                0 => {}
                sign => return sign < 0,
            }
        }
        self.majority(pieces, whole)
    }

    /// The volume that closed pieces enclose if none is reversed.
    fn volume(&self, pieces: &[Piece]) -> SignedVolume {
        let mut volume = SignedVolume::default();
        for piece in pieces {
            for face in self.table.faces(piece.root) {
                let is_flipped = self.fates.is_flipped(face) ^ piece.is_reversed;
                self.add_to(&mut volume, face, is_flipped);
            }
        }
        volume
    }

    fn add_to(&self, volume: &mut SignedVolume, face: FaceId, is_flipped: bool) {
        let Subject { kernel, mesh, .. } = self.subject;
        volume.add_face(mesh, kernel.face_corners(face), is_flipped);
    }

    /// Whether most faces are reversed, or on a tie the lowest one.
    fn majority(&self, pieces: &[Piece], whole: &Patch) -> bool {
        let reversed = || {
            let reversed = pieces.iter().filter(|piece| piece.is_reversed);
            reversed.map(|piece| self.table.patch(piece.root))
        };
        let count: u32 = reversed().map(|patch| patch.size).sum();
        match (2 * u64::from(count)).cmp(&u64::from(whole.size)) {
            std::cmp::Ordering::Less => false,
            std::cmp::Ordering::Greater => true,
            std::cmp::Ordering::Equal => reversed().any(|patch| patch.lowest == whole.lowest),
        }
    }

    /// Flips the faces of a piece.
    fn flip(&mut self, piece: FaceId, label: FaceId) {
        for face in self.table.faces(piece) {
            let is_flipped = self.fates.is_flipped(face);
            if let Some(ownership) = &mut self.ownership {
                ownership.leave(face, is_flipped, label);
                ownership.enter(face, !is_flipped, label);
            }
            self.fates.flip(face);
        }
    }

    /// Gives the faces of pieces with another label to the patch that they are now part of.
    fn relabel(&mut self, pieces: &[Piece], label: FaceId) {
        let Some(ownership) = &mut self.ownership else { return };
        for piece in pieces {
            let before = self.table.patch(piece.root).label;
            if before == label {
                continue;
            }
            for face in self.table.faces(piece.root) {
                let is_flipped = self.fates.is_flipped(face);
                ownership.leave(face, is_flipped, before);
                ownership.enter(face, is_flipped, label);
            }
        }
    }

    /// Drops patches each of whose faces is doubled, the same way, in another patch: the smallest first, of equal
    /// ones the one with the higher lowest face. Gives the faces that go.
    ///
    /// One round is enough until patches merge or are flipped: a patch that is not asked about again still has a face
    /// that no other patch doubles.
    pub(super) fn drop_duplicates(&mut self) -> Vec<FaceId> {
        let mut gone = Vec::new();
        let Some(ownership) = &mut self.ownership else { return gone };
        let mut candidates: Vec<(u32, Reverse<FaceId>, FaceId)> = Vec::new();
        for label in ownership.take_to_ask() {
            let root = self.table.root(label);
            let patch = self.table.patch(root);
            if patch.label == label && self.fates.stays(label) && ownership.is_duplicate(label) {
                candidates.push((patch.size, Reverse(patch.lowest), label));
            }
        }
        candidates.sort_unstable();
        candidates.dedup();
        for (_, _, label) in candidates {
            if !ownership.is_duplicate(label) {
                continue;
            }
            for face in self.table.faces(label) {
                self.fates.remove(face);
                ownership.leave(face, self.fates.is_flipped(face), label);
                gone.push(face);
            }
        }
        gone
    }

    /// The roots of the patches that are left, ascending.
    fn roots(&mut self) -> Vec<FaceId> {
        let Patches { table, fates, .. } = self;
        fates.staying().filter(|&face| table.is_root(face)).collect()
    }

    /// The patches that are left and have a consistent orientation, by root: each with its faces, and whether none of its
    /// sides is free. Asked only with [`Choice::Outward`].
    pub(super) fn oriented(&mut self) -> Vec<OrientedPatch> {
        let roots = self.roots();
        let proper = roots.into_iter().filter(|&root| self.subject.kernel.is_proper_face(root));
        let consistent = proper.filter(|&root| self.table.patch(root).consistency == Consistency::Consistent);
        let patch = |root| OrientedPatch {
            lowest: self.table.patch(root).lowest,
            faces: self.table.faces(root).collect(),
            is_closed: self.table.patch(root).free_sides == 0,
        };
        consistent.map(patch).collect()
    }

    /// Why a patch has no outer side, if it has none.
    pub(super) fn unjudged(&self, patch: &OrientedPatch) -> Option<Unjudged> {
        if !patch.is_closed {
            return Some(Unjudged::Open);
        }
        let mut volume = SignedVolume::default();
        for &face in &patch.faces {
            self.add_to(&mut volume, face, self.fates.is_flipped(face));
        }
        (volume.sign() == 0).then_some(Unjudged::NoVolume)
    }

    /// Flips all faces of a patch. From then on no duplicates are dropped.
    pub(super) fn turn(&mut self, faces: &[FaceId]) {
        faces.iter().for_each(|&face| self.fates.flip(face));
    }

    /// The lowest face of each patch that is left and has no consistent orientation, ascending.
    pub(super) fn non_orientable(&mut self) -> Vec<FaceId> {
        let roots = self.roots().into_iter();
        let patches = roots.map(|root| self.table.patch(root));
        let mut found: Vec<FaceId> = patches
            .filter(|patch| patch.consistency == Consistency::Twisted)
            .map(|patch| patch.lowest)
            .collect();
        found.sort_unstable();
        found
    }
}

/// A patch with a consistent orientation.
pub(super) struct OrientedPatch {
    pub(super) lowest: FaceId,
    /// Not in order.
    pub(super) faces: Vec<FaceId>,
    pub(super) is_closed: bool,
}
