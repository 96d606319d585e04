//! Looks at the whole mesh, and changes nothing.
//!
//! *Why*: a repair is judged by what is there now, not by what it did. A pipeline ends with this pass, and checks the promises
//! of its passes against what is found: a promise that does not hold is an error of the program.
//!
//! The session has the topology of its mesh as long as no pass changes that. So the mesh is looked at afresh if anything was
//! changed since it was looked at last, and the record says which of the two it was.

use meshmend_core::{DefectKind, PolygonMesh, Severity};
use serde::{Deserialize, Serialize};

use crate::{Context, Form, Outcome, Pass, PassError, PassKind, PassRow};

/// Looks at the whole mesh, and changes nothing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Verify {}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "verify",
    explanation: "Changes nothing: looks at the whole result, afresh if anything was changed since it was looked at last, and \
                  checks the promises of the passes before it.",
    is_default: true,
    before: None,
    options: &[],
    form: Form::of::<Verify>(),
};

impl Pass for Verify {
    fn kind(&self) -> PassKind {
        PassKind::Verify
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }
    fn looks_at_topology(&self) -> bool {
        true
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let report = context.topology(mesh)?;
        let wrong = DefectKind::ALL.iter().filter(|kind| kind.severity() == Severity::Defect);
        let left = wrong.flat_map(|&kind| report.defects.of_kind(kind)).collect();
        Ok(Outcome { left, ..Outcome::unchanged(mesh) })
    }
}
