//! Drops what is too small, and what is not seen, as it lies inside of others.
//!
//! *Why*: scans have crumbs that float beside the model, and assembled parts have walls inside of others that a slicer would
//! print. Both are closed or open parts like any other, so that no other repair may take them away.
//!
//! 1. `internal`: find the faces inside of what closed components enclose, on both of their sides, exactly. Components all of
//!    whose faces are internal go; or each internal face does, and the edges beside it are open then. Faces of which it can't be
//!    said stay.
//! 2. `components`: those with fewer faces, less area or (closed ones alone) less volume than the limit go as a whole.
//! 3. What went may have been the wall behind which others were internal or of which they were a part; so the rest is asked
//!    again, until nothing goes.
//!
//! Each component that went is named with its figures, and each face with its reason. *Promises* no component under the limit.
//! *Requires* nothing. *May introduce* boundary edges where single faces went, and unreferenced vertices. *Cost*: that of asking
//! for intersections and nesting, O(n log n) a round.

use meshmend_core::{DefectKind, FlippedNormals, PolygonMesh, Provenance};
use serde::{Deserialize, Serialize};

use crate::turned::turned;
use crate::{Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, Word};

mod judging;
mod record;

pub use record::{DropRecord, DroppedComponent};

use judging::Judged;

/// Drops what is too small, and what lies inside of others.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct DropParts {
    /// Which components are too small.
    pub components: SmallComponents,
    /// What happens to what lies inside of others.
    pub internal: Internal,
}

/// Which components are too small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SmallComponents {
    /// None.
    #[default]
    Keep,
    /// Those with fewer faces than this.
    Faces(u32),
    /// Those with less area than this, in squares of the coordinates' unit.
    Area(f64),
    /// Closed ones whose faces agree and that enclose less volume than this.
    Volume(f64),
}

/// What happens to what lies inside of others.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Internal {
    /// It stays.
    #[default]
    Keep,
    /// Components all of whose faces are internal go.
    RemoveComponents,
    /// All internal faces go. Edges beside them are open then.
    RemoveFaces,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "drop",
    explanation: "Drops whole components with fewer faces, less area or less volume than a limit, and what lies inside of others. \
                  Each component that went is named with its figures. Faces of which it can't be said whether they are inside stay.",
    is_default: false,
    before: None,
    options: &[
        PassOption {
            name: "drop-components",
            help: "Which components go, as they are too small: those with fewer faces (faces:12), less area (area:0.5) or, of closed \
                   ones, less volume (volume:0.1)",
            sets: &["components"],
            values: OptionValues::ComponentLimit,
        },
        PassOption {
            name: "internal",
            help: "What happens to what lies inside of what closed components enclose",
            sets: &["internal"],
            values: OptionValues::Words(&[
                Word::new("keep", "It stays"),
                Word::new("remove-components", "Components go that are inside as a whole"),
                Word::new(
                    "remove-faces",
                    "All faces go that are inside on both sides; edges beside them are open then",
                ),
            ]),
        },
    ],
    form: Form::of::<DropParts>(),
};

impl Pass for DropParts {
    fn kind(&self) -> PassKind {
        PassKind::DropParts
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[DefectKind::BoundaryEdge, DefectKind::UnreferencedVertex]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        self.check()?;
        let mut now = mesh.clone();
        let mut provenance = Provenance::same(mesh.counts());
        let mut record = DropRecord::default();
        let mut fixed = Vec::new();
        loop {
            context.check_cancelled()?;
            let Judged { fates, going, components, mixed } = judging::judged(self, &now, context.watch())?;
            record.mixed_faces = mixed;
            if going.is_empty() {
                break;
            }
            let before = |face| provenance.faces.of(face).unwrap_or(face);
            record.components.extend(components.into_iter().map(|component| DroppedComponent {
                lowest_face: before(component.lowest_face),
                ..component
            }));
            fixed.extend(going.into_iter().map(|gone| gone.defect(before(gone.face))));
            record.opened_edges += judging::opened_edges(&now, &fates);
            context.check_cancelled()?;
            let (next, step) = turned(&now, &fates, FlippedNormals::default())?;
            provenance = provenance.then(&step, mesh.faces(), next.faces());
            now = next;
        }
        record.components.sort_by_key(|component| component.lowest_face);
        let dropped = Some(record);
        if provenance.is_same() {
            return Ok(Outcome { dropped, ..Outcome::unchanged(mesh) });
        }
        Ok(Outcome { dropped, ..Outcome::changed((now, provenance), fixed) })
    }
}

impl DropParts {
    fn check(&self) -> Result<(), PassError> {
        match self.components {
            SmallComponents::Area(limit) | SmallComponents::Volume(limit)
                if limit.is_nan() || limit < 0.0 =>
            {
                let reason = format!("a limit must be a number of 0 or more, not {limit}");
                Err(PassError::Request { pass: ROW.name, reason })
            }
            _ => Ok(()),
        }
    }
}
