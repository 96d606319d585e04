//! What every repair is: a function from a mesh to a mesh and a record of what it did.

use std::sync::atomic::{AtomicBool, Ordering};

use meshmend_core::{
    Defect, DefectKind, Differences, DraftError, FaceId, FaceTableError, PolygonMesh, Provenance, Refusal,
};
use meshmend_kernels::KernelKind;
use meshmend_topology::TopologyReport;
use thiserror::Error;

use crate::{Clearance, Emptied, FaceStorage, Fixed, SeamFigures, TellingLayers};

/// A repair. The pass *is* its options: fill its fields, or take its `Default`.
pub trait Pass {
    /// What the pass is called in plans, reports and on the command line.
    fn name(&self) -> &'static str;
    /// What is gone afterwards.
    fn removes(&self) -> &'static [DefectKind];
    /// What must be gone before, for the pass to keep its promise.
    fn requires(&self) -> &'static [DefectKind];
    /// What may be there afterwards though it was not before.
    fn may_introduce(&self) -> &'static [DefectKind];
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
    /// The topology of the mesh after, where the pass looked at all of it.
    pub report: Option<Box<TopologyReport>>,
    /// What cutting non-orientable patches open took, where the pass did.
    pub seam: Option<SeamFigures>,
    /// The faces that went as repeats of others although they differ from them, by ids of the mesh before.
    pub differed: Vec<(FaceId, Differences)>,
}

impl Outcome {
    /// The outcome of a pass that made a new mesh.
    pub(crate) fn changed((mesh, provenance): (PolygonMesh, Provenance), fixed: Fixed) -> Self {
        Outcome { mesh, provenance, fixed, left: Vec::new(), report: None, seam: None, differed: Vec::new() }
    }

    /// The outcome of a pass that had nothing to do. *Cost*: O(1).
    pub fn unchanged(mesh: &PolygonMesh) -> Self {
        Outcome {
            provenance: Provenance::same(mesh.counts()),
            mesh: mesh.clone(),
            fixed: Fixed::default(),
            left: Vec::new(),
            report: None,
            seam: None,
            differed: Vec::new(),
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
    /// The caller asked to stop.
    #[error("cancelled")]
    Cancelled,
    /// A postcondition does not hold: a mistake of this program.
    #[error("{pass} broke its promise, which is a mistake of this program: {defect}")]
    Promise {
        /// The pass.
        pass: &'static str,
        /// What should not be there.
        defect: Defect,
    },
    /// The result would have more elements than a mesh holds.
    #[error(transparent)]
    Table(#[from] FaceTableError),
    /// A pass described a mesh that can't be: a mistake of this program.
    #[error(transparent)]
    Draft(#[from] DraftError),
}

/// A defect in brackets, if there is one.
struct Named<'a>(Option<&'a Defect>);

impl std::fmt::Display for Named<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.0.map_or(Ok(()), |defect| write!(f, " ({defect})"))
    }
}

/// What a pass needs to know beside the mesh and its own options.
#[derive(Clone, Copy, Debug, Default)]
pub struct Context<'a> {
    /// The kernel to compute on.
    pub kernel: KernelKind,
    /// What was done to the mesh before, if it is not as stored.
    pub history: Option<&'a History>,
    /// Set by another thread to stop the work.
    pub cancel: Option<&'a AtomicBool>,
    /// The topology of the mesh, if it is known already.
    pub report: Option<&'a TopologyReport>,
    /// What created vertices keep clear of.
    pub clearance: Clearance,
    /// Which attribute layers tell a face from another one over the same vertices.
    pub telling: TellingLayers<'a>,
    /// How the result will be stored, if not by the vertices that faces share.
    pub storage: Option<&'a FaceStorage>,
}

impl Context<'_> {
    /// Fails when the caller has asked to stop. Passes call it between their steps.
    ///
    /// # Errors
    /// [`PassError::Cancelled`].
    pub fn check_cancelled(&self) -> Result<(), PassError> {
        match self.cancel {
            Some(cancel) if cancel.load(Ordering::Relaxed) => Err(PassError::Cancelled),
            _ => Ok(()),
        }
    }
}

/// The mesh as stored and all that was done to it since.
#[derive(Clone, Debug)]
pub struct History {
    stored: PolygonMesh,
    provenance: Provenance,
}

impl History {
    /// The history of a mesh to which nothing was done yet.
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
