//! A face that comes back to a vertex round a hole, so that splitting it there would fill the hole.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{FaceId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "face-with-hole",
    title: "faces with holes",
    severity: Severity::Defect,
    explanation: "The face comes back to a vertex round a hole: a part of it turns against the whole, as where a \
        bridge leads from the rim to a hole and back. Splitting it at the vertex would fill the hole, so \
        `clean` cuts it along diagonals between its own corners.",
    found: Found::ByPass,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} comes back to {vertex} round a hole",
};

impl Defect {
    /// A face that comes back to a vertex round a hole, so that splitting it there would fill the hole.
    pub fn face_with_hole(face: FaceId, vertex: VertexId) -> Self {
        Defect::new(DefectKind::FaceWithHole, Element::Corner { face, vertex })
    }
}
