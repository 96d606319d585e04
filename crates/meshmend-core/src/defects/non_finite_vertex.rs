//! A vertex with a coordinate that is infinite or not a number.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "non-finite-vertex",
    title: "non-finite vertices",
    severity: Severity::Defect,
    explanation: "A coordinate is infinite or no number. Faces that use the vertex are dropped by `clean`, unless \
        `--non-finite` says otherwise, and then `compact` removes the vertex.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} is not finite",
};

impl Defect {
    /// A vertex with a coordinate that is infinite or not a number.
    pub fn non_finite_vertex(vertex: VertexId) -> Self {
        Defect::new(DefectKind::NonFiniteVertex, Element::Vertex(vertex))
    }
}
