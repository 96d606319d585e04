//! Why stored elements became what they did.

use meshmend_core::{CornerId, DefectKind, Id, PolygonMesh};
use meshmend_repair::RemovedFace;
use serde::{Serialize, Serializer};

use super::{ElementMap, ElementMaps};

macro_rules! causes {
    ($($(#[$doc:meta])* $name:ident: $word:literal,)*) => {
        /// Why a stored element became what it did.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(u8)]
        #[non_exhaustive]
        pub enum Cause {
            $($(#[$doc])* $name,)*
        }

        /// The words of all causes, each at the place that stands for it.
        pub const CAUSES: &[&str] = &[$($word,)*];
    };
}

causes! {
    /// It is one element of the result.
    Kept: "kept",
    /// A vertex that was joined to another one.
    Welded: "welded",
    /// A vertex of which there are several.
    Split: "split",
    /// A face, or a corner of one, that was cut into several.
    Cut: "cut",
    /// It went with a degenerate face.
    Degenerate: "degenerate",
    /// It went with a face of which a position is not finite.
    NonFinite: "non-finite",
    /// It went with a face that repeats another one.
    RepeatedSame: "repeated-same",
    /// It went with a face that repeats another one the other way round.
    RepeatedOpposite: "repeated-opposite",
    /// A corner that repeated another one of its face.
    RepeatedCorner: "repeated-corner",
    /// A vertex that nothing used.
    Compacted: "compacted",
    /// It went with a face that was removed for another reason, which the report names.
    Removed: "removed",
}

impl Cause {
    /// Why a face went.
    fn of_removed(reason: DefectKind) -> Self {
        match reason {
            DefectKind::DegenerateFace => Cause::Degenerate,
            DefectKind::NonFiniteFace => Cause::NonFinite,
            DefectKind::DuplicateFace => Cause::RepeatedSame,
            DefectKind::OppositeFace => Cause::RepeatedOpposite,
            _ => Cause::Removed,
        }
    }

    /// The word for it.
    pub fn word(self) -> &'static str {
        CAUSES[self as usize]
    }
}

impl Serialize for Cause {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u8(*self as u8)
    }
}

impl ElementMaps {
    /// Finds why each stored element became what it did.
    pub(super) fn find_causes(&mut self, stored: &PolygonMesh, removed: &[RemovedFace]) {
        let reason = |face: usize| {
            let place = removed.binary_search_by_key(&face, |removed| removed.face.index()).ok();
            place.map(|place| Cause::of_removed(removed[place].reason))
        };
        self.faces.causes = causes(&self.faces, Cause::Cut, |face| reason(face).unwrap_or(Cause::Removed));
        let table = stored.faces();
        let of_face = |corner: usize| table.corner_face(CornerId::new(corner)).index();
        let face_causes = &self.faces.causes;
        let is_gone = |face: usize| self.faces.all_new_of(face).is_empty();
        self.corners.causes = causes(&self.corners, Cause::Cut, |corner| {
            let face = of_face(corner);
            if is_gone(face) { face_causes[face] } else { Cause::RepeatedCorner }
        });
        // What the lowest corner of a vertex of which nothing is left went with.
        let mut lost: Vec<Option<Cause>> = vec![None; stored.counts().vertices];
        for (corner, vertex) in table.corner_vertices().iter().enumerate() {
            lost[vertex.index()].get_or_insert(self.corners.causes[corner]);
        }
        let vertices = &self.vertices;
        self.vertices.causes = causes(vertices, Cause::Split, |vertex| match lost[vertex] {
            None | Some(Cause::Kept | Cause::Cut) => Cause::Compacted,
            Some(cause) => cause,
        });
        let is_another = |old: usize| match self.vertices.all_new_of(old) {
            [new] => self.vertices.new_to_old[*new as usize] != Some(old as u32),
            _ => false,
        };
        let welded: Vec<usize> = (0..stored.counts().vertices).filter(|&old| is_another(old)).collect();
        welded.into_iter().for_each(|old| self.vertices.causes[old] = Cause::Welded);
    }
}

/// The cause of each stored element: by how many new ones it became.
fn causes(map: &ElementMap, several: Cause, none: impl Fn(usize) -> Cause) -> Vec<Cause> {
    let count = map.starts.len().saturating_sub(1);
    let cause = |old: usize| match map.all_new_of(old) {
        [] => none(old),
        [_] => Cause::Kept,
        _ => several,
    };
    (0..count).map(cause).collect()
}
