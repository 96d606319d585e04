//! A component of so many faces, by its lowest face, that looks inward although it lies in an even number of others.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "inside-out-component",
    title: "components inside out",
    severity: Severity::Defect,
    explanation: "The closed component encloses a negative volume, and lies in an even number of other closed components: \
        its faces show their backs, and a slicer or renderer takes the outside for the inside. `--outward` turns it. \
        With `--outward visible` an open component is one, too, that is seen from its back more than from its front.",
    found: Found::ByGeometry,
    listed: Listed::InRecord { hint: "" },
    counts: Some("component_faces"),
    sentence: "{at}, {faces} in all, looks inward",
};

impl Defect {
    /// A component of so many faces, by its lowest face, that looks inward although it lies in an even number of others.
    pub fn inside_out_component(face: FaceId, faces: u32) -> Self {
        Defect::new(DefectKind::InsideOutComponent, Element::Component(face)).counting(faces)
    }
}
