//! A vertex at which two or more umbrellas meet, all edges there having one side or two.

use super::{Defect, DefectKind, Detail, Element, Found, Listed, Rule, Severity};
use crate::VertexId;

pub(super) const RULE: Rule = Rule {
    code: "pinched-vertex",
    title: "pinched vertices",
    severity: Severity::Defect,
    explanation: "Two or more umbrellas of faces meet in the vertex alone, like two cones tip to tip. If all of them \
        are open fans it becomes manifold when the holes are closed (`boundary_only`). `split` gives each \
        umbrella its own vertex.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: Some("umbrellas"),
    sentence: "{at} joins {count} umbrellas{detail}",
};

impl Defect {
    /// A vertex at which two or more umbrellas meet, all edges there having one side or two.
    pub fn pinched_vertex(vertex: VertexId, umbrellas: u32, boundary_only: bool) -> Self {
        Defect::new(DefectKind::PinchedVertex, Element::Vertex(vertex))
            .counting(umbrellas)
            .with(Detail::BoundaryOnly(boundary_only))
    }
}
