//! An edge with two sides that run the same way.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{EdgeId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "inconsistent-edge",
    title: "inconsistently oriented edges",
    severity: Severity::Defect,
    explanation: "Both face sides run the same way along the edge, so one of the two faces looks to the other side. \
        `orient` flips whole patches' minorities until none is left, where the patch is orientable.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: Some("degree"),
    sentence: "{at} has both sides running the same way",
};

impl Defect {
    /// An edge with two sides that run the same way.
    pub fn inconsistent_edge(edge: EdgeId, ends: [VertexId; 2]) -> Self {
        Defect::new(DefectKind::InconsistentEdge, Element::Edge { edge, ends }).counting(2)
    }
}
