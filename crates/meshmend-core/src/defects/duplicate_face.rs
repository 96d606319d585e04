//! A face whose directed cycle of vertices an earlier face has too.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "duplicate-face",
    title: "duplicate faces",
    severity: Severity::Defect,
    explanation: "An earlier face has the same directed cycle of vertices. Both count as faces, so every edge of \
        theirs tends to become non-manifold. `clean` drops repeats as stored; `orient` drops a patch each of \
        whose faces is doubled in another patch.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} is {beside} again",
};

impl Defect {
    /// A face whose directed cycle of vertices an earlier face has too.
    pub fn duplicate_face(face: FaceId, original: FaceId) -> Self {
        Defect::new(DefectKind::DuplicateFace, Element::Face(face)).beside(Element::Face(original))
    }
}
