//! A patch of so many faces, by its lowest face, of which it can't be told which side is the outer one.

use super::{Defect, DefectKind, Detail, Element, Found, Listed, Rule, Severity, Unjudged};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "unjudged-patch",
    title: "patches whose outer side is not known",
    severity: Severity::Note,
    explanation: "`--orient outward` turns closed patches so that they enclose a positive volume. A patch that is \
        open, or that encloses no volume, has no outer side; it keeps the side that most of its faces have.",
    found: Found::ByPass,
    listed: Listed::InRecord { hint: "" },
    counts: Some("patch_faces"),
    sentence: "{at}, {faces} in all, {detail}",
};

impl Defect {
    /// A patch of so many faces, by its lowest face, of which it can't be told which side is the outer one.
    pub fn unjudged_patch(face: FaceId, faces: u32, reason: Unjudged) -> Self {
        Defect::new(DefectKind::UnjudgedPatch, Element::Patch(face))
            .counting(faces)
            .with(Detail::Unjudged(reason))
    }
}
