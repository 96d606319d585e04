//! A vertex at an edge with three sides or more.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "singular-vertex",
    title: "singular vertices",
    severity: Severity::Defect,
    explanation: "An edge with three sides or more ends here. `split` mends it together with the edge.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} is on a non-manifold edge",
};

impl Defect {
    /// A vertex at an edge with three sides or more.
    pub fn singular_vertex(vertex: VertexId) -> Self {
        Defect::new(DefectKind::SingularVertex, Element::Vertex(vertex))
    }
}
