//! A face whose cycle an earlier face runs the other way round, and none the same way.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "opposite-face",
    title: "opposite duplicate faces",
    severity: Severity::Note,
    explanation: "An earlier face has the same cycle the other way round: a double-sided wall. It is kept unless \
        `--duplicates` says `remove-pair` or `keep-first`.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} is {beside} the other way round",
};

impl Defect {
    /// A face whose cycle an earlier face runs the other way round, and none the same way.
    pub fn opposite_face(face: FaceId, original: FaceId) -> Self {
        Defect::new(DefectKind::OppositeFace, Element::Face(face)).beside(Element::Face(original))
    }
}
