//! A closed component of so many faces, by its lowest face, that encloses no volume.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "no-volume",
    title: "closed components without a volume",
    severity: Severity::Note,
    explanation: "The closed component encloses as much space on one side as on the other, as a flat pillow does. So it \
        has no outer side, and `--outward` leaves it as it is.",
    found: Found::ByGeometry,
    listed: Listed::InRecord { hint: "" },
    counts: Some("component_faces"),
    sentence: "{at}, {faces} in all, encloses no volume",
};

impl Defect {
    /// A closed component of so many faces, by its lowest face, that encloses no volume.
    pub fn no_volume(face: FaceId, faces: u32) -> Self {
        Defect::new(DefectKind::NoVolume, Element::Component(face)).counting(faces)
    }
}
