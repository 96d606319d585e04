//! A vertex in no face of the complex.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "unreferenced-vertex",
    title: "unreferenced vertices",
    severity: Severity::Note,
    explanation: "No face of the complex uses the vertex. It is not counted in V or in any figure. `compact` removes \
        it.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} is in no face",
};

impl Defect {
    /// A vertex in no face of the complex.
    pub fn unreferenced_vertex(vertex: VertexId) -> Self {
        Defect::new(DefectKind::UnreferencedVertex, Element::Vertex(vertex))
    }
}
