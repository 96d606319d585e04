//! An edge that is not a side of any face, by its place in the list of loose edges.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "loose-edge",
    title: "loose edges",
    severity: Severity::Note,
    explanation: "An edge that is an element of its own and no face's side. `compact` removes it unless told to keep \
        it.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} joins {ends}",
};

impl Defect {
    /// An edge that is not a side of any face, by its place in the list of loose edges.
    pub fn loose_edge(index: u32, ends: [VertexId; 2]) -> Self {
        Defect::new(DefectKind::LooseEdge, Element::LooseEdge { index, ends })
    }
}
