//! Two faces with the same corners by position.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "coincident-faces",
    title: "faces at the place of another",
    severity: Severity::Note,
    explanation: "The corners of the face are at the places of those of another face, in the same cycle, either way \
        round. It may be a double wall that somebody meant. Where the faces have the same vertices, they are \
        `duplicate-face` or `opposite-face`, and `clean` decides.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} lies on {beside}",
};

impl Defect {
    /// Two faces with the same corners by position.
    pub fn coincident_faces(face: FaceId, other: FaceId) -> Self {
        Defect::new(DefectKind::CoincidentFaces, Element::Face(face)).beside(Element::Face(other))
    }
}
