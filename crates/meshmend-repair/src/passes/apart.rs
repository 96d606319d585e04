//! Moves vertices that a file without indices would make one, by the least that keeps them apart.
//!
//! *Why*: `split` gives each sheet its own vertices, at the same place. STL has no indices: there these vertices are one again
//! when the file is read, and so is what was taken apart.
//!
//! 1. Find the vertices that share a position in single precision. The lowest of each place stays.
//! 2. Each of the others goes towards the mean of its neighbours, by the fewest steps of single precision at which no other
//!    vertex has its position, and no triangle turns over or loses its area. This is decided exactly.
//! 3. Where no step will do, or where a face would come to cross another one, the vertex stays and is named.
//!
//! A step is as long as the least difference of two numbers of single precision that are as large as the coordinates there.
//!
//! Only results for formats without indices are changed. *Promises* that the written file, welded exactly, has the connectivity
//! of the result, but for the vertices that are named. *Requires* nothing. *May introduce* nothing. *Cost*: O(n log n).

use meshmend_core::{DefectKind, Draft, PolygonMesh, Sources};
use serde::{Deserialize, Serialize};

use crate::{Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word};

mod moving;
mod record;

pub use record::{ApartFate, ApartRecord, NotMoved};

/// Keeps vertices apart that a file without indices would make one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct KeepApart {
    /// How.
    pub by: ApartBy,
}

/// How vertices are kept apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ApartBy {
    /// By moving them as little as single precision allows.
    #[default]
    Nudge,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "apart",
    explanation: "Moves vertices that a format without indices (STL) would make one again, by the fewest steps of single precision \
                  that keep them apart without turning a triangle over. Each move is named with its length. Results for other \
                  formats stay as they are.",
    is_default: false,
    before: None,
    options: &[PassOption {
        name: "apart",
        help: "How vertices at one place stay apart in a format without indices (STL)",
        sets: &["by"],
        values: OptionValues::Words(&[Word::new(
            "nudge",
            "They move by the least that single precision can tell",
        )]),
    }],
    form: Form::of::<KeepApart>(),
};

impl Pass for KeepApart {
    fn kind(&self) -> PassKind {
        PassKind::KeepApart
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        if !context.storage.is_some_and(|storage| storage.is_apart()) {
            return Ok(Outcome::unchanged(mesh));
        }
        let (positions, apart) = moving::moved(mesh, context.watch())?;
        context.check_cancelled()?;
        if apart.iter().all(|record| !record.is_moved()) {
            return Ok(Outcome { apart, ..Outcome::unchanged(mesh) });
        }
        let (faces, counts) = (mesh.faces(), mesh.counts());
        let draft = Draft {
            kept_positions: Some(positions.into()),
            ..Draft::of_faces(mesh, faces.clone(), Sources::same(counts.faces), Sources::same(counts.corners))
        };
        Ok(Outcome { apart, ..Outcome::changed(mesh.rebuild(draft)?, Vec::new()) })
    }
}
