//! A face with fewer than three different vertices.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "degenerate-face",
    title: "degenerate faces",
    severity: Severity::Defect,
    explanation: "Fewer than three different vertices are left when consecutive repeats are dropped, so the face \
        bounds nothing. It takes no part in the complex that is analysed. `clean` removes it and names it.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} has fewer than three different vertices",
};

impl Defect {
    /// A face with fewer than three different vertices.
    pub fn degenerate_face(face: FaceId) -> Self {
        Defect::new(DefectKind::DegenerateFace, Element::Face(face))
    }
}
