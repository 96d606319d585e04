//! A face that comes back to a vertex.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity};
use crate::{FaceId, VertexId};

pub(super) const RULE: Rule = Rule {
    code: "non-simple-face",
    title: "non-simple faces",
    severity: Severity::Defect,
    explanation: "The face has three or more different vertices but comes back to one of them: its rim touches itself. \
        Most data structures can't hold it. `clean` splits it into simple faces at the repeated vertex, or, \
        if it has a hole, cuts it along diagonals.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{face} comes back to {vertex}",
};

impl Defect {
    /// A face that comes back to a vertex.
    pub fn non_simple_face(face: FaceId, vertex: VertexId) -> Self {
        Defect::new(DefectKind::NonSimpleFace, Element::Corner { face, vertex })
    }
}
