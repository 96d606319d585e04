//! What a pipeline has done so far.

use meshmend_core::{Defect, DefectKind, FaceId, PolygonMesh};
use meshmend_topology::TopologyReport;

use super::{PassRecord, RemovedFace, Repaired};
use crate::figures::Figures;
use crate::{History, Outcome, PassKind};

/// A pipeline under way.
pub(super) struct Run {
    pub(super) mesh: PolygonMesh,
    pub(super) history: History,
    pub(super) passes: Vec<PassRecord>,
    removed_faces: Vec<RemovedFace>,
    pub(super) report: Option<Box<TopologyReport>>,
    /// The topology of the mesh, if it was known before the pipeline looked at it.
    pub(super) known: Option<TopologyReport>,
    /// The largest tolerance within which vertices were joined.
    pub(super) tolerance: f64,
    takes_figures: bool,
    /// The figures of the mesh before each pass that changed it, and in the end of the last mesh, if asked for.
    figures: Vec<Figures>,
}

impl Run {
    /// With nothing done yet.
    pub(super) fn begin(stored: &PolygonMesh, takes_figures: bool) -> Self {
        Run {
            // The tables of the first mesh go when a pass has made another.
            mesh: stored.detached(),
            history: History::begin(stored),
            passes: Vec::new(),
            removed_faces: Vec::new(),
            report: None,
            known: None,
            tolerance: 0.0,
            takes_figures,
            figures: Vec::new(),
        }
    }

    /// Takes over what a pass did.
    pub(super) fn record(&mut self, pass: PassKind, outcome: Outcome) {
        let is_changed = !outcome.provenance.is_same() || !outcome.mended.is_empty();
        if is_changed {
            self.name_removed_faces(pass, &outcome);
            self.history = self.history.extended(&outcome.provenance, &outcome.mesh);
            self.figures.extend(self.figures());
            (self.report, self.known) = (None, None);
        }
        self.mesh = outcome.mesh;
        self.report = outcome.report.or(self.report.take());
        self.passes.push(PassRecord {
            pass,
            is_changed,
            mended: outcome.mended,
            left: outcome.left,
            figures: None,
            seam: outcome.seam,
        });
    }

    /// The figures of the present mesh, if they are asked for.
    fn figures(&self) -> Option<Figures> {
        let report = self.report.as_deref().or(self.known.as_ref());
        let of_mesh = || report.map_or_else(|| Figures::of(&self.mesh), Figures::of_report);
        self.takes_figures.then(of_mesh)
    }

    /// Finds, for each face of which this pass left nothing, the defect that names it.
    fn name_removed_faces(&mut self, pass: PassKind, outcome: &Outcome) {
        let mut reasons: Vec<(FaceId, DefectKind)> = outcome
            .mended
            .listed()
            .iter()
            .filter_map(|defect| Some((removed_face(defect)?, defect.kind())))
            .collect();
        reasons.sort_unstable();
        for face in outcome.provenance.removed_faces() {
            let at = reasons.partition_point(|(named, _)| *named < face);
            let named = reasons.get(at).filter(|(named, _)| *named == face);
            let Some(stored) = self.history.provenance().faces.of(face) else { continue };
            let reason = named.map_or(DefectKind::DegenerateFace, |(_, kind)| *kind);
            self.removed_faces.push(RemovedFace { face: stored, pass, reason });
        }
    }

    /// All that was done.
    pub(super) fn finish(mut self) -> Repaired {
        self.figures.extend(self.figures());
        if self.takes_figures {
            let mut changes = 0;
            for record in &mut self.passes {
                let before = changes;
                changes += usize::from(record.is_changed);
                record.figures = Some([before, changes].map(|at| self.figures[at]));
            }
        }
        let provenance = self.history.provenance().clone();
        let survives = provenance.faces.survivors(provenance.before.faces);
        let mut removed_faces = self.removed_faces;
        // A face that was split has several parts, and is gone only when all of them are.
        removed_faces.retain(|removed| !survives[removed.face.0 as usize]);
        removed_faces.sort_by_key(|removed| removed.face);
        removed_faces.dedup_by_key(|removed| removed.face);
        Repaired { mesh: self.mesh, provenance, passes: self.passes, removed_faces, report: self.report }
    }
}

/// The face that a defect names, for the kinds that make a face go.
fn removed_face(defect: &Defect) -> Option<FaceId> {
    match *defect {
        Defect::DegenerateFace { face }
        | Defect::NonFiniteFace { face, .. }
        | Defect::DuplicateFace { face, .. }
        | Defect::OppositeFace { face, .. } => Some(face),
        _ => None,
    }
}
