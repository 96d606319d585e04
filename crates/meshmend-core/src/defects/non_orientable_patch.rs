//! A patch that has no consistent side: a closed strip of faces reverses orientation.

use super::{Defect, DefectKind, Element, Found, Listed, Rule, Severity, Strip};
use crate::{EdgeId, FaceId};

pub(super) const RULE: Rule = Rule {
    code: "non-orientable-patch",
    title: "non-orientable patches",
    severity: Severity::Defect,
    explanation: "However its faces are flipped, some edge of the patch stays inconsistent: there is a closed strip of \
        faces that comes back mirrored, as on a Moebius band or a Klein bottle. The strip is the witness. \
        `--non-orientable` says whether to report it, cut it open, or fail.",
    found: Found::InSurvey,
    listed: Listed::Unasked,
    counts: None,
    sentence: "{at} comes back reversed",
};

impl Defect {
    /// A patch that has no consistent side: a closed strip of faces reverses orientation.
    pub fn non_orientable_patch(faces: Vec<FaceId>, edges: Vec<EdgeId>) -> Self {
        Defect::new(DefectKind::NonOrientablePatch, Element::Strip(Box::new(Strip { faces, edges })))
    }
}
