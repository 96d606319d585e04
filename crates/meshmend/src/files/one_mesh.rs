//! The repair of a file that is one mesh.

use meshmend_core::Watch;
use meshmend_io::{Document, Placing, ReadFile, rounding_losses};
use meshmend_repair::{Repaired, Session};

use super::judging::Before;
use super::{FileError, FileRepair, FileTarget, Judged, KeptChecks, Maps, PreparedFile, RepairedMesh};
use crate::View;
use crate::report::{ProvenanceDocument, RepairDocument};

impl FileRepair {
    /// Repairs a file as one mesh.
    pub(super) fn run_as_one(
        &self,
        name: &str,
        document: Document,
        target: Option<&FileTarget>,
        watch: &Watch,
    ) -> Result<RepairedMesh, FileError> {
        self.parts.chosen(&document)?;
        let placed = document.into_mesh(Placing::Parts);
        let file = placed.map_err(|error| FileError::Placed { file: name.to_owned(), error })?;
        let failed = |error| FileError::of_pass(name, error);
        let (mut repaired, before) = self.repair_mesh(name, &file, target, watch)?;
        let look = |step| watch.look(step, 0, 0).map_err(|stopped| failed(stopped.into()));
        look("report")?;
        let mut report = RepairDocument::new(&file.mesh, &repaired, self.limit);
        report.file = Some(name.to_owned());
        report.notes = file.notes.clone();
        if self.maps == Maps::Whole {
            report.provenance = Some(ProvenanceDocument::new(&repaired.provenance));
        }
        let mut checks = KeptChecks::default();
        if self.judged != Judged::Neither {
            checks = self.judging().add(before, &mut repaired, &mut report, watch).map_err(failed)?;
        }
        look("prepare")?;
        let prepared = target.map(|target| target.prepared(&repaired.mesh)).transpose()?;
        if let (Some(target), Some(prepared)) = (target, &prepared) {
            name_output(&mut report, target, prepared, &repaired);
        }
        Ok(RepairedMesh { file, repaired, report, checks, prepared })
    }

    /// Repairs the mesh of a file, and judges it before.
    fn repair_mesh(
        &self,
        name: &str,
        file: &ReadFile,
        target: Option<&FileTarget>,
        watch: &Watch,
    ) -> Result<(Repaired, Option<Before>), FileError> {
        let failed = |error| FileError::of_pass(name, error);
        let pipeline = self.pipeline(&file.mesh, target);
        watch.look("check", 0, 0).map_err(|stopped| failed(stopped.into()))?;
        let mut session = Session::begin(&file.mesh).with_watch(watch);
        let mut before = None;
        if self.judged == Judged::Neither {
            session = session.sparing_topology();
        }
        if self.judged == Judged::BeforeAndAfter {
            session = session.with_figures();
            let view = View::usual_for(file.format);
            let mut judged = self.judging().before(&mut session, view).map_err(failed)?;
            judged.document = judged.document.of_file(name.to_owned(), file);
            before = Some(judged);
        }
        Ok((pipeline.run_in(session.with_kernel(self.kernel)).map_err(failed)?, before))
    }
}

/// Says in a report what will be written, and what is lost by it.
fn name_output(
    report: &mut RepairDocument,
    target: &FileTarget,
    prepared: &PreparedFile,
    repaired: &Repaired,
) {
    let vertices = report.stored.before.vertices;
    report.losses = repaired.rounding.map_or(Vec::new(), |rounding| rounding_losses(rounding, vertices));
    report.losses.extend(prepared.losses());
    let Some(name) = target.named() else { return };
    report.output = Some(name);
    if let Some(after) = &mut report.after {
        (after.file, after.format) = (report.output.clone(), target.variant());
    }
}
