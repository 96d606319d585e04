//! A triangle that is far longer than it is high.

use super::{Defect, DefectKind, Detail, Element, Found, Lie, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "sliver-face",
    title: "slivers",
    severity: Severity::Note,
    explanation: "The triangle is more than 1000 times as long as it is high. A needle has two corners close to each \
        other, a cap one corner close to the edge between the others. Normals, textures and simulations go \
        wrong on it.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} is a {detail}",
};

impl Defect {
    /// A triangle that is far longer than it is high. `shape` is a needle or a cap.
    pub fn sliver_face(face: FaceId, shape: Lie) -> Self {
        Defect::new(DefectKind::SliverFace, Element::Face(face)).with(Detail::Lies(shape))
    }
}
