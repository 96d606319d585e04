//! Which faces belong to which patch, and what is known of each patch.

use meshmend_core::{Column, FaceId, Joined, SidedClasses};

/// Whether the faces of a patch have a consistent orientation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Consistency {
    /// They have one.
    Consistent,
    /// They have one because sides that clash were left unmatched: those are the seam.
    Cut,
    /// They have none, and none of them is flipped from then on.
    Twisted,
}

/// What is known of a patch.
#[derive(Clone, Copy)]
pub(super) struct Patch {
    /// How many faces it has.
    pub(super) size: u32,
    pub(super) lowest: FaceId,
    /// The face by which it is named where it owns cycles.
    pub(super) label: FaceId,
    /// How many sides of its faces are not matched. It is counted only if closed patches are turned outward.
    pub(super) free_sides: u32,
    pub(super) consistency: Consistency,
}

/// A patch that is merged with others into one.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    /// One of its faces.
    pub(super) root: FaceId,
    /// Whether it lies as the whole does when the root of the whole is flipped. If not, it lies as the whole does when the
    /// root is as stored.
    pub(super) is_reversed: bool,
}

/// The patches as disjoint sets of faces, with what is known of each at its root.
///
/// A merge has two steps: patches are joined, and then become the pieces of one patch, which is closed when it is known
/// what became of them. *Cost*: 37 bytes a face; a join takes nearly constant time.
pub(super) struct PatchTable {
    classes: SidedClasses<FaceId>,
    /// The faces of each patch, or of each piece of a patch that is not closed.
    faces: Rings,
    /// The roots of the pieces of each patch; a closed patch has one.
    pieces: Rings,
    /// Only what stands at roots counts.
    known: Column<FaceId, Patch>,
}

impl PatchTable {
    /// Each face a patch of its own.
    pub(super) fn new(face_count: usize, free_sides: impl Fn(FaceId) -> u32) -> Self {
        let alone = |face| Patch {
            size: 1,
            lowest: face,
            label: face,
            free_sides: free_sides(face),
            consistency: Consistency::Consistent,
        };
        PatchTable {
            classes: SidedClasses::new(face_count),
            faces: Rings::new(face_count),
            pieces: Rings::new(face_count),
            known: (0..face_count as u32).map(|face| alone(FaceId(face))).collect(),
        }
    }

    /// Joins the patches of two faces. If `is_turned`, the faces lie against each other as stored.
    pub(super) fn join(&mut self, one: FaceId, other: FaceId, is_turned: bool) -> Joined<FaceId> {
        let joined = self.classes.join(one, other, is_turned);
        if let Joined::Merged { root, child } = joined {
            self.pieces.join(root, child);
        }
        joined
    }

    /// The root of the patch of a face.
    pub(super) fn root(&mut self, face: FaceId) -> FaceId {
        self.classes.find(face).0
    }

    pub(super) fn is_root(&mut self, face: FaceId) -> bool {
        self.root(face) == face
    }

    /// What is known of the patch of a root.
    pub(super) fn patch(&self, root: FaceId) -> &Patch {
        &self.known[root]
    }

    /// The faces of a patch or a piece, beginning with the given one.
    pub(super) fn faces(&self, first: FaceId) -> impl Iterator<Item = FaceId> + '_ {
        self.faces.from(first)
    }

    /// The pieces of the patch of a root, where `is_flipped` tells which faces are flipped now.
    pub(super) fn pieces(&mut self, root: FaceId, is_flipped: impl Fn(FaceId) -> bool) -> Vec<Piece> {
        let classes = &mut self.classes;
        let piece = |piece| Piece { root: piece, is_reversed: classes.find(piece).1 ^ is_flipped(piece) };
        self.pieces.from(root).map(piece).collect()
    }

    /// Makes one patch of pieces.
    pub(super) fn close(&mut self, root: FaceId, pieces: &[Piece], patch: Patch) {
        for piece in pieces {
            self.pieces.part(piece.root);
            if piece.root != root {
                self.faces.join(root, piece.root);
            }
        }
        self.known[root] = patch;
    }
}

/// Disjoint rings of faces.
struct Rings {
    next: Column<FaceId, FaceId>,
}

impl Rings {
    /// Each face in a ring of its own.
    fn new(face_count: usize) -> Self {
        Rings { next: (0..face_count as u32).map(FaceId).collect() }
    }

    /// Makes one ring of two.
    fn join(&mut self, one: FaceId, other: FaceId) {
        let after = self.next[one];
        self.next[one] = self.next[other];
        self.next[other] = after;
    }

    /// Gives a face a ring of its own. The others of its ring must follow.
    fn part(&mut self, face: FaceId) {
        self.next[face] = face;
    }

    /// The faces of a ring, beginning with the given one.
    fn from(&self, first: FaceId) -> impl Iterator<Item = FaceId> + '_ {
        let after = move |&face: &FaceId| Some(self.next[face]).filter(|&next| next != first);
        std::iter::successors(Some(first), after)
    }
}
