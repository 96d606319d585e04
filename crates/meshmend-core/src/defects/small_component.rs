//! A face of a component that is under the limit of a policy.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "small-component",
    title: "faces of small components",
    severity: Severity::Note,
    explanation: "The face belongs to a component with fewer faces, less area or less volume than `--drop-components` keeps. \
        The whole component went.",
    found: Found::ByPass,
    listed: Listed::InRecord { hint: "" },
    counts: Some("component_faces"),
    sentence: "{at} belongs to a component under the limit, {faces} in all",
};

impl Defect {
    /// A face of a component of so many faces that is under the limit of a policy.
    pub fn small_component(face: FaceId, faces: u32) -> Self {
        Defect::new(DefectKind::SmallComponent, Element::Face(face)).counting(faces)
    }
}
