//! A face whose directed cycle an earlier face has too, but which looks otherwise or belongs elsewhere.

use super::{Defect, DefectKind, Detail, Element, Found, Listed, Rule, Severity};
use crate::{Differences, FaceId};

pub(super) const RULE: Rule = Rule {
    code: "differing-face",
    title: "repeated faces that differ",
    severity: Severity::Note,
    explanation: "An earlier face has the same directed cycle of vertices, but another material, object, group, solid, \
        part or colour, or other texture coordinates: a decal, or a second object over the same vertices. \
        Such faces are kept, and `split` takes them apart. `--repeated drop` keeps the first alone.",
    found: Found::ByPass,
    listed: Listed::InRecord { hint: "" },
    counts: None,
    sentence: "{at} is {beside} again, but for {detail}",
};

impl Defect {
    /// A face whose directed cycle an earlier face has too, but which looks otherwise or belongs elsewhere.
    pub fn differing_face(face: FaceId, original: FaceId, differs: Differences) -> Self {
        Defect::new(DefectKind::DifferingFace, Element::Face(face))
            .beside(Element::Face(original))
            .with(Detail::Differs(differs))
    }
}
