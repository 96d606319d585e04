//! Two vertices that several edges would join, if faces were only told apart by index.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "coincident-edges",
    title: "edges that would coincide",
    severity: Severity::Defect,
    explanation: "Two different edges of the result join the same two vertices, the surface being connected elsewhere. \
        By index they would be one edge again, so `split` gives each of them a vertex of its own.",
    found: Found::ByPass,
    listed: Listed::Unasked,
    counts: None,
    sentence: "several edges would join {at}-{beside}",
};

impl Defect {
    /// Two vertices that several edges would join, if faces were only told apart by index.
    pub fn coincident_edges(ends: [VertexId; 2]) -> Self {
        Defect::new(DefectKind::CoincidentEdges, Element::Vertex(ends[0])).beside(Element::Vertex(ends[1]))
    }
}
