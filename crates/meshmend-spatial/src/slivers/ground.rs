//! What steps are judged by: the faces as they are, and what may not change.

use std::cmp::Ordering;

use meshmend_core::{CornerId, FaceId, VertexId};
use meshmend_geometry::vector::Point;

use super::measure::{agreement, is_flat};
use super::record::SliverReason;
use super::stood_for::StoodFor;
use super::surface::Faces;
use crate::exact::Sign;
use crate::{compare_aspects, sliver_kind};

/// Which corners and faces of a mesh have the same attributes.
pub trait Attributes {
    /// Whether two corners at one vertex have the same.
    fn corners_agree(&self, one: CornerId, other: CornerId) -> bool;
    /// Whether two neighbouring faces have the same.
    fn faces_agree(&self, one: FaceId, other: FaceId) -> bool;
}

/// No attributes: all agree.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoAttributes;

impl Attributes for NoAttributes {
    fn corners_agree(&self, _: CornerId, _: CornerId) -> bool {
        true
    }
    fn faces_agree(&self, _: FaceId, _: FaceId) -> bool {
        true
    }
}

/// The faces as they are, and what may not change.
pub(super) struct Ground<'a> {
    pub(super) faces: Faces<'a>,
    pub(super) stood_for: StoodFor<'a>,
    pub(super) attributes: &'a dyn Attributes,
    pub(super) aspect: f64,
    pub(super) reach: f64,
}

impl Ground<'_> {
    /// Whether two faces have the same attributes at a vertex of both.
    pub(super) fn agree_at(&self, vertex: VertexId, faces: [FaceId; 2]) -> bool {
        let [one, other] = faces.map(|face| self.faces.corner(face, vertex).map(|c| self.faces.origin(c)));
        one.zip(other).is_some_and(|(one, other)| self.attributes.corners_agree(one, other))
    }

    /// Whether a triangle may become another one: it keeps its side, and becomes no sliver that is worse than it was.
    pub(super) fn may_become(&self, old: [Point; 3], new: [Point; 3]) -> Result<(), SliverReason> {
        if !is_flat(old) && agreement(old, new) != Sign::Positive {
            return Err(SliverReason::TurnsOver);
        }
        let is_sliver = |triangle| sliver_kind(triangle, self.aspect).is_some();
        let is_worse = || !is_sliver(old) || compare_aspects(new, old) == Ordering::Greater;
        if is_sliver(new) && is_worse() { Err(SliverReason::NoBetter) } else { Ok(()) }
    }
}
