//! A face all of whose corners lie on one line.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "zero-area-face",
    title: "faces without area",
    severity: Severity::Defect,
    explanation: "All corners of the face lie on one line, exactly. It has no normal, and crosses nothing. Faces that \
        have two corners at one vertex are `degenerate-face` as well.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} has no area",
};

impl Defect {
    /// A face all of whose corners lie on one line.
    pub fn zero_area_face(face: FaceId) -> Self {
        Defect::new(DefectKind::ZeroAreaFace, Element::Face(face))
    }
}
