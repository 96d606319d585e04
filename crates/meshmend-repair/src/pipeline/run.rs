//! What a pipeline has done so far.

use meshmend_core::{
    Defect, DefectKind, Differences, FaceId, Id, PolygonMesh, Provenance, VertexId, turned_normals,
};
use meshmend_geometry::rounding::Rounding;
use meshmend_topology::TopologyReport;

use super::{FaceStorage, PassRecord, RemovedFace, Repaired};
use crate::figures::Figures;
use crate::{Fixed, History, Outcome, PassError, PassKind};

/// A pipeline under way.
pub(super) struct Run {
    pub(super) mesh: PolygonMesh,
    pub(super) history: History,
    pub(super) passes: Vec<PassRecord>,
    /// Where the records of the last round begin.
    round: usize,
    removed_faces: Vec<RemovedFace>,
    rounding: Option<Rounding>,
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
            mesh: stored.with_own_cache(),
            history: History::begin(stored),
            passes: Vec::new(),
            round: 0,
            removed_faces: Vec::new(),
            rounding: None,
            report: None,
            known: None,
            tolerance: 0.0,
            takes_figures,
            figures: Vec::new(),
        }
    }

    /// On a mesh whose positions were rounded before.
    pub(super) fn after_rounding(self, rounding: Rounding) -> Self {
        Run { rounding: Some(rounding), ..self }
    }

    /// Takes over what a pass did.
    pub(super) fn record(&mut self, pass: PassKind, outcome: Outcome) {
        let is_changed = !outcome.provenance.is_same() || !outcome.fixed.is_empty();
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
            fixed: outcome.fixed,
            left: outcome.left,
            figures: None,
            seam: outcome.seam,
        });
    }

    /// The mesh as stored.
    pub(super) fn stored(&self) -> &PolygonMesh {
        self.history.stored()
    }

    /// What the passes did in the last round.
    pub(super) fn last_round(&self) -> &[PassRecord] {
        &self.passes[self.round..]
    }

    /// Whether faces that repeat others are there because they differ, as far as the last round saw.
    pub(super) fn has_copies(&self) -> bool {
        let is_copy = |defect: &Defect| defect.kind() == DefectKind::DifferingFace;
        self.last_round().iter().any(|record| record.left.iter().any(is_copy))
    }

    /// Takes over what one more round did to the mesh as it was read again.
    pub(super) fn follow(&mut self, (read, reading): (&PolygonMesh, &Provenance), next: Run) {
        let history = self.history.extended(reading, read);
        let as_stored = |removed: RemovedFace| {
            Some(RemovedFace { face: history.provenance().faces.of(removed.face)?, ..removed })
        };
        self.removed_faces.extend(next.removed_faces.into_iter().filter_map(as_stored));
        self.history = history.extended(next.history.provenance(), &next.mesh);
        self.round = self.passes.len();
        self.tolerance = self.tolerance.max(next.tolerance);
        self.passes.extend(next.passes);
        self.figures.extend(next.figures);
        (self.mesh, self.report) = (next.mesh, next.report);
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
            .fixed
            .listed()
            .iter()
            .filter_map(|defect| Some((removed_face(defect)?, defect.kind())))
            .collect();
        reasons.sort_unstable();
        let mut differed = outcome.differed.clone();
        differed.sort_unstable();
        for face in outcome.provenance.removed_faces() {
            let at = reasons.partition_point(|(named, _)| *named < face);
            let named = reasons.get(at).filter(|(named, _)| *named == face);
            let Some(stored) = self.history.provenance().faces.of(face) else { continue };
            let reason = named.map_or(DefectKind::DegenerateFace, |(_, kind)| *kind);
            let place = differed.binary_search_by_key(&face, |(named, _)| *named);
            let differed = place.map_or(Differences::default(), |place| differed[place].1);
            self.removed_faces.push(RemovedFace { face: stored, pass, reason, differed });
        }
    }

    /// All that was done.
    ///
    /// # Errors
    /// When the storage can't make what it stores.
    pub(super) fn finish(mut self, storage: &FaceStorage) -> Result<Repaired, PassError> {
        let has_changed = self.passes.iter().any(|record| record.is_changed);
        let is_same = has_changed && storage.are_alike(self.stored(), &self.mesh)?;
        let stitched = if has_changed { self.stitched(storage, is_same) } else { 0 };
        self.figures.extend(self.figures());
        if self.takes_figures {
            let mut changes = 0;
            for record in &mut self.passes {
                let before = changes;
                changes += usize::from(record.is_changed);
                record.figures = Some([before, changes].map(|at| self.figures[at]));
            }
        }
        self.keep_last_judgement();
        let provenance = self.history.provenance().clone();
        let survives = provenance.faces.survivors(provenance.before.faces);
        let mut removed_faces = self.removed_faces;
        // A face that was split has several parts, and is gone only when all of them are.
        removed_faces.retain(|removed| !survives[removed.face.0 as usize]);
        removed_faces.sort_by_key(|removed| removed.face);
        removed_faces.dedup_by_key(|removed| removed.face);
        let turned_normals = turned_normals(self.history.stored(), &self.mesh, &provenance);
        let Run { mut mesh, mut passes, rounding, report, .. } = self;
        let mut provenance = provenance;
        if is_same {
            forget_changes(&mut passes);
            if !storage.takes_apart(&mesh)? {
                mesh = self.history.stored().clone();
                provenance = Provenance::same(mesh.counts());
            }
        }
        Ok(Repaired { mesh, provenance, passes, removed_faces, turned_normals, rounding, report, stitched })
    }

    /// How many vertices the first pass joined to others that are apart from them in the result.
    fn stitched(&self, storage: &FaceStorage, is_same: bool) -> usize {
        let Some(weld) = self.passes.first() else { return 0 };
        if is_same {
            return weld.fixed.joined_to().iter().enumerate().filter(|(v, low)| low.index() != *v).count();
        }
        let joined_to = weld.fixed.joined_to();
        let is_split = self.passes.iter().any(|record| record.pass == PassKind::Split && record.is_changed);
        if joined_to.is_empty() || (!storage.is_apart() && !is_split) {
            return 0;
        }
        let provenance = self.history.provenance();
        if storage.is_apart()
            && provenance.corners.is_all_of(provenance.before.corners)
            && provenance.before.vertices == provenance.before.corners
        {
            // Every vertex as stored has a corner of its own, and all are there.
            return weld.fixed.len();
        }
        let stays: Vec<bool> = if storage.is_apart() {
            let mut stays = vec![false; joined_to.len()];
            let corners = provenance.corners.iter().filter_map(|(_, stored)| stored);
            corners.for_each(|c| stays[self.stored().faces().corner_vertex(c).index()] = true);
            stays
        } else {
            provenance.vertices.survivors(joined_to.len())
        };
        let is_joined = |(v, low): (usize, &VertexId)| low.index() != v && stays[v];
        joined_to.iter().enumerate().filter(|&at| is_joined(at)).count()
    }
}

/// The records of passes that together changed nothing.
fn forget_changes(passes: &mut [PassRecord]) {
    let last = passes.last().and_then(|record| record.figures);
    for record in passes {
        (record.is_changed, record.fixed, record.seam) = (false, Fixed::default(), None);
        record.figures = last.map(|[_, after]| [after; 2]);
    }
}

impl Run {
    /// Where patches are turned outward twice, what could not be judged the first time may have been the second time.
    fn keep_last_judgement(&mut self) {
        let orients = self.passes.iter_mut().filter(|record| record.pass == PassKind::Orient);
        let not_last = orients.rev().skip(1);
        not_last.for_each(|record| record.left.retain(|defect| defect.kind() != DefectKind::UnjudgedPatch));
    }
}

/// The face that a defect names, for the kinds that make a face go.
fn removed_face(defect: &Defect) -> Option<FaceId> {
    match defect.kind {
        DefectKind::DegenerateFace
        | DefectKind::NonFiniteFace
        | DefectKind::DuplicateFace
        | DefectKind::OppositeFace => defect.at.face(),
        _ => None,
    }
}
