//! An edge with three sides or more.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{EdgeId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "non-manifold-edge",
    title: "non-manifold edges",
    severity: Severity::Defect,
    explanation: "Three or more face sides run along the edge, so the surface branches. `split` pairs the sides into \
        sheets and gives each sheet its own edge; no face is deleted.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: Some("degree"),
    sentence: "{at} has {count} sides",
};

impl Defect {
    /// An edge with three sides or more.
    pub fn non_manifold_edge(edge: EdgeId, ends: [VertexId; 2], degree: u32) -> Self {
        Defect::new(DefectKind::NonManifoldEdge, Element::Edge { edge, ends }).counting(degree)
    }
}
