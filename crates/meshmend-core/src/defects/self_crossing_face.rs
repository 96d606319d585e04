//! A face of which two parts of the surface cross.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "self-crossing-face",
    title: "faces whose own surface crosses itself",
    severity: Severity::Defect,
    explanation: "A face of more than three corners is the triangles into which `triangulate` cuts it. Two of these \
        cross. The face is far from flat, or its outline crosses itself.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} crosses itself",
};

impl Defect {
    /// A face of which two parts of the surface cross.
    pub fn self_crossing_face(face: FaceId) -> Self {
        Defect::new(DefectKind::SelfCrossingFace, Element::Face(face))
    }
}
