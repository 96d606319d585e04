//! Passes one after another, with one record of all that was done.

mod rounds;
mod storage;
#[cfg(test)]
mod tests;

use meshmend_core::{Defect, DefectKind, Differences, FaceId, FlippedNormals, PolygonMesh, Provenance};
use meshmend_geometry::rounding::{Rounding, in_single_precision};
use meshmend_topology::TopologyReport;

pub use self::storage::{FaceStorage, Writing};
use crate::figures::Figures;
use crate::session::Aim;
use crate::{
    Advice, AnyPass, ApartRecord, Clearance, Compact, Distance, DropRecord, Emptied, Emptying, Fixed, Heal,
    Looked, LoopRecord, NonOrientable, Orient, Pass, PassError, PassKind, Plan, Precision, Repeated,
    SeamFigures, Seams, Session, Side, SliverRecord, Subdivision, TJunctionRecord, Unused, Weld,
};

/// Passes in order, with their options.
///
/// ```
/// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// # use meshmend_repair::Pipeline;
/// // Two triangles that share an edge by position only, one of them the wrong way round.
/// let positions = [[0, 0], [1, 0], [0, 1], [1, 0], [0, 1], [1, 1]].map(|[x, y]| [x.into(), y.into(), 0.0]);
/// let faces = FaceTable::triangles(6, (0..6).map(VertexId).collect())?;
/// let mesh = PolygonMesh::new(positions.to_vec(), faces)?;
/// let repaired = Pipeline::default().run(&mesh)?;
/// assert_eq!(repaired.mesh.positions().len(), 4);
/// assert_eq!(repaired.provenance.flipped.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Pipeline {
    /// The passes as they were given.
    given: Vec<AnyPass>,
    /// The passes as they run.
    passes: Vec<AnyPass>,
    precision: Precision,
    faces: FaceStorage,
    emptying: Emptying,
    held_layers: Option<Vec<bool>>,
}

impl Default for Pipeline {
    /// weld → clean → orient → split → triangulate → compact → verify, each with its defaults.
    fn default() -> Self {
        Plan::default().pipeline()
    }
}

/// What a pipeline gives back.
#[derive(Clone, Debug)]
pub struct Repaired {
    /// The mesh as it is now.
    pub mesh: PolygonMesh,
    /// Where each of its elements was as stored.
    pub provenance: Provenance,
    /// What each pass did, in order.
    pub passes: Vec<PassRecord>,
    /// Each stored face of which nothing is left, with the reason, ascending.
    pub removed_faces: Vec<RemovedFace>,
    /// Each face of the result that has no source, with the pass that created it, ascending.
    pub created_faces: Vec<(FaceId, PassKind)>,
    /// How many stored normals turned with their faces: one a corner, or one a face where they are those of faces.
    pub turned_normals: usize,
    /// What rounding all positions did before the first pass, where the result's precision made it necessary.
    pub rounding: Option<Rounding>,
    /// The topology of the result, if that was looked at, as `verify` does.
    pub topology: Option<Box<TopologyReport>>,
    /// How many vertices were joined to others and are apart again in the result, each in its own place: that is no
    /// change.
    pub stitched: usize,
}

/// A stored face of which nothing is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RemovedFace {
    /// Its id as stored.
    pub face: FaceId,
    /// The pass that removed it.
    pub pass: PassKind,
    /// Why.
    pub reason: DefectKind,
    /// In what it differed from the face that it repeated, if that is why.
    pub differed: Differences,
}

/// What one pass of a pipeline did.
#[derive(Clone, Debug)]
pub struct PassRecord {
    /// The pass.
    pub pass: PassKind,
    /// Whether it changed anything.
    pub is_changed: bool,
    /// What was wrong and no longer is, by ids of the mesh before this pass.
    pub fixed: Fixed,
    /// What it left alone, by ids of the mesh after it.
    pub left: Vec<Defect>,
    /// χ, components and boundary loops before and after, if asked for.
    pub figures: Option<[Figures; 2]>,
    /// What cutting non-orientable patches open took, where it did.
    pub seam: Option<SeamFigures>,
    /// What became of each boundary loop, where the pass judged them, by lowest vertex.
    pub loops: Vec<LoopRecord>,
    /// What became of each vertex on an open edge, where the pass judged them, by vertex and ends.
    pub t_junctions: Vec<TJunctionRecord>,
    /// The steps that were made for slivers, in order, and then the slivers that are left, where the pass mends them.
    pub slivers: Vec<SliverRecord>,
    /// What was dropped, where the pass drops parts.
    pub dropped: Option<DropRecord>,
    /// What became of the vertices at places of others, where the pass keeps these apart.
    pub apart: Vec<ApartRecord>,
    /// Which weld tolerance stood out, where the pass looked for one.
    pub advice: Option<Advice>,
    /// How the pass came to know the topology of the mesh, if it uses that.
    pub looked: Option<Looked>,
}

impl Repaired {
    /// Whether what is written differs from what was read, apart from the format.
    pub fn is_changed(&self) -> bool {
        self.rounding.is_some() || self.passes.iter().any(|pass| pass.is_changed)
    }
}

impl Pipeline {
    /// A pipeline of these passes, in this order.
    ///
    /// Where `orient` cuts non-orientable patches, a later `split` opens the seams. Where it turns closed patches
    /// outward, it runs once more after `split`, which may have closed patches that were open.
    pub fn new(passes: impl IntoIterator<Item = AnyPass>) -> Self {
        let given: Vec<AnyPass> = passes.into_iter().collect();
        Pipeline {
            passes: as_they_run(&given),
            given,
            precision: Precision::Double,
            faces: FaceStorage::default(),
            emptying: Emptying::default(),
            held_layers: None,
        }
    }

    /// The pipeline with one more pass at its end.
    #[must_use]
    pub fn then(mut self, pass: impl Into<AnyPass>) -> Self {
        self.given.push(pass.into());
        Pipeline { passes: as_they_run(&self.given), ..self }
    }

    /// The pipeline with other options for a pass, wherever that runs; or with the pass at its usual place, if it has not run
    /// yet.
    ///
    /// ```
    /// # use meshmend_repair::{Orient, Pipeline, Plan, Side};
    /// let outward = Pipeline::default().with(Orient { side: Side::Outward, ..Orient::default() });
    /// assert_eq!(outward, Plan::from_toml("[orient]\nside = 'outward'")?.pipeline());
    /// # Ok::<(), meshmend_repair::PlanError>(())
    /// ```
    #[must_use]
    pub fn with(mut self, pass: impl Into<AnyPass>) -> Self {
        let pass = pass.into();
        let mut same = self.given.iter_mut().filter(|other| other.kind() == pass.kind()).peekable();
        if same.peek().is_some() {
            same.for_each(|other| *other = pass.clone());
        } else {
            let place = pass.kind().usual_place(self.given.iter().map(AnyPass::kind));
            self.given.insert(place, pass);
        }
        Pipeline { passes: as_they_run(&self.given), ..self }
    }

    /// The pipeline making a result that is stored in this precision. All positions are rounded first, before any pass, so
    /// that what is judged is what will be read; vertices that it creates are rounded, and then put where they are not
    /// rounded onto another one.
    pub fn in_precision(self, precision: Precision) -> Self {
        Pipeline { precision, ..self }
    }

    /// The pipeline making a result whose faces are stored this way: what it leaves is final when it is read again.
    pub fn storing(self, faces: FaceStorage) -> Self {
        Pipeline { faces, ..self }
    }

    /// The pipeline with another way to deal with meshes of which it would leave no face.
    pub fn on_emptying(self, emptying: Emptying) -> Self {
        Pipeline { emptying, ..self }
    }

    /// The pipeline for an output that can hold some of the mesh's attribute layers alone: for each of them whether it
    /// does. Faces that repeat others are told apart by those layers only: to a reader of the output they would be plain
    /// repeats.
    pub fn for_layers(self, held: Vec<bool>) -> Self {
        Pipeline { held_layers: Some(held), ..self }
    }

    /// The passes, in order.
    pub fn passes(&self) -> &[AnyPass] {
        &self.passes
    }

    /// Repairs a mesh.
    ///
    /// A mesh without a face comes out as it went in: its vertices and loose elements are what it is about.
    ///
    /// # Errors
    /// When a policy says so, or no face would be left of the mesh.
    pub fn run(&self, mesh: &PolygonMesh) -> Result<Repaired, PassError> {
        self.run_in(Session::begin(mesh))
    }

    /// Repairs the mesh of a session, with its kernel, telling it which pass begins.
    ///
    /// What the session did to the mesh counts where it is the weld that this pipeline begins with; else the pipeline begins
    /// with the mesh as stored. What the session knows of the topology is not found out again.
    ///
    /// # Errors
    /// As [`run`](Self::run), when the kernel can't hold the mesh, and when cancelled.
    pub fn run_in(&self, mut session: Session) -> Result<Repaired, PassError> {
        let rounded = self.rounded(session.stored());
        let has_faces = session.stored().counts().faces > 0;
        let begun = session.applied().len();
        let is_begun = rounded.is_none()
            && (begun == 0
                || has_faces
                    && matches!(session.applied(), [AnyPass::Weld(_)])
                    && self.passes.starts_with(session.applied()));
        let mut left = self.passes.as_slice();
        if is_begun {
            left = &left[begun..];
        } else {
            session = session.anew(rounded);
        }
        session.aim_at(self.aim());
        self.run_round(left, &mut session)?;
        let session = self.settled(session)?;
        let stored = session.stored().clone();
        let repaired = session.finish()?;
        if has_faces && repaired.mesh.counts().faces == 0 && self.emptying == Emptying::Refuse {
            return Err(Emptied::by(&self.passes, &stored, &repaired).into());
        }
        Ok(repaired)
    }

    fn run_round<'p>(
        &self,
        passes: impl IntoIterator<Item = &'p AnyPass>,
        session: &mut Session,
    ) -> Result<(), PassError> {
        let has_faces = session.stored().counts().faces > 0;
        session.reach_to(self.tolerance_after_split(session.mesh()));
        for pass in passes {
            let is_idle = !has_faces && pass.kind() != PassKind::Verify;
            if is_idle || session.is_spared(pass) {
                session.skip(pass)?;
            } else {
                session.apply(pass.clone())?;
            }
            if let AnyPass::Heal(heal) = pass {
                self.heal_further(heal, session)?;
            }
        }
        Ok(())
    }

    /// Orients what was healed and heals it again, in turn, until one of both changes nothing.
    ///
    /// Faces that are neighbours now may run against each other, and where patches that repeat others go, edges are open anew.
    fn heal_further(&self, heal: &Heal, session: &mut Session) -> Result<(), PassError> {
        let is_orient = |pass: &&AnyPass| pass.kind() == PassKind::Orient;
        let Some(orient) = self.passes.iter().find(is_orient) else { return Ok(()) };
        let has_changed = |session: &Session| session.records().last().is_some_and(|last| last.is_changed);
        while has_changed(session) {
            session.apply(orient.clone())?;
            if has_changed(session) {
                session.apply(heal.clone())?;
            }
        }
        Ok(())
    }

    /// What the result is made for.
    fn aim(&self) -> Aim {
        let drops =
            |pass: &AnyPass| matches!(pass, AnyPass::Clean(clean) if clean.repeated == Repeated::Drop);
        let no_layer = self.passes.iter().any(drops).then(Vec::new);
        Aim {
            clearance: self.clearance(0.0),
            telling: no_layer.or_else(|| self.held_layers.clone()),
            storage: self.faces.clone(),
        }
    }

    /// The mesh in the precision of the result, if it is not in it already.
    fn rounded(&self, mesh: &PolygonMesh) -> Option<(PolygonMesh, Rounding)> {
        match self.precision {
            Precision::Double => None,
            Precision::Single => in_single_precision(mesh),
        }
    }

    /// The passes that weld again what `split` took apart.
    fn welds_after_split(&self) -> impl Iterator<Item = &Weld> {
        let after_split = self.passes.iter().skip_while(|pass| pass.kind() != PassKind::Split);
        after_split.filter_map(|pass| if let AnyPass::Weld(weld) = pass { Some(weld) } else { None })
    }

    /// The largest tolerance within which vertices of a mesh are joined after `split` has created some: 0 in the usual order.
    pub fn tolerance_after_split(&self, mesh: &PolygonMesh) -> f64 {
        self.welds_after_split().map(|weld| weld.tolerance_on(mesh)).fold(0.0, f64::max)
    }

    /// What the vertices that its passes create keep clear of, when vertices within a tolerance were joined.
    pub fn clearance(&self, tolerance: f64) -> Clearance {
        let removes_all =
            |pass: &AnyPass| matches!(pass, AnyPass::Compact(compact) if *compact == Compact::default());
        let unused = if self.passes.iter().any(removes_all) { Unused::Removed } else { Unused::Kept };
        let welds_in_single =
            |pass: &AnyPass| matches!(pass, AnyPass::Weld(weld) if weld.distance == Distance::Single);
        let apart = if self.passes.iter().any(welds_in_single) { Precision::Single } else { self.precision };
        let subdivision = if self.welds_after_split().next().is_some() {
            Subdivision::InOwnPoints
        } else {
            Subdivision::InOnePoint
        };
        Clearance { precision: self.precision, apart, tolerance, unused, subdivision }
    }
}

/// The passes that make of a pipeline what it promises.
fn as_they_run(given: &[AnyPass]) -> Vec<AnyPass> {
    let mut oriented: Option<Orient> = None;
    let mut all = Vec::new();
    let mut given = given.iter().cloned().peekable();
    while let Some(mut pass) = given.next() {
        match (&mut pass, &oriented) {
            (AnyPass::Orient(orient), _) => oriented = Some(orient.clone()),
            (AnyPass::Split(split), Some(orient)) if orient.non_orientable == NonOrientable::Cut => {
                split.seams = Seams::Cut;
            }
            (AnyPass::Outward(outward), Some(orient)) if orient.flipped_normals == FlippedNormals::Keep => {
                outward.flipped_normals = FlippedNormals::Keep;
            }
            _ => {}
        }
        let is_split = pass.kind() == PassKind::Split;
        let is_followed = given.peek().is_some_and(|next| next.kind() == PassKind::Orient);
        all.push(pass);
        if is_split && !is_followed {
            let outward = oriented.clone().filter(|orient| orient.side != Side::Majority);
            all.extend(outward.map(AnyPass::from));
        }
    }
    all
}
