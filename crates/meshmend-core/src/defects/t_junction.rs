//! A vertex of the boundary that lies on an edge of the boundary.

use super::{Defect, DefectKind, Detail, Element, Found, Lie, Listed, Rule, Severity};
use crate::{EdgeId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "t-junction",
    title: "T-junctions",
    severity: Severity::Note,
    explanation: "A vertex at the rim of one part of the surface lies on an edge at the rim of another part, between \
        its ends. The surface looks closed there and is open: light comes through, and slicers see a gap. \
        `--near` says from which distance on a vertex is on an edge. It is aligned where an edge of its own runs along that edge.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} lies on {beside} ({detail})",
};

impl Defect {
    /// A vertex of the boundary that lies on an edge of the boundary.
    pub fn t_junction(vertex: VertexId, edge: EdgeId, ends: [VertexId; 2], is_aligned: bool) -> Self {
        let how = if is_aligned { Lie::Aligned } else { Lie::NotAligned };
        Defect::new(DefectKind::TJunction, Element::Vertex(vertex))
            .beside(Element::Edge { edge, ends })
            .with(Detail::Lies(how))
    }
}
