//! A face that lists a vertex twice in a row, or walks to a vertex and straight back.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{FaceId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "repeated-corner",
    title: "faces with repeated corners or spikes",
    severity: Severity::Note,
    explanation: "The face lists a vertex twice in a row (a a b c), or walks to a vertex and straight back (a b a c). \
        The extra corners bound nothing; `clean` drops them and keeps the face.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} repeats {vertex}",
};

impl Defect {
    /// A face that lists a vertex twice in a row, or walks to a vertex and straight back.
    pub fn repeated_corner(face: FaceId, vertex: VertexId) -> Self {
        Defect::new(DefectKind::RepeatedCorner, Element::Corner { face, vertex })
    }
}
