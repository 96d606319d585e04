//! An edge of the seam along which a non-orientable patch is cut.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{EdgeId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "seam-edge",
    title: "seam edges",
    severity: Severity::Defect,
    explanation: "A non-orientable patch is cut open along these edges when `--non-orientable cut` asks for it: what \
        is left can be oriented.",
    found: Found::ByPass,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} is cut open",
};

impl Defect {
    /// An edge of the seam along which a non-orientable patch is cut.
    pub fn seam_edge(edge: EdgeId, ends: [VertexId; 2]) -> Self {
        Defect::new(DefectKind::SeamEdge, Element::Edge { edge, ends })
    }
}
