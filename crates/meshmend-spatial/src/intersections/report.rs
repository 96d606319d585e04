//! What a search for intersections gives, and what it may cost.

use meshmend_core::{Column, FaceId};
use meshmend_geometry::vector::Point;

use crate::meeting::Contact;

/// How far a search for intersections goes, and what of it is listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IntersectionOptions {
    /// How many pairs of triangles are tested.
    pub budget: Budget,
    /// How many pairs are listed of those that cross or overlap, of those that coincide, and of those that touch.
    pub limit: usize,
}

/// After how many tested pairs of triangles a search stops, at the end of a run of 4096 faces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Budget {
    /// 64 a face, and ten million.
    #[default]
    Usual,
    /// So many.
    Tests(u64),
}

/// All within the usual budget, and every pair listed.
impl Default for IntersectionOptions {
    fn default() -> Self {
        IntersectionOptions { budget: Budget::Usual, limit: usize::MAX }
    }
}

/// The faces of a mesh that intersect.
#[derive(Clone, Debug, PartialEq)]
pub struct Intersections {
    /// The pairs that intersect, in order of their faces, up to the limit for each class.
    pub pairs: Vec<FacePair>,
    /// For each face the greatest contact of all its pairs, listed or not.
    pub contacts: Column<FaceId, Option<Contact>>,
    /// The faces of which two parts of the surface cross, ascending.
    pub self_crossing: Vec<FaceId>,
    /// The figures of all pairs; `None` if the search stopped before the last face.
    pub figures: Option<Figures>,
    /// The last face that was compared with all higher ones, if the search stopped before the last face. The pairs found are then
    /// those of the faces up to it.
    pub complete_to: Option<FaceId>,
    /// The faces all of whose corners lie on one line, ascending. They take no part.
    pub zero_area: Vec<FaceId>,
    /// The faces with fewer than three corners, one that is not finite, or two at one position, ascending. They take no part.
    pub unfit: Vec<FaceId>,
}

/// Two faces that intersect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacePair {
    /// The lower face and the higher one.
    pub faces: [FaceId; 2],
    /// What of them meets.
    pub contact: Contact,
    /// Whether they lie in one plane there.
    pub is_coplanar: bool,
    /// A point of both within rounding, if their insides have one in common.
    pub point: Option<Point>,
}

/// How many pairs of each class are listed: those that cross or overlap, that coincide, and that touch.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Listed([usize; 3]);

impl Listed {
    /// Counts a pair if there is room for it.
    pub(super) fn takes(&mut self, contact: Contact, limit: usize) -> bool {
        let class = match contact {
            Contact::FaceFace => 0,
            Contact::Coincident => 1,
            _ => 2,
        };
        let has_room = self.0[class] < limit;
        self.0[class] += usize::from(has_room);
        has_room
    }
}

/// How many pairs of which kind there are.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Figures {
    /// The pairs of each contact, in the order of [`Contact::ALL`].
    counts: [u64; 6],
    /// The pairs whose insides pass through one another.
    pub crossing: u64,
    /// The pairs whose insides overlap in one plane.
    pub overlapping: u64,
    /// The faces in crossing or overlapping pairs.
    pub crossing_faces: usize,
    /// The classes of faces that crossing or overlapping pairs join.
    pub clusters: usize,
}

impl Figures {
    /// How many pairs have a contact.
    pub fn count(&self, contact: Contact) -> u64 {
        self.counts[contact as usize]
    }

    /// Counts a pair.
    pub(super) fn add(&mut self, contact: Contact, is_coplanar: bool) {
        self.counts[contact as usize] += 1;
        if contact == Contact::FaceFace {
            *(if is_coplanar { &mut self.overlapping } else { &mut self.crossing }) += 1;
        }
    }

    /// Adds the pairs of other faces.
    pub(super) fn add_all(&mut self, other: &Figures) {
        for (count, more) in self.counts.iter_mut().zip(other.counts) {
            *count += more;
        }
        self.crossing += other.crossing;
        self.overlapping += other.overlapping;
    }
}

impl Budget {
    /// The number of tests for a mesh of so many faces.
    pub(super) fn tests(self, faces: usize) -> u64 {
        match self {
            Budget::Usual => 64 * faces as u64 + 10_000_000,
            Budget::Tests(count) => count,
        }
    }
}
