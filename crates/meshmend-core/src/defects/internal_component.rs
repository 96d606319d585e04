//! A component of so many faces, by its lowest face, all of which are internal.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "internal-component",
    title: "internal components",
    severity: Severity::Note,
    explanation: "All faces of the component are `internal-face`: it lies as a whole inside of what others enclose, and nothing \
        of it is seen from outside.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: Some("component_faces"),
    sentence: "{at}, {faces} in all, is inside others",
};

impl Defect {
    /// A component of so many faces, by its lowest face, all of which are internal.
    pub fn internal_component(face: FaceId, faces: u32) -> Self {
        Defect::new(DefectKind::InternalComponent, Element::Component(face)).counting(faces)
    }
}
