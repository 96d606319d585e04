//! An open component of so many faces, by its lowest face, of which it can't be seen which side is the front.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "undecided-component",
    title: "open components without a front",
    severity: Severity::Note,
    explanation: "`--outward visible` turns an open component so that it is seen from its front. From some points of it \
        rays go to both sides, and the side from which a tenth more of them leave the mesh is the front. Of this component \
        about as many leave from either side; it stays as it is.",
    found: Found::ByPass,
    listed: Listed::InRecord { hint: "" },
    counts: Some("component_faces"),
    sentence: "{at}, {faces} in all, is seen as much from one side as from the other",
};

impl Defect {
    /// An open component of so many faces, by its lowest face, of which it can't be seen which side is the front.
    pub fn undecided_component(face: FaceId, faces: u32) -> Self {
        Defect::new(DefectKind::UndecidedComponent, Element::Component(face)).counting(faces)
    }
}
