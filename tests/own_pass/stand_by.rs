//! Does nothing.

use meshmend_core::{DefectKind, PolygonMesh};
use meshmend_repair::{
    Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word,
};
use serde::{Deserialize, Serialize};

pub(crate) const ROW: PassRow = PassRow {
    name: "stand-by",
    explanation: "Does nothing, and leaves the mesh as it is.",
    is_default: false,
    before: Some(PassKind::Compact),
    options: &[PassOption {
        name: "stand-by",
        help: "How deeply the repair rests before it goes on",
        sets: &["depth"],
        values: OptionValues::Words(&[
            Word::new("light", "Hardly at all"),
            Word::new("deep", "As deeply as it can"),
        ]),
    }],
    form: Form::of::<StandBy>(),
};

#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
struct StandBy {
    depth: Depth,
}

#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Depth {
    #[default]
    Light,
    Deep,
}

impl Pass for StandBy {
    fn kind(&self) -> PassKind {
        PassKind::Own(&ROW)
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }
    fn apply(&self, mesh: &PolygonMesh, _: &Context<'_>) -> Result<Outcome, PassError> {
        Ok(Outcome::unchanged(mesh))
    }
}
