//! Two faces whose insides have a common point.

use super::{Defect, DefectKind, Detail, Element, Found, Lie, Listed, Rule, Severity};
use crate::FaceId;

pub(super) const RULE: Rule = Rule {
    code: "crossing-faces",
    title: "pairs of faces that cross",
    severity: Severity::Defect,
    explanation: "The insides of two faces have a common point: they pass through one another, or overlap in one \
        plane. What is inside and what is outside is then not defined there, and programs that slice, \
        compute or subdivide the surface go wrong. The answer is that of exact arithmetic. Nothing here \
        mends it: the item says which faces, and whether they lie in one plane.",
    found: Found::ByGeometry,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} and {beside} {detail}",
};

impl Defect {
    /// Two faces whose insides have a common point. `how` says how they do.
    pub fn crossing_faces(face: FaceId, other: FaceId, how: Lie) -> Self {
        Defect::new(DefectKind::CrossingFaces, Element::Face(face))
            .beside(Element::Face(other))
            .with(Detail::Lies(how))
    }
}
