//! A face inside of what closed components enclose.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "internal-face",
    title: "internal faces",
    severity: Severity::Note,
    explanation: "Both sides of the face lie inside of what closed components enclose, so nothing of it is seen from outside. \
        Solids that were put together without being united have such faces.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} is inside on both sides",
};

impl Defect {
    /// A face inside of what closed components enclose.
    pub fn internal_face(face: FaceId) -> Self {
        Defect::new(DefectKind::InternalFace, Element::Face(face))
    }
}
