//! Which faces have the same cycle of vertices as others, and in which direction each runs it.

use meshmend_core::{Column, Connectivity, FaceId, PolygonMesh};
use meshmend_topology::alike_faces;

use crate::Context;
use crate::copies::{Copies, looks};
use crate::telling::{Looks, Telling};

const ALONE: u32 = u32::MAX;

/// A cycle of vertices in one direction, as it is run by faces that don't differ from each other.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct DirectedCycle(u32);

impl DirectedCycle {
    pub(super) fn index(self) -> usize {
        self.0 as usize
    }

    fn class(self) -> usize {
        self.index() / 2
    }

    fn runs_backward(self) -> bool {
        self.0 % 2 == 1
    }

    fn turned(self, is_turned: bool) -> Self {
        DirectedCycle(self.0 ^ u32::from(is_turned))
    }
}

/// A face that has its cycle in common with others.
#[derive(Clone, Copy)]
struct Repeat {
    group: u32,
    /// As the face runs it when it is not flipped.
    cycle: DirectedCycle,
}

/// The groups of faces that have the same cycle, in either direction. Most faces are in none.
///
/// A group falls into *classes*: faces of one class don't differ from each other. Those that differ, in a material or
/// the like, each have their cycle for themselves.
pub(super) struct Repeats {
    /// Empty if there are no groups.
    of_face: Column<FaceId, Repeat>,
    groups: Vec<Vec<FaceId>>,
    /// For each class how many faces it has.
    class_sizes: Vec<u32>,
    copies: Option<Copies>,
}

impl Repeats {
    /// The groups of two faces and more.
    ///
    /// *Cost*: that of [`alike_faces`], and 8 bytes a face where there are any.
    pub(super) fn of<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, context: &Context<'_>) -> Self {
        let alike = alike_faces(kernel);
        let mut repeats =
            Repeats { of_face: Column::default(), groups: Vec::new(), class_sizes: Vec::new(), copies: None };
        if alike.is_empty() {
            return repeats;
        }
        let telling = Telling::of(mesh, context.telling);
        repeats.copies = telling.as_ref().and_then(|telling| Copies::among(kernel, mesh, &alike, telling));
        let alone = Repeat { group: ALONE, cycle: DirectedCycle(ALONE) };
        repeats.of_face = Column::filled(alone, kernel.face_count());
        for (group, alike) in (0..).zip(&alike) {
            let faces: Vec<FaceId> = alike.iter().map(|alike| alike.face).collect();
            let classes = repeats.classes_of(kernel, mesh, telling.as_ref(), &faces);
            for (alike, class) in alike.iter().zip(classes) {
                let cycle = DirectedCycle(2 * class).turned(alike.is_reversed);
                repeats.of_face[alike.face] = Repeat { group, cycle };
            }
            repeats.groups.push(faces);
        }
        repeats
    }

    /// The class of each face of a group.
    fn classes_of<K: Connectivity>(
        &mut self,
        kernel: &K,
        mesh: &PolygonMesh,
        telling: Option<&Telling<'_>>,
        faces: &[FaceId],
    ) -> Vec<u32> {
        let first_alike = match telling {
            Some(telling) => {
                let looks: Vec<Looks> = faces.iter().map(|&face| looks(kernel, mesh, face)).collect();
                telling.first_alike(&looks)
            }
            None => vec![0; faces.len()],
        };
        let mut classes: Vec<u32> = Vec::with_capacity(faces.len());
        for (place, &first) in first_alike.iter().enumerate() {
            if first == place {
                classes.push(self.class_sizes.len() as u32);
                self.class_sizes.push(1);
            } else {
                classes.push(classes[first]);
                self.class_sizes[classes[first] as usize] += 1;
            }
        }
        classes
    }

    /// The faces that run round the same vertices in the same direction as others and differ from them.
    pub(super) fn copies(&self) -> Option<&Copies> {
        self.copies.as_ref()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.groups.is_empty()
    }

    /// The groups, each by ascending face.
    pub(super) fn groups(&self) -> &[Vec<FaceId>] {
        &self.groups
    }

    /// The faces that have the cycle of a face in one direction or the other, if there are more of them.
    pub(super) fn group_of(&self, face: FaceId) -> &[FaceId] {
        let group = if self.is_empty() { ALONE } else { self.of_face[face].group };
        self.groups.get(group as usize).map_or(&[], Vec::as_slice)
    }

    /// Whether two faces of one group don't differ.
    pub(super) fn are_alike(&self, one: FaceId, other: FaceId) -> bool {
        self.of_face[one].cycle.class() == self.of_face[other].cycle.class()
    }

    /// Whether a face of a group runs its cycle backward.
    pub(super) fn runs_backward(&self, face: FaceId, is_flipped: bool) -> bool {
        self.of_face[face].cycle.turned(is_flipped).runs_backward()
    }

    /// The directed cycle of a face. Returns `None` if no other face has the cycle, in either direction, and doesn't
    /// differ.
    pub(super) fn cycle(&self, face: FaceId, is_flipped: bool) -> Option<DirectedCycle> {
        let Repeat { group, cycle } = self.of_face[face];
        (group != ALONE && self.class_sizes[cycle.class()] > 1).then(|| cycle.turned(is_flipped))
    }

    /// How many directed cycles there are.
    pub(super) fn cycle_count(&self) -> usize {
        2 * self.class_sizes.len()
    }
}
