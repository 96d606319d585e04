//! What becomes of each face: whether it stays, and whether it is flipped.

use meshmend_core::{Column, FaceId};

/// What becomes of one face.
#[derive(Clone, Copy)]
struct Fate {
    stays: bool,
    is_flipped: bool,
}

/// What becomes of each face. *Cost*: 2 bytes a face.
pub(crate) struct Fates {
    of_face: Column<FaceId, Fate>,
}

impl Fates {
    /// All faces stay as they are.
    pub(crate) fn unchanged(face_count: usize) -> Self {
        Fates { of_face: Column::filled(Fate { stays: true, is_flipped: false }, face_count) }
    }

    pub(crate) fn stays(&self, face: FaceId) -> bool {
        self.of_face[face].stays
    }

    pub(crate) fn is_flipped(&self, face: FaceId) -> bool {
        self.of_face[face].is_flipped
    }

    pub(crate) fn flip(&mut self, face: FaceId) {
        self.of_face[face].is_flipped ^= true;
    }

    pub(crate) fn remove(&mut self, face: FaceId) {
        self.of_face[face].stays = false;
    }

    pub(crate) fn all_stay(&self) -> bool {
        self.of_face.values().iter().all(|fate| fate.stays)
    }

    pub(crate) fn any_is_flipped(&self) -> bool {
        self.of_face.values().iter().any(|fate| fate.is_flipped)
    }

    /// The faces that stay, ascending.
    pub(crate) fn staying(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.of_face.iter().filter(|(_, fate)| fate.stays).map(|(face, _)| face)
    }

    /// The faces that go, ascending.
    pub(crate) fn going(&self) -> impl Iterator<Item = FaceId> + '_ {
        self.of_face.iter().filter(|(_, fate)| !fate.stays).map(|(face, _)| face)
    }

    /// The ids that faces have once those that go are gone. A face that goes has the id of one that stays.
    ///
    /// *Cost*: 4 bytes a face if some go, else none.
    pub(crate) fn new_ids(&self) -> NewIds {
        if self.all_stay() {
            return NewIds(None);
        }
        let mut next = 0;
        let id = |fate: &Fate| {
            next += u32::from(fate.stays);
            FaceId(next.max(1) - 1)
        };
        NewIds(Some(self.of_face.values().iter().map(id).collect()))
    }
}

/// The ids of faces in the mesh that is made, by those in the mesh as it was.
pub(crate) struct NewIds(Option<Column<FaceId, FaceId>>);

impl NewIds {
    pub(crate) fn of(&self, face: FaceId) -> FaceId {
        self.0.as_ref().map_or(face, |ids| ids[face])
    }
}
