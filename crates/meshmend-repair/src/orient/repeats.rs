//! Which faces have the same cycle of vertices, and which patches own each directed cycle.
//!
//! Faces that have a cycle in common but differ in a material or the like own it each for themselves.

use std::collections::BTreeMap;

use meshmend_core::{Column, Connectivity, FaceId, PolygonMesh};
use meshmend_topology::{AlikeFace, alike_faces};

use crate::Context;
use crate::copies::{Copies, looks};
use crate::telling::{Looks, Telling};

const ALONE: u32 = u32::MAX;

/// Groups of faces with the same cycle up to direction; most faces are in none.
pub(crate) struct Cycles {
    group: Column<FaceId, u32>,
    runs_backward: Column<FaceId, bool>,
    members: Vec<Vec<FaceId>>,
    /// For each face the number of those in its group that it does not differ from, if any.
    class: Column<FaceId, u32>,
    class_count: u32,
    copies: Option<Copies>,
}

impl Cycles {
    /// The groups of two faces and more.
    ///
    /// *Cost*: that of [`alike_faces`], and 5 bytes a face; 9 where there are any.
    pub(crate) fn of<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, context: &Context<'_>) -> Self {
        let mut cycles = Cycles {
            group: Column::filled(ALONE, kernel.face_count()),
            runs_backward: Column::filled(false, kernel.face_count()),
            members: Vec::new(),
            class: Column::default(),
            class_count: 0,
            copies: None,
        };
        let alike = alike_faces(kernel);
        if alike.is_empty() {
            return cycles;
        }
        for (group, alike) in (0..).zip(&alike) {
            for &AlikeFace { face, is_reversed } in alike {
                cycles.group[face] = group;
                cycles.runs_backward[face] = is_reversed;
            }
            cycles.members.push(alike.iter().map(|alike| alike.face).collect());
        }
        match Telling::of(mesh, context.telling) {
            Some(telling) => {
                cycles.copies = Copies::among(kernel, mesh, &alike, &telling);
                cycles.tell_apart(kernel, mesh, &telling);
            }
            None => (cycles.class, cycles.class_count) = (cycles.group.clone(), alike.len() as u32),
        }
        cycles
    }

    /// Parts the groups into classes of faces that don't differ.
    fn tell_apart<K: Connectivity>(&mut self, kernel: &K, mesh: &PolygonMesh, telling: &Telling<'_>) {
        self.class = Column::filled(ALONE, kernel.face_count());
        for members in &self.members {
            let looks: Vec<Looks> = members.iter().map(|&face| looks(kernel, mesh, face)).collect();
            let first_alike = telling.first_alike(&looks);
            for (place, &first) in first_alike.iter().enumerate().filter(|(place, first)| place != *first) {
                if self.class[members[first]] == ALONE {
                    self.class[members[first]] = self.class_count;
                    self.class_count += 1;
                }
                self.class[members[place]] = self.class[members[first]];
            }
        }
    }

    /// The faces that run round the same vertices in the same direction as others and differ from them.
    pub(crate) fn copies(&self) -> Option<&Copies> {
        self.copies.as_ref()
    }

    /// Whether two faces of one group don't differ.
    pub(crate) fn are_alike(&self, one: FaceId, other: FaceId) -> bool {
        self.class[one] != ALONE && self.class[one] == self.class[other]
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// The groups, each by ascending face.
    pub(crate) fn groups(&self) -> &[Vec<FaceId>] {
        &self.members
    }

    /// The group of a face, if any other face has its cycle.
    pub(crate) fn group_of(&self, face: FaceId) -> Option<usize> {
        let group = self.group[face];
        (group != ALONE).then_some(group as usize)
    }

    /// Whether a face runs its group's cycle backward.
    pub(crate) fn runs_backward(&self, face: FaceId, is_flipped: bool) -> bool {
        self.runs_backward[face] ^ is_flipped
    }

    /// The directed cycle of a face, as a number that it shares with faces alone from which it does not differ; nothing
    /// where there are none, whatever their direction.
    pub(crate) fn slot(&self, face: FaceId, is_flipped: bool) -> Option<u32> {
        let class = self.class[face];
        (class != ALONE).then(|| 2 * class + u32::from(self.runs_backward(face, is_flipped)))
    }

    fn slot_count(&self) -> usize {
        2 * self.class_count as usize
    }
}

/// How many faces of each patch run each directed cycle, and how many faces of a patch no other patch doubles.
///
/// A patch goes by its *label*: one of its faces, which it keeps while smaller patches are merged into it.
pub(crate) struct Owners {
    count: BTreeMap<(u32, FaceId), u32>,
    /// For each directed cycle how many patches own it, and their labels exclusive-ored: the owner, if only one.
    owners: Vec<(u32, u32)>,
    /// For each label the faces whose directed cycle no other patch owns.
    blocked: Column<FaceId, u32>,
    /// Labels that have become free of blocked faces since they were last asked for.
    unblocked: Vec<FaceId>,
}

impl Owners {
    pub(crate) fn new(cycles: &Cycles, face_count: usize) -> Self {
        Owners {
            count: BTreeMap::new(),
            owners: vec![(0, 0); cycles.slot_count()],
            blocked: Column::filled(0, face_count),
            unblocked: Vec::new(),
        }
    }

    /// Asks about a patch again when labels are next taken.
    pub(crate) fn ask_again(&mut self, label: FaceId) {
        self.unblocked.push(label);
    }

    /// A face with this directed cycle joins a patch; a face without a group blocks its patch for good.
    pub(crate) fn enter(&mut self, slot: Option<u32>, label: FaceId) {
        let Some(slot) = slot else {
            self.blocked[label] += 1;
            return;
        };
        let count = self.count.entry((slot, label)).or_insert(0);
        *count += 1;
        let (owners, mixed) = &mut self.owners[slot as usize];
        if *count == 1 {
            *owners += 1;
            *mixed ^= label.0;
            if *owners == 2 {
                self.unblock(slot, FaceId(self.owners[slot as usize].1 ^ label.0));
                return;
            }
        }
        if self.owners[slot as usize].0 == 1 {
            self.blocked[label] += 1;
        }
    }

    /// A face with this directed cycle leaves a patch.
    pub(crate) fn leave(&mut self, slot: Option<u32>, label: FaceId) {
        let Some(slot) = slot else {
            self.lower(label, 1);
            return;
        };
        if self.owners[slot as usize].0 == 1 {
            self.lower(label, 1);
        }
        let Some(count) = self.count.get_mut(&(slot, label)) else { return };
        *count -= 1;
        if *count > 0 {
            return;
        }
        self.count.remove(&(slot, label));
        let (owners, mixed) = &mut self.owners[slot as usize];
        *owners -= 1;
        *mixed ^= label.0;
        if *owners == 1 {
            let last = FaceId(*mixed);
            self.blocked[last] += self.count.get(&(slot, last)).copied().unwrap_or(0);
        }
    }

    /// Whether each face of a patch is doubled, the same way, in another patch.
    pub(crate) fn is_duplicate(&self, label: FaceId) -> bool {
        self.blocked[label] == 0
    }

    /// The labels that have become free of blocked faces since the last call.
    pub(crate) fn take_unblocked(&mut self) -> Vec<FaceId> {
        std::mem::take(&mut self.unblocked)
    }

    /// The sole owner of a cycle is no longer alone.
    fn unblock(&mut self, slot: u32, label: FaceId) {
        let faces = self.count.get(&(slot, label)).copied().unwrap_or(0);
        self.lower(label, faces);
    }

    fn lower(&mut self, label: FaceId, faces: u32) {
        self.blocked[label] -= faces;
        if self.blocked[label] == 0 && faces > 0 {
            self.unblocked.push(label);
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
