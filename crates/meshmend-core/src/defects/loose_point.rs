//! A point that is an element of its own, by its place in the list of loose points.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "loose-point",
    title: "loose points",
    severity: Severity::Note,
    explanation: "A point that is an element of its own. `compact` removes it unless told to keep it.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} at {vertex}",
};

impl Defect {
    /// A point that is an element of its own, by its place in the list of loose points.
    pub fn loose_point(index: u32, vertex: VertexId) -> Self {
        Defect::new(DefectKind::LoosePoint, Element::LoosePoint { index, vertex })
    }
}
