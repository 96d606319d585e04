//! A mesh under repair: passes are applied to it one after another, and all that was done is kept.

mod finish;
mod spared;

use std::fmt;

use meshmend_core::{Defect, DefectKind, Differences, FaceId, PolygonMesh, Provenance, VertexId, Watch};
use meshmend_geometry::rounding::Rounding;
use meshmend_kernels::KernelKind;
use meshmend_topology::{TopologyReport, Witness};
use serde::Serialize;

use crate::figures::Figures;
use crate::pass::topology_on;
use crate::sewing::KeptSewing;
use crate::{
    AnyPass, Clearance, Context, FaceStorage, History, Outcome, PassError, PassKind, PassRecord, RemovedFace,
    TellingLayers,
};

/// A mesh under repair.
///
/// ```
/// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// # use meshmend_repair::{Clean, Pipeline, Session, Weld};
/// # let positions = [[0, 0], [1, 0], [0, 1], [1, 0], [0, 1], [1, 1]].map(|[x, y]| [x.into(), y.into(), 0.0]);
/// # let faces = FaceTable::triangles(6, (0..6).map(VertexId).collect())?;
/// # let mesh = PolygonMesh::new(positions.to_vec(), faces)?;
/// let mut session = Session::begin(&mesh);
/// assert_eq!(session.topology()?.components, 2);
/// let record = session.apply(Weld::default())?;
/// assert!(record.is_changed);
/// assert_eq!(session.topology()?.components, 1);
///
/// // A pipeline goes on with it: what is known of the mesh is not found out again.
/// let repaired = Pipeline::default().run_in(session)?;
/// assert_eq!(repaired.mesh.positions().len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Session {
    mesh: PolygonMesh,
    history: History,
    /// What a pass made of the mesh that moved vertices, and all that was done since: later passes take that for the mesh as
    /// stored, so that no vertex is put back.
    since_moved: Option<History>,
    /// The topology of the mesh, once it was asked for and until the mesh is changed.
    topology: Option<Box<TopologyReport>>,
    /// Whether the mesh is an oriented surface of triangles and nothing else, once that was asked for; not after another pass than
    /// `weld` changed it.
    is_plain_surface: Option<bool>,
    /// How the mesh is sewn, if a pass found that out and no other one has used it.
    sewing: KeptSewing,
    kernel: KernelKind,
    witness: Witness,
    watch: Watch,
    takes_figures: bool,
    /// Whether nobody will ask for the topology of the result.
    spares_topology: bool,
    aim: Aim,
    /// The passes that were applied, in order.
    applied: Vec<AnyPass>,
    records: Vec<PassRecord>,
    /// Where the records of the last round begin.
    round: usize,
    removed_faces: Vec<RemovedFace>,
    /// Each face of the mesh that has no source, with the pass that created it, ascending.
    created_faces: Vec<(FaceId, PassKind)>,
    rounding: Option<Rounding>,
    /// The largest tolerance within which vertices were joined.
    tolerance: f64,
    /// How far a vertex is at most from one, as stored, that went into it.
    moved: f64,
    /// The figures of the mesh before each pass that changed it, and in the end of the last mesh, if asked for.
    figures: Vec<Figures>,
}

/// What the result of a session is made for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Aim {
    /// What created vertices keep clear of; the tolerance is that of the session.
    pub(crate) clearance: Clearance,
    /// For each layer of the mesh whether it tells apart faces that repeat others; all do if this is absent.
    pub(crate) telling: Option<Vec<bool>>,
    pub(crate) storage: FaceStorage,
}

/// How `verify` came to know the topology of the mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Looked {
    /// It looked at the mesh.
    Afresh,
    /// The session had looked at the mesh, and no pass changed it since.
    Before,
}

impl fmt::Debug for Session {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Session")
            .field("mesh", &self.mesh.counts())
            .field("applied", &self.applied)
            .finish_non_exhaustive()
    }
}

impl Session {
    /// A session with a mesh to which no pass was applied yet.
    pub fn begin(stored: &PolygonMesh) -> Self {
        Session {
            // The tables of the first mesh go when a pass has made another.
            mesh: stored.with_own_cache(),
            history: History::begin(stored),
            since_moved: None,
            topology: None,
            is_plain_surface: None,
            sewing: KeptSewing::default(),
            kernel: KernelKind::default(),
            witness: Witness::default(),
            watch: Watch::NOBODY,
            takes_figures: false,
            spares_topology: false,
            aim: Aim::default(),
            applied: Vec::new(),
            records: Vec::new(),
            round: 0,
            removed_faces: Vec::new(),
            created_faces: Vec::new(),
            rounding: None,
            tolerance: 0.0,
            moved: 0.0,
            figures: Vec::new(),
        }
    }

    /// The session computing on another kernel. The result is the same from every kernel that can hold the mesh.
    #[must_use]
    pub fn with_kernel(self, kernel: KernelKind) -> Self {
        // A kernel that can't hold the mesh must say so.
        let topology = self.topology.filter(|_| self.kernel == kernel);
        Session { kernel, topology, ..self }
    }

    /// The session naming another strip of faces where a patch is not orientable.
    #[must_use]
    pub fn with_witness(self, witness: Witness) -> Self {
        let topology = self.topology.filter(|_| self.witness == witness);
        Session { witness, topology, ..self }
    }

    /// The session watched by somebody: told how far it is, pass by pass, and stopped by [`PassError::Cancelled`] if they say so.
    #[must_use]
    pub fn with_watch(self, watch: &Watch) -> Self {
        Session { watch: watch.clone(), ..self }
    }

    /// Who watches the session.
    pub fn watch(&self) -> &Watch {
        &self.watch
    }

    /// The session taking χ, components and boundary loops before and after each pass that changes something.
    #[must_use]
    pub fn with_figures(self) -> Self {
        Session { takes_figures: true, ..self }
    }

    /// The session for somebody who will ask neither for the topology of the result nor how `verify` looked: passes that have
    /// nothing to do on an oriented surface are not begun where the mesh is one, which is
    /// [told](meshmend_core::Complex::is_oriented_surface) in a fraction of the time. The result is the same.
    #[must_use]
    pub fn sparing_topology(self) -> Self {
        Session { spares_topology: true, ..self }
    }

    /// Another session with the same choices, with another mesh and no pass applied yet.
    pub(crate) fn another(&self, stored: &PolygonMesh) -> Session {
        Session {
            kernel: self.kernel,
            witness: self.witness,
            watch: self.watch.clone(),
            takes_figures: self.takes_figures,
            spares_topology: self.spares_topology,
            moved: self.moved,
            aim: self.aim.clone(),
            ..Session::begin(stored)
        }
    }

    /// The session begun anew, with the mesh as stored or as rounding made it.
    pub(crate) fn anew(self, rounded: Option<(PolygonMesh, Rounding)>) -> Self {
        let (stored, rounding) = match rounded {
            Some((mesh, rounding)) => (mesh, Some(rounding)),
            None => (self.stored().clone(), None),
        };
        Session { rounding, moved: 0.0, ..self.another(&stored) }
    }

    /// Applies a pass.
    ///
    /// # Errors
    /// When a policy says so, the kernel can't hold the mesh, or the work was cancelled. The mesh is then as it was.
    pub fn apply(&mut self, pass: impl Into<AnyPass>) -> Result<&PassRecord, PassError> {
        let pass = pass.into();
        let repair = pass.as_pass();
        self.reach_to(repair.tolerance_on(&self.mesh));
        self.context(repair.name()).check_cancelled()?;
        let looked = if repair.looks_at_topology() { Some(self.look()?) } else { None };
        let outcome = repair.apply(&self.mesh, &self.context(repair.name()))?;
        self.record(pass, outcome, looked)
    }

    /// Records a pass as one that found nothing to do.
    pub(crate) fn skip(&mut self, pass: &AnyPass) -> Result<(), PassError> {
        self.record(pass.clone(), Outcome::unchanged(&self.mesh), None).map(|_| ())
    }

    /// Sets what the result is made for. How the mesh is sewn is found out again: other layers may tell faces apart.
    pub(crate) fn aim_at(&mut self, aim: Aim) {
        self.aim = aim;
        self.sewing = KeptSewing::default();
    }

    /// Makes sure that vertices within a tolerance count as joined.
    pub(crate) fn reach_to(&mut self, tolerance: f64) {
        self.tolerance = self.tolerance.max(tolerance);
    }

    /// The topology of the mesh as it is now. It is found out once, and again when a pass has changed the mesh.
    ///
    /// # Errors
    /// When the kernel can't hold the mesh.
    ///
    /// *Cost*: that of [`topology_watched`](meshmend_topology::topology_watched), or constant if it is known.
    pub fn topology(&mut self) -> Result<&TopologyReport, PassError> {
        let known = match self.topology.take() {
            Some(known) => known,
            None => Box::new(topology_on(self.kernel, &self.mesh, self.witness, &self.watch)?),
        };
        Ok(self.topology.insert(known))
    }

    fn look(&mut self) -> Result<Looked, PassError> {
        let looked = if self.topology.is_some() { Looked::Before } else { Looked::Afresh };
        self.topology()?;
        Ok(looked)
    }

    fn context(&self, step: &'static str) -> Context<'_> {
        Context {
            kernel: self.kernel,
            history: Some(self.since_moved.as_ref().unwrap_or(&self.history)),
            watch: Some((&self.watch, step)),
            known: self.topology.as_deref(),
            clearance: Clearance { tolerance: self.tolerance, ..self.aim.clearance },
            telling: self.aim.telling.as_deref().map_or(TellingLayers::All, TellingLayers::Only),
            storage: Some(&self.aim.storage),
            moved: self.moved,
            sewing: Some(&self.sewing),
        }
    }

    /// Takes over what a pass did.
    fn record(
        &mut self,
        pass: AnyPass,
        outcome: Outcome,
        looked: Option<Looked>,
    ) -> Result<&PassRecord, PassError> {
        let kind = pass.kind();
        let is_changed = !outcome.provenance.is_same()
            || !outcome.fixed.is_empty()
            || !outcome.mesh.is_copy_of(&self.mesh);
        if is_changed {
            let removed = self.removed_by(kind, &outcome)?;
            self.removed_faces.extend(removed);
            self.created_faces = created_faces(&self.created_faces, &outcome.provenance, kind);
            self.history = self.history.extended(&outcome.provenance, &outcome.mesh);
            self.since_moved = if may_move(kind) && moves(&self.mesh, &outcome) {
                Some(History::begin(&outcome.mesh))
            } else {
                let since = self.since_moved.take();
                since.map(|since| since.extended(&outcome.provenance, &outcome.mesh))
            };
            self.figures.extend(self.figures());
            self.moved = self.moved.max(outcome.moved);
            self.topology = None;
            // Where a pass had something to do, all are begun.
            self.is_plain_surface = (kind != PassKind::Weld).then_some(false);
        }
        self.mesh = outcome.mesh;
        self.sewing.keep_only_of(&self.mesh);
        self.applied.push(pass);
        self.records.push(PassRecord {
            pass: kind,
            is_changed,
            fixed: outcome.fixed,
            left: outcome.left,
            figures: None,
            seam: outcome.seam,
            loops: outcome.loops,
            t_junctions: outcome.t_junctions,
            slivers: outcome.slivers,
            dropped: outcome.dropped,
            apart: outcome.apart,
            advice: outcome.advice,
            looked,
        });
        Ok(&self.records[self.records.len() - 1])
    }

    /// The mesh as it is now.
    pub fn mesh(&self) -> &PolygonMesh {
        &self.mesh
    }

    /// The mesh as stored.
    pub fn stored(&self) -> &PolygonMesh {
        self.history.stored()
    }

    /// Where each element of the present mesh was as stored.
    pub fn provenance(&self) -> &Provenance {
        self.history.provenance()
    }

    /// What each pass did so far, in order.
    pub fn records(&self) -> &[PassRecord] {
        &self.records
    }

    /// The passes that were applied, in order.
    pub(crate) fn applied(&self) -> &[AnyPass] {
        &self.applied
    }

    pub(crate) fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// What the passes did in the last round.
    pub(crate) fn last_round(&self) -> &[PassRecord] {
        &self.records[self.round..]
    }

    /// Whether faces that repeat others are there because they differ, as far as the last round saw.
    pub(crate) fn has_copies(&self) -> bool {
        let is_copy = |defect: &Defect| defect.kind() == DefectKind::DifferingFace;
        self.last_round().iter().any(|record| record.left.iter().any(is_copy))
    }

    /// Takes over what one more round did to the mesh as it was read again.
    pub(crate) fn follow(&mut self, (read, reading): (&PolygonMesh, &Provenance), next: Session) {
        let history = self.history.extended(reading, read);
        let as_stored = |removed: RemovedFace| {
            Some(RemovedFace { face: history.provenance().faces.of(removed.face)?, ..removed })
        };
        self.removed_faces.extend(next.removed_faces.into_iter().filter_map(as_stored));
        let read_again = carried(&self.created_faces, reading);
        let mut created = carried(&read_again, next.history.provenance());
        created.extend(&next.created_faces);
        created.sort_unstable_by_key(|(face, _)| *face);
        self.created_faces = created;
        self.history = history.extended(next.history.provenance(), &next.mesh);
        self.round = self.records.len();
        self.tolerance = self.tolerance.max(next.tolerance);
        self.moved = next.moved;
        self.records.extend(next.records);
        self.figures.extend(next.figures);
        (self.mesh, self.topology) = (next.mesh, next.topology);
        self.is_plain_surface = Some(false);
    }

    /// The figures of the present mesh, if they are asked for.
    fn figures(&self) -> Option<Figures> {
        let of_mesh = || self.topology.as_deref().map_or_else(|| Figures::of(&self.mesh), Figures::of_report);
        self.takes_figures.then(of_mesh)
    }

    /// Each face of which this pass left nothing, with the defect that names it.
    fn removed_by(&self, pass: PassKind, outcome: &Outcome) -> Result<Vec<RemovedFace>, PassError> {
        let mut reasons: Vec<(FaceId, DefectKind)> = outcome
            .fixed
            .listed()
            .iter()
            .filter_map(|defect| Some((removed_face(pass, defect)?, defect.kind())))
            .collect();
        reasons.sort_unstable();
        let mut differed = outcome.differed.clone();
        differed.sort_unstable();
        let mut removed = Vec::new();
        for face in outcome.provenance.removed_faces() {
            let at = reasons.partition_point(|(named, _)| *named < face);
            let named = reasons.get(at).filter(|(named, _)| *named == face);
            let Some(stored) = self.history.provenance().faces.of(face) else { continue };
            let reason = match named {
                Some((_, kind)) => *kind,
                None if pass.is_own() => return Err(PassError::Unnamed { pass: pass.name(), face }),
                None => DefectKind::DegenerateFace,
            };
            let place = differed.binary_search_by_key(&face, |(named, _)| *named);
            let differed = place.map_or(Differences::default(), |place| differed[place].1);
            removed.push(RemovedFace { face: stored, pass, reason, differed });
        }
        Ok(removed)
    }
}

/// The faces without a source after a change by a pass, when these had none before it.
fn created_faces(
    before: &[(FaceId, PassKind)],
    change: &Provenance,
    pass: PassKind,
) -> Vec<(FaceId, PassKind)> {
    let new = change.faces.iter().filter(|(_, old)| old.is_none()).map(|(face, _)| (face, pass));
    let mut created: Vec<(FaceId, PassKind)> =
        if change.faces.is_same() { Vec::new() } else { new.collect() };
    created.extend(carried(before, change));
    created.sort_unstable_by_key(|(face, _)| *face);
    created
}

/// Some faces with what is said of them, by their ids after a change.
fn carried(faces: &[(FaceId, PassKind)], change: &Provenance) -> Vec<(FaceId, PassKind)> {
    if faces.is_empty() {
        return Vec::new();
    }
    let said = |old: FaceId| faces.binary_search_by_key(&old, |(face, _)| *face).ok().map(|at| faces[at].1);
    change.faces.iter().filter_map(|(face, old)| Some((face, said(old?)?))).collect()
}

/// Whether a pass may put vertices elsewhere than they were.
fn may_move(kind: PassKind) -> bool {
    kind.is_own() || kind == PassKind::KeepApart
}

/// Whether a vertex is elsewhere than it was in the mesh before.
fn moves(before: &PolygonMesh, outcome: &Outcome) -> bool {
    let place = |mesh: &PolygonMesh, vertex: VertexId| mesh.position(vertex).map(f64::to_bits);
    let mut sources = outcome.provenance.vertices.iter();
    sources.any(|(now, was)| was.is_some_and(|was| place(&outcome.mesh, now) != place(before, was)))
}

/// The face that a defect names, if a pass removes faces for this reason.
fn removed_face(pass: PassKind, defect: &Defect) -> Option<FaceId> {
    let is_reason = matches!(
        defect.kind,
        DefectKind::DegenerateFace
            | DefectKind::NonFiniteFace
            | DefectKind::DuplicateFace
            | DefectKind::OppositeFace
            | DefectKind::SmallComponent
            | DefectKind::InternalFace
            | DefectKind::SliverFace
            | DefectKind::ZeroAreaFace
    );
    if is_reason || pass.is_own() { defect.at.face() } else { None }
}
