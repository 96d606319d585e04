//! A component of so many faces, by its lowest face, that looks outward and lies in an odd number of others.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "solid-within",
    title: "solids within solids",
    severity: Severity::Note,
    explanation: "The closed component encloses a positive volume, and lies in an odd number of other closed components: \
        the space in it is counted twice. If it is meant as the wall of a hollow, `--outward nested` turns it inward.",
    found: Found::ByGeometry,
    listed: Listed::InRecord { hint: "--outward nested turns it into the wall of a hollow" },
    counts: Some("component_faces"),
    sentence: "{at}, {faces} in all, lies inside another and looks outward",
};

impl Defect {
    /// A component of so many faces, by its lowest face, that looks outward and lies in an odd number of others.
    pub fn solid_within(face: FaceId, faces: u32) -> Self {
        Defect::new(DefectKind::SolidWithin, Element::Component(face)).counting(faces)
    }
}
