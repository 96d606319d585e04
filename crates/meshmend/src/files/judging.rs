//! What a repair's report says of a mesh before and after.

use std::sync::Arc;

use meshmend_core::{DefectKind, Rules, Watch};
use meshmend_repair::{PassError, Repaired, Session};

use super::{KeptChecks, WholeChecks};
use crate::report::{CheckDocument, RepairDocument};
use crate::{CheckOptions, CheckReport, GeometryMarks, GeometryOptions, View, check, check_in};

/// Which states of a mesh a report on its repair shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Judged {
    /// That before and that after.
    #[default]
    BeforeAndAfter,
    /// That after.
    After,
    /// None; of a file of parts, that after.
    Neither,
}

/// How meshes are judged before a repair and after it.
#[derive(Clone)]
pub(super) struct Judging {
    pub(super) rules: Rules,
    /// How many items each list shows.
    pub(super) limit: usize,
    /// Whether whole reports are kept.
    pub(super) checks: WholeChecks,
    /// What is asked about where the faces lie.
    pub(super) geometry: Option<GeometryOptions>,
    /// Kinds of defect that are listed beside the usual ones.
    pub(super) listed: Vec<DefectKind>,
}

/// What a mesh was before a repair.
pub(super) struct Before {
    pub(super) document: CheckDocument,
    kept: Option<Arc<CheckReport>>,
    marks: GeometryMarks,
}

impl Judging {
    /// Judges a mesh to which no pass was applied yet.
    pub(super) fn before(&self, session: &mut Session, view: View) -> Result<Before, PassError> {
        let report = self.with_geometry(check_in(session, view, self.rules)?, session.watch())?;
        let marks = self.geometry.map(|options| GeometryMarks::before(&report, &options)).unwrap_or_default();
        let (document, kept) = self.document(report);
        Ok(Before { document, kept, marks })
    }

    /// Adds to a report the state after: what `verify` found, or a check where the plan leaves that out; and the state before,
    /// if that was judged. Gives back the checks that are to be kept.
    pub(super) fn add(
        &self,
        before: Option<Before>,
        repaired: &mut Repaired,
        document: &mut RepairDocument,
        watch: &Watch,
    ) -> Result<KeptChecks, PassError> {
        let report = match repaired.topology.take() {
            Some(topology) => CheckReport::of_topology(repaired.mesh.clone(), *topology, self.rules, watch)?,
            None => check(&repaired.mesh, &CheckOptions::default().with_rules(self.rules).with_watch(watch))?,
        };
        let report = self.with_geometry(report, watch)?;
        if let (Some(options), Some(before)) = (&self.geometry, &before) {
            let after = GeometryMarks::after(&report, options, &repaired.provenance);
            document.geometry_changes = Some(before.marks.changes_to(&after));
        }
        let mut kept = KeptChecks::default();
        document.before = before.map(|before| {
            kept.before = before.kept;
            before.document
        });
        let (after, whole) = self.document(report);
        (document.after, kept.after) = (Some(after), whole);
        Ok(kept)
    }

    /// The document of a report, and the report itself where it is to be kept.
    fn document(&self, report: CheckReport) -> (CheckDocument, Option<Arc<CheckReport>>) {
        let kept = (self.checks == WholeChecks::Kept).then(|| Arc::new(report.clone()));
        (CheckDocument::new(report, self.limit), kept)
    }

    fn with_geometry(&self, report: CheckReport, watch: &Watch) -> Result<CheckReport, PassError> {
        let report = match &self.geometry {
            Some(options) => report.with_geometry(options, watch)?,
            None => report,
        };
        Ok(report.listing(&self.listed))
    }
}
