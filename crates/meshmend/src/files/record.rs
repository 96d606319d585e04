//! What is known of one mesh of a file that was repaired, and the report on it with lists of any length.

use std::sync::Arc;

use meshmend_core::PolygonMesh;
use meshmend_repair::Repaired;

use super::Maps;
use crate::CheckReport;
use crate::report::{CheckDocument, ProvenanceDocument, RepairDocument};

/// Whether the checks before a repair and after it are kept whole, beside the report, whose lists are cut.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum WholeChecks {
    /// They are not: their lists of defects can be larger than the mesh.
    #[default]
    Dropped,
    /// They are.
    Kept,
}

/// The checks of a mesh before a repair and after it, where they were made and kept.
#[derive(Clone, Debug, Default)]
#[non_exhaustive]
pub struct KeptChecks {
    /// Before the first pass.
    pub before: Option<Arc<CheckReport>>,
    /// After the last one.
    pub after: Option<Arc<CheckReport>>,
}

/// What is known of one mesh of a file that was repaired.
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct RepairRecord<'a> {
    /// The mesh as it was read.
    pub stored: &'a PolygonMesh,
    /// The mesh as it is now, and what each pass did.
    pub repaired: &'a Repaired,
    /// The report.
    pub report: &'a RepairDocument,
    /// The checks of which the report shows the beginning, if they were kept.
    pub checks: &'a KeptChecks,
}

impl RepairRecord<'_> {
    /// The report with at most `limit` items in each list, with the maps or without. Checks that were not kept are as in the
    /// report.
    ///
    /// *Cost*: that of the lists.
    pub fn document(&self, limit: usize, maps: Maps) -> RepairDocument {
        let of_check = |shown: &Option<CheckDocument>, kept: &Option<Arc<CheckReport>>| {
            let shown = shown.as_ref()?;
            let Some(kept) = kept else { return Some(shown.clone()) };
            let document = CheckDocument::new(CheckReport::clone(kept), limit);
            let (file, format, notes) = (shown.file.clone(), shown.format, shown.notes.clone());
            Some(CheckDocument { file, format, notes, ..document })
        };
        let told = self.report;
        RepairDocument {
            file: told.file.clone(),
            output: told.output.clone(),
            notes: told.notes.clone(),
            before: of_check(&told.before, &self.checks.before),
            after: of_check(&told.after, &self.checks.after),
            losses: told.losses.clone(),
            failing: told.failing.clone(),
            provenance: (maps == Maps::Whole).then(|| ProvenanceDocument::new(&self.repaired.provenance)),
            geometry_changes: told.geometry_changes.clone(),
            ..RepairDocument::new(self.stored, self.repaired, limit)
        }
    }
}
