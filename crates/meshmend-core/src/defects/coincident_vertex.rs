//! A vertex at the position of an earlier one.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "coincident-vertex",
    title: "vertices that exact welding would join",
    severity: Severity::Note,
    explanation: "An earlier vertex has the same position. Files without shared vertices (STL) have them all over; \
        where they hold a surface together they are stitched by `weld`, and where they keep it manifold they \
        stay.",
    found: Found::ByWelding,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} is where {beside} is",
};

impl Defect {
    /// A vertex at the position of an earlier one.
    pub fn coincident_vertex(vertex: VertexId, original: VertexId) -> Self {
        Defect::new(DefectKind::CoincidentVertex, Element::Vertex(vertex)).beside(Element::Vertex(original))
    }
}
