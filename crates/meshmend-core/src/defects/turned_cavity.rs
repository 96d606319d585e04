//! A closed patch of so many faces, by its lowest face, that was turned outward although it lies inside another.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "turned-cavity",
    title: "cavities turned outward",
    severity: Severity::Note,
    explanation: "The closed patch lies inside another one and looked inward, as the wall of a hollow does. `--orient \
        outward` turned it all the same. `--orient outward-nested` keeps the walls of hollows.",
    found: Found::ByPass,
    listed: Listed::InRecord { hint: "--orient outward-nested keeps the walls of cavities" },
    counts: Some("patch_faces"),
    sentence: "the closed patch of {face}, {faces} in all, is inside another",
};

impl Defect {
    /// A closed patch of so many faces, by its lowest face, that was turned outward although it lies inside another.
    pub fn turned_cavity(face: FaceId, faces: u32) -> Self {
        Defect::new(DefectKind::TurnedCavity, Element::Patch(face)).counting(faces)
    }
}
