//! An edge with one side.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{EdgeId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "boundary-edge",
    title: "boundary edges",
    severity: Severity::Note,
    explanation: "One face side runs along the edge: the surface is open there. meshmend does not fill holes unasked.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: Some("degree"),
    sentence: "{at} has one side",
};

impl Defect {
    /// An edge with one side.
    pub fn boundary_edge(edge: EdgeId, ends: [VertexId; 2]) -> Self {
        Defect::new(DefectKind::BoundaryEdge, Element::Edge { edge, ends }).counting(1)
    }
}
