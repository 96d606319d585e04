//! What every repair is: a function from a mesh to a mesh and a record of what it did.

use std::any::Any;
use std::borrow::Cow;
use std::fmt;

use meshmend_core::{
    Cancelled, Connectivity, Defect, DefectKind, Differences, DraftError, FaceId, FaceTableError,
    PolygonMesh, Provenance, Refusal, Watch,
};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_spatial::SurfaceError;
use meshmend_topology::{TopologyReport, Witness, topology_watched};
use thiserror::Error;

use crate::sewing::KeptSewing;
use crate::{
    Advice, ApartRecord, Clearance, DropRecord, Emptied, FaceStorage, Fixed, LoopRecord, PassKind,
    SeamFigures, SliverRecord, TJunctionRecord, TellingLayers,
};

/// A repair. The pass *is* its options: fill its fields, or take its `Default`.
pub trait Pass: Any + fmt::Debug + Send + Sync {
    /// Which pass it is. A pass of another crate gives [`PassKind::Own`] with its row.
    fn kind(&self) -> PassKind;
    /// What the pass is called in plans, reports and on the command line.
    fn name(&self) -> &'static str {
        self.kind().name()
    }
    /// What is gone afterwards.
    fn removes(&self) -> &'static [DefectKind] {
        &[]
    }
    /// What must be gone before, for the pass to keep its promise.
    fn requires(&self) -> &'static [DefectKind] {
        &[]
    }
    /// What may be there afterwards though it was not before.
    fn may_introduce(&self) -> &'static [DefectKind];
    /// Whether the pass uses the topology of the mesh, so that the session finds it out before and keeps it.
    fn looks_at_topology(&self) -> bool {
        false
    }
    /// Whether the pass finds nothing to do in what it has made. Only such passes run again where a pipeline goes on in rounds
    /// until a second run would change nothing; any other pass of another crate runs once.
    fn is_idempotent(&self) -> bool {
        !self.kind().is_own()
    }
    /// How far apart vertices of a mesh may be that the pass joins.
    fn tolerance_on(&self, mesh: &PolygonMesh) -> f64 {
        let _ = mesh;
        0.0
    }
    /// Mends the mesh.
    ///
    /// # Errors
    /// When a policy says so, the kernel can't hold the mesh, or the work was cancelled.
    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError>;
}

/// What a pass gives back. Ids in `fixed` are the old mesh's, those in `left` the new one's.
#[must_use]
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The mesh as it is now.
    pub mesh: PolygonMesh,
    /// Where each of its elements came from.
    pub provenance: Provenance,
    /// What was wrong and no longer is, by ids of the mesh before.
    pub fixed: Fixed,
    /// What the pass saw and left alone, by ids of the mesh after.
    pub left: Vec<Defect>,
    /// What cutting non-orientable patches open took, where the pass did.
    pub seam: Option<SeamFigures>,
    /// The faces that went as repeats of others although they differ from them, by ids of the mesh before.
    pub differed: Vec<(FaceId, Differences)>,
    /// What became of each boundary loop, where the pass judged them, by lowest vertex.
    pub loops: Vec<LoopRecord>,
    /// What became of each vertex on an open edge, where the pass judged them, by vertex and ends.
    pub t_junctions: Vec<TJunctionRecord>,
    /// The steps that were made for slivers, in order, and then the slivers that are left, where the pass mends them.
    pub slivers: Vec<SliverRecord>,
    /// How far a vertex is at most from one, as stored, that the pass had go into it.
    pub moved: f64,
    /// What was dropped, where the pass drops parts.
    pub dropped: Option<DropRecord>,
    /// What became of the vertices at places of others, where the pass keeps these apart.
    pub apart: Vec<ApartRecord>,
    /// Which tolerance stood out, where the pass looked for one.
    pub advice: Option<Advice>,
}

impl Outcome {
    /// The outcome of a pass that made a new mesh, where each of its elements came from, and what that fixed.
    /// [`PolygonMesh::rebuild`] gives the first two.
    pub fn changed((mesh, provenance): (PolygonMesh, Provenance), fixed: impl Into<Fixed>) -> Self {
        Outcome { provenance, fixed: fixed.into(), ..Outcome::unchanged(&mesh) }
    }

    /// The outcome of a pass that had nothing to do. *Cost*: O(1).
    pub fn unchanged(mesh: &PolygonMesh) -> Self {
        Outcome {
            provenance: Provenance::same(mesh.counts()),
            mesh: mesh.clone(),
            fixed: Fixed::default(),
            left: Vec::new(),
            seam: None,
            differed: Vec::new(),
            loops: Vec::new(),
            t_junctions: Vec::new(),
            slivers: Vec::new(),
            moved: 0.0,
            dropped: None,
            apart: Vec::new(),
            advice: None,
        }
    }
}

/// Why a pass gave no mesh.
#[derive(Clone, Debug, Error)]
pub enum PassError {
    /// The kernel that was asked for can't hold the mesh.
    #[error(transparent)]
    Refused(#[from] Refusal),
    /// A policy of the pass says that such a mesh is not to be repaired.
    #[error("{pass}: the policy is `fail`, and the mesh has {}: {}{}", kind.title(), defects.len(), Named(defects.first()))]
    Policy {
        /// The pass.
        pass: &'static str,
        /// What it found.
        kind: DefectKind,
        /// Where; never empty.
        defects: Vec<Defect>,
    },
    /// An option has no meaning for this mesh.
    #[error("{pass}: {reason}")]
    Request {
        /// The pass.
        pass: &'static str,
        /// What is wrong with the option.
        reason: String,
    },
    /// No face would be left of a mesh that has some.
    #[error(transparent)]
    Emptied(#[from] Emptied),
    /// Whoever watches the work asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A postcondition does not hold: a mistake of this program.
    #[error("{pass} broke its promise, which is a mistake of this program: {defect}")]
    Promise {
        /// The pass.
        pass: &'static str,
        /// What should not be there.
        defect: Defect,
    },
    /// A pass of another crate removed a face and did not say why.
    #[error("{pass} removed {face} and fixed no defect of it")]
    Unnamed {
        /// The pass.
        pass: &'static str,
        /// The face, by its id before the pass.
        face: FaceId,
    },
    /// The result would have more elements than a mesh holds.
    #[error(transparent)]
    Table(#[from] FaceTableError),
    /// A pass described a mesh that can't be: a mistake of this program.
    #[error(transparent)]
    Draft(#[from] DraftError),
}

impl From<SurfaceError> for PassError {
    fn from(error: SurfaceError) -> Self {
        match error {
            SurfaceError::Table(error) => error.into(),
            SurfaceError::Cancelled(cancelled) => cancelled.into(),
        }
    }
}

/// A defect in brackets, if there is one.
struct Named<'a>(Option<&'a Defect>);

impl std::fmt::Display for Named<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.map_or(Ok(()), |defect| write!(f, " ({defect})"))
    }
}

/// What a pass needs to know beside the mesh and its own options. The default is that of a pass that runs alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct Context<'a> {
    pub(crate) kernel: KernelKind,
    /// What was done to the mesh before, if it is not as stored.
    pub(crate) history: Option<&'a History>,
    /// Who watches the work, and what it is called to them.
    pub(crate) watch: Option<(&'a Watch, &'static str)>,
    /// The topology of the mesh, if it is known already. Only a session knows it.
    pub(crate) known: Option<&'a TopologyReport>,
    /// What created vertices keep clear of.
    pub(crate) clearance: Clearance,
    /// Which attribute layers tell a face from another one over the same vertices.
    pub(crate) telling: TellingLayers<'a>,
    /// How the result will be stored, if not by the vertices that faces share.
    pub(crate) storage: Option<&'a FaceStorage>,
    /// How far a vertex is at most from one that went into it before.
    pub(crate) moved: f64,
    /// Where the sewing of a mesh is kept for the next pass.
    pub(crate) sewing: Option<&'a KeptSewing>,
}

impl<'a> Context<'a> {
    /// The context with this kernel to compute on.
    pub fn with_kernel(self, kernel: KernelKind) -> Self {
        Context { kernel, ..self }
    }

    /// The context of a mesh to which this was done before.
    pub fn with_history(self, history: &'a History) -> Self {
        Context { history: Some(history), ..self }
    }

    /// The context with this for created vertices to keep clear of.
    pub fn with_clearance(self, clearance: Clearance) -> Self {
        Context { clearance, ..self }
    }

    /// The context of a mesh whose vertices are up to so far from vertices that went into them before, beside what the history
    /// says.
    pub fn with_moved(self, moved: f64) -> Self {
        Context { moved, ..self }
    }

    /// The kernel to compute on.
    pub fn kernel(&self) -> KernelKind {
        self.kernel
    }

    /// What was done to the mesh before, if it is not as stored.
    pub fn history(&self) -> Option<&'a History> {
        self.history
    }

    /// The topology of the mesh that the pass is applied to.
    ///
    /// # Errors
    /// When the kernel can't hold the mesh.
    ///
    /// *Cost*: constant if a session knows it, else that of [`topology`](meshmend_topology::topology).
    pub fn topology(&self, mesh: &PolygonMesh) -> Result<Cow<'a, TopologyReport>, PassError> {
        match self.known {
            Some(known) => Ok(Cow::Borrowed(known)),
            None => Ok(Cow::Owned(topology_on(self.kernel, mesh, Witness::default(), self.watch())?)),
        }
    }

    /// The context of work that somebody watches.
    pub fn with_watch(self, watch: &'a Watch, step: &'static str) -> Self {
        Context { watch: Some((watch, step)), ..self }
    }

    /// Who watches the work.
    pub fn watch(&self) -> &'a Watch {
        const NOBODY: &Watch = &Watch::NOBODY;
        self.watch.map_or(NOBODY, |(watch, _)| watch)
    }

    /// Fails when the caller has asked to stop. Passes call it between their steps.
    ///
    /// # Errors
    /// [`PassError::Cancelled`].
    pub fn check_cancelled(&self) -> Result<(), PassError> {
        self.look(0, 0)
    }

    /// Says how far the pass is, and fails when the caller has asked to stop. Passes call it within long steps, at least every
    /// [`ITEMS_BETWEEN_LOOKS`](meshmend_core::ITEMS_BETWEEN_LOOKS) elements.
    ///
    /// # Errors
    /// [`PassError::Cancelled`].
    pub fn look(&self, done: usize, total: usize) -> Result<(), PassError> {
        match self.watch {
            Some((watch, step)) => Ok(watch.look(step, done, total)?),
            None => Ok(()),
        }
    }
}

/// The topology of a mesh as a kernel gives it.
pub(crate) fn topology_on(
    kernel: KernelKind,
    mesh: &PolygonMesh,
    witness: Witness,
    watch: &Watch,
) -> Result<TopologyReport, PassError> {
    watch.look("topology", 0, 0)?;
    let complex = mesh.complex();
    watch.look("topology", 0, 0)?;
    Ok(kernel.run(complex, Analyse { mesh, witness, watch })??)
}

struct Analyse<'a> {
    mesh: &'a PolygonMesh,
    witness: Witness,
    watch: &'a Watch,
}

impl KernelTask for Analyse<'_> {
    type Output = Result<TopologyReport, Cancelled>;
    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        topology_watched(kernel, self.mesh, self.witness, self.watch)
    }
}

/// The mesh as stored and all that was done to it since.
#[derive(Clone, Debug)]
pub struct History {
    stored: PolygonMesh,
    provenance: Provenance,
}

impl History {
    /// The history of a mesh to which no pass was applied yet.
    pub fn begin(stored: &PolygonMesh) -> Self {
        History { stored: stored.clone(), provenance: Provenance::same(stored.counts()) }
    }

    /// The mesh as stored.
    pub fn stored(&self) -> &PolygonMesh {
        &self.stored
    }

    /// Where each element of the present mesh was as stored.
    pub fn provenance(&self) -> &Provenance {
        &self.provenance
    }

    /// The history after one more pass.
    pub fn extended(&self, later: &Provenance, result: &PolygonMesh) -> Self {
        let provenance = self.provenance.then(later, self.stored.faces(), result.faces());
        History { stored: self.stored.clone(), provenance }
    }
}
