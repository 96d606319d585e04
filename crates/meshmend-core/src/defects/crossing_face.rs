//! A face that has a hole by the way its parts turn, but crosses itself.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{FaceId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "crossing-face",
    title: "faces that cross themselves",
    severity: Severity::Defect,
    explanation: "The face comes back to a vertex, and a part of it turns against the whole as round a hole, but it \
        crosses itself so that no diagonals cut it into simple faces. `clean` splits it at the repeated \
        vertex.",
    found: Found::ByPass,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} comes back to {vertex} and crosses itself",
};

impl Defect {
    /// A face that has a hole by the way its parts turn, but crosses itself.
    pub fn crossing_face(face: FaceId, vertex: VertexId) -> Self {
        Defect::new(DefectKind::CrossingFace, Element::Corner { face, vertex })
    }
}
