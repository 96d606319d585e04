//! Two faces that touch where they share neither a corner nor an edge.

use super::{Defect, DefectKind, Detail, Element, Found, Lie, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "touching-faces",
    title: "pairs of faces that touch",
    severity: Severity::Note,
    explanation: "The faces have a point in common beside their common corners and edges, but their insides do not \
        cross: a corner lies within the other face or on its edge, or an edge does. Solids that stand on one \
        another touch so, and the two sides of a T-junction. The item names what touches what.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} and {beside} touch: {detail}",
};

impl Defect {
    /// Two faces that touch where they share neither a corner nor an edge. `how` says how they do.
    pub fn touching_faces(face: FaceId, other: FaceId, how: Lie) -> Self {
        Defect::new(DefectKind::TouchingFaces, Element::Face(face))
            .beside(Element::Face(other))
            .with(Detail::Lies(how))
    }
}
