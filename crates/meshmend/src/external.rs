//! The check of a mesh that is larger than memory, as a report.

use std::path::Path;

use meshmend_core::{DefectKind, Rules};
use meshmend_external::{ExternalCheck, ExternalError, ExternalOptions, external_check};
use meshmend_repair::Distance;

use crate::check::{is_sound, listed_kinds};
use crate::{KernelVerdict, Kernels, View};

/// What a check of a mesh that may be larger than memory found.
#[derive(Debug)]
pub struct ExternalReport {
    /// As what the mesh was judged.
    pub view: View,
    /// What was found, with the first defects of each kind.
    pub found: ExternalCheck,
    /// Which kernels hold the mesh.
    pub kernels: Vec<KernelVerdict>,
    asked: Vec<DefectKind>,
}

/// Checks the mesh of a binary PLY or STL file within a bound of memory. The answers are those of [`check`](crate::check()), whatever the
/// bound is; [`external_check`] says which one may be absent.
///
/// ```no_run
/// use meshmend::report::{CheckDocument, json};
/// use meshmend::{ExternalOptions, Kernels, check_external};
///
/// let report = check_external("scan.ply".as_ref(), &ExternalOptions::within(1 << 30), Kernels::builtin())?;
/// println!("{}", json(&CheckDocument::of_external(&report, "scan.ply".to_owned(), 10))?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`external_check`].
///
/// *Cost*: that of [`external_check`].
pub fn check_external(
    path: &Path,
    options: &ExternalOptions,
    kernels: Kernels,
) -> Result<ExternalReport, ExternalError> {
    let found = external_check(path, options)?;
    let view = if found.is_welded { View::Welded(Distance::Exact) } else { View::Indexed };
    let mut report = ExternalReport { view, found, kernels: Vec::new(), asked: Vec::new() };
    let count = |kind| report.count(kind);
    report.kernels = kernels.all().map(|kernel| KernelVerdict::of(kernel, count)).collect();
    Ok(report)
}

impl ExternalReport {
    /// The report with these kinds listed where they occur, also those that are not listed unasked.
    #[must_use]
    pub fn listing(self, kinds: &[DefectKind]) -> Self {
        ExternalReport { asked: kinds.to_vec(), ..self }
    }

    /// How many defects of a kind there are; 0 for the kinds that are not looked for.
    pub fn count(&self, kind: DefectKind) -> u64 {
        self.found.defects.get(&kind).map_or(0, |(count, _)| *count)
    }

    /// Whether nothing is wrong: no defect of any kind but notes.
    pub fn is_sound(&self) -> bool {
        is_sound(Rules::default(), |kind| self.count(kind))
    }

    /// The kinds that occur and that a report lists, in order.
    pub fn listed_kinds(&self) -> impl Iterator<Item = DefectKind> + '_ {
        listed_kinds(Rules::default(), &self.asked, |kind| self.count(kind))
    }
}
