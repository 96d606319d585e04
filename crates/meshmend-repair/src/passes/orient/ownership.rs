//! Which patches own each directed cycle: that tells which patches are duplicates.
//!
//! A patch is a duplicate when each of its faces has the same directed cycle of vertices as a face of another patch. So
//! a face *blocks* its patch if no other patch owns its cycle, and a patch that no face blocks is a duplicate. A patch
//! goes by its *label*: one of its faces, which it keeps while smaller patches are merged into it.

use std::collections::BTreeMap;

use meshmend_core::{Column, FaceId};

use super::repeats::{DirectedCycle, Repeats};

/// The patches that own a directed cycle.
#[derive(Clone, Copy, Default)]
struct Owners {
    count: u32,
    /// Their labels, exclusive-ored: the owner, if there is only one.
    mixed: u32,
}

impl Owners {
    fn are_one(self) -> bool {
        self.count == 1
    }
}

/// How many faces of each patch run each directed cycle, and how many faces block each patch.
pub(super) struct Ownership<'a> {
    repeats: &'a Repeats,
    faces_of: BTreeMap<(DirectedCycle, FaceId), u32>,
    /// For each directed cycle.
    owners: Vec<Owners>,
    /// For each label how many faces block its patch.
    blocking: Column<FaceId, u32>,
    /// The labels of patches that may have become duplicates since they were last asked for.
    to_ask: Vec<FaceId>,
}

impl<'a> Ownership<'a> {
    /// Without any patch.
    pub(super) fn new(repeats: &'a Repeats, face_count: usize) -> Self {
        Ownership {
            repeats,
            faces_of: BTreeMap::new(),
            owners: vec![Owners::default(); repeats.cycle_count()],
            blocking: Column::filled(0, face_count),
            to_ask: Vec::new(),
        }
    }

    /// A face joins a patch. One whose cycle no other face has blocks it for good.
    pub(super) fn enter(&mut self, face: FaceId, is_flipped: bool, label: FaceId) {
        let Some(cycle) = self.repeats.cycle(face, is_flipped) else {
            self.blocking[label] += 1;
            return;
        };
        let faces = self.faces_of.entry((cycle, label)).or_insert(0);
        *faces += 1;
        let is_first = *faces == 1;
        let owners = &mut self.owners[cycle.index()];
        if is_first {
            *owners = Owners { count: owners.count + 1, mixed: owners.mixed ^ label.0 };
        }
        if owners.are_one() {
            self.blocking[label] += 1;
        } else if is_first && owners.count == 2 {
            let other = FaceId(owners.mixed ^ label.0);
            let faces = self.faces_of.get(&(cycle, other)).copied().unwrap_or(0);
            self.unblock(other, faces);
        }
    }

    /// A face leaves a patch.
    pub(super) fn leave(&mut self, face: FaceId, is_flipped: bool, label: FaceId) {
        let Some(cycle) = self.repeats.cycle(face, is_flipped) else {
            self.unblock(label, 1);
            return;
        };
        if self.owners[cycle.index()].are_one() {
            self.unblock(label, 1);
        }
        let Some(faces) = self.faces_of.get_mut(&(cycle, label)) else { return };
        *faces -= 1;
        if *faces > 0 {
            return;
        }
        self.faces_of.remove(&(cycle, label));
        let owners = &mut self.owners[cycle.index()];
        *owners = Owners { count: owners.count - 1, mixed: owners.mixed ^ label.0 };
        if owners.are_one() {
            let last = FaceId(owners.mixed);
            self.blocking[last] += self.faces_of.get(&(cycle, last)).copied().unwrap_or(0);
        }
    }

    /// Whether each face of a patch is doubled, the same way, in another patch.
    pub(super) fn is_duplicate(&self, label: FaceId) -> bool {
        self.blocking[label] == 0
    }

    /// Adds a patch to those that may have become duplicates.
    pub(super) fn ask_about(&mut self, label: FaceId) {
        self.to_ask.push(label);
    }

    /// The labels of patches that may have become duplicates since the last call.
    pub(super) fn take_to_ask(&mut self) -> Vec<FaceId> {
        std::mem::take(&mut self.to_ask)
    }

    fn unblock(&mut self, label: FaceId, faces: u32) {
        self.blocking[label] -= faces;
        if self.blocking[label] == 0 && faces > 0 {
            self.to_ask.push(label);
        }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::Soup;

    use crate::Pipeline;

    /// A fan more than once round its centre has two faces with the same cycle, and both are turned. Then each of its
    /// faces is in the closed patch as well.
    #[test]
    fn a_patch_that_runs_a_cycle_twice_is_a_duplicate_once_it_is_turned() {
        let mut soup = Soup::generic(5, [[0, 1, 2], [0, 2, 3], [0, 3, 1], [4, 2, 1], [4, 3, 2], [4, 1, 3]]);
        soup.positions.extend([0, 2, 3, 1, 1, 2].map(|v: usize| soup.positions[v]));
        let [centre, c, d, b, b_before, c_after] = [5, 6, 7, 8, 9, 10];
        let wound = [[centre, c, d], [centre, d, b], [centre, c, b_before], [centre, c_after, b]];
        soup.faces.extend(wound.map(Vec::from));
        let repaired = Pipeline::default().run(&soup.mesh()).unwrap();
        let removed: Vec<u32> = repaired.removed_faces.iter().map(|removed| removed.face.0).collect();
        assert_eq!(removed, [6, 7, 8, 9]);
    }
}
