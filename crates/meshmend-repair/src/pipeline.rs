//! Passes one after another, with one record of all that was done.

mod rounds;
mod run;
mod storage;

use std::sync::atomic::AtomicBool;

use meshmend_core::{Defect, DefectKind, Differences, FaceId, PolygonMesh, Provenance};
use meshmend_geometry::rounding::{Rounding, in_single_precision};
use meshmend_kernels::KernelKind;
use meshmend_topology::{TopologyReport, Witness};

use self::run::Run;
pub use self::storage::{FaceStorage, Writing};
use crate::figures::Figures;
use crate::{
    AnyPass, Clearance, Compact, Context, Distance, Emptied, Emptying, Examined, Fixed, NonOrientable,
    Orient, Outcome, PassError, PassKind, Precision, Repeated, SeamFigures, Seams, Side, Subdivision,
    TellingLayers, Unused, Weld,
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
    passes: Vec<AnyPass>,
    kernel: KernelKind,
    takes_figures: bool,
    precision: Precision,
    faces: FaceStorage,
    emptying: Emptying,
    held_layers: Option<Vec<bool>>,
}

impl Default for Pipeline {
    /// weld → clean → orient → split → triangulate → compact → recompute, each with its defaults.
    fn default() -> Self {
        Pipeline::new(PassKind::ALL.iter().map(|kind| kind.with_defaults()))
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
    /// How many stored normals turned with their faces: one a corner, or one a face where they are those of faces.
    pub turned_normals: usize,
    /// What rounding all positions did before the first pass, where the result's precision made it necessary.
    pub rounding: Option<Rounding>,
    /// The topology of the result, if the last pass was `recompute`.
    pub report: Option<Box<TopologyReport>>,
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
        let mut oriented: Option<Orient> = None;
        let mut all = Vec::new();
        let mut given = passes.into_iter().peekable();
        while let Some(mut pass) = given.next() {
            match (&mut pass, &oriented) {
                (AnyPass::Orient(orient), _) => oriented = Some(orient.clone()),
                (AnyPass::Split(split), Some(orient)) if orient.non_orientable == NonOrientable::Cut => {
                    split.seams = Seams::Cut;
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
        Pipeline {
            passes: all,
            kernel: KernelKind::default(),
            takes_figures: false,
            precision: Precision::Double,
            faces: FaceStorage::default(),
            emptying: Emptying::default(),
            held_layers: None,
        }
    }

    /// The pipeline computing on another kernel. The result is the same from every kernel that can hold the mesh.
    pub fn on_kernel(self, kernel: KernelKind) -> Self {
        Pipeline { kernel, ..self }
    }

    /// The pipeline taking χ, components and boundary loops before and after each pass that changes something.
    pub fn with_figures(self) -> Self {
        Pipeline { takes_figures: true, ..self }
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
    /// does. Faces that repeat others are told apart by those layers only, since they would be plain repeats to whoever
    /// reads the output.
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
    /// When a policy says so, the kernel can't hold the mesh, or no face would be left of it.
    pub fn run(&self, mesh: &PolygonMesh) -> Result<Repaired, PassError> {
        self.run_watched(mesh, None, |_| {})
    }

    /// Repairs a mesh, telling `observe` which pass begins; stops when another thread sets `cancel`.
    ///
    /// # Errors
    /// As [`run`](Self::run), and when cancelled.
    pub fn run_watched(
        &self,
        mesh: &PolygonMesh,
        cancel: Option<&AtomicBool>,
        observe: impl FnMut(PassKind),
    ) -> Result<Repaired, PassError> {
        let run = match self.rounded(mesh) {
            Some((mesh, rounding)) => Run::begin(&mesh, self.takes_figures).after_rounding(rounding),
            None => Run::begin(mesh, self.takes_figures),
        };
        self.run_all(&self.passes, run, cancel, observe)
    }

    /// Repairs a mesh that was looked at before, as [`run_watched`](Self::run_watched) does. What was found out then and is
    /// needed again is not found out again: the weld, if it is the first pass, and the topology of what it left.
    ///
    /// # Errors
    /// As [`run_watched`](Self::run_watched).
    pub fn run_examined(
        &self,
        examined: Examined,
        cancel: Option<&AtomicBool>,
        mut observe: impl FnMut(PassKind),
    ) -> Result<Repaired, PassError> {
        if self.rounded(&examined.stored).is_some() {
            return self.run_watched(&examined.stored, cancel, observe);
        }
        let Examined { stored, mesh, weld, kernel, report } = examined;
        let known = (kernel == self.kernel && report.witness == Witness::default()).then_some(report);
        let (mut run, mut passes) = (Run::begin(&stored, self.takes_figures), self.passes.as_slice());
        match (weld, self.passes.split_first()) {
            (None, _) => (run.mesh, run.known) = (mesh, known),
            _ if stored.counts().faces == 0 => {}
            (Some((weld, outcome)), Some((AnyPass::Weld(first), rest))) if *first == weld => {
                observe(PassKind::Weld);
                run.tolerance = weld.tolerance_on(&stored);
                run.record(PassKind::Weld, Outcome { mesh, ..outcome });
                (run.known, passes) = (known, rest);
            }
            _ => {}
        }
        self.run_all(passes, run, cancel, observe)
    }

    fn run_all(
        &self,
        passes: &[AnyPass],
        mut run: Run,
        cancel: Option<&AtomicBool>,
        observe: impl FnMut(PassKind),
    ) -> Result<Repaired, PassError> {
        let stored = run.stored().clone();
        let has_faces = stored.counts().faces > 0;
        self.run_round(passes, &mut run, cancel, observe)?;
        let run = self.settled(run, cancel)?;
        if has_faces {
            self.check_promises(&run)?;
        }
        let repaired = run.finish(&self.faces)?;
        if has_faces && repaired.mesh.counts().faces == 0 && self.emptying == Emptying::Refuse {
            return Err(Emptied::by(&self.passes, &stored, &repaired).into());
        }
        Ok(repaired)
    }

    fn run_round<'a>(
        &self,
        passes: impl IntoIterator<Item = &'a AnyPass>,
        run: &mut Run,
        cancel: Option<&AtomicBool>,
        mut observe: impl FnMut(PassKind),
    ) -> Result<(), PassError> {
        let telling = self.telling();
        let has_faces = run.stored().counts().faces > 0;
        run.tolerance = run.tolerance.max(self.tolerance_after_split(&run.mesh));
        for pass in passes {
            observe(pass.kind());
            if let AnyPass::Weld(weld) = pass {
                run.tolerance = run.tolerance.max(weld.tolerance_on(&run.mesh));
            }
            let report = run.known.as_ref();
            let clearance = self.clearance(run.tolerance);
            let history = Some(&run.history);
            let storage = Some(&self.faces);
            let context =
                Context { kernel: self.kernel, history, cancel, report, clearance, telling, storage };
            context.check_cancelled()?;
            let outcome = if has_faces || pass.kind() == PassKind::Recompute {
                pass.as_pass().apply(&run.mesh, &context)?
            } else {
                Outcome::unchanged(&run.mesh)
            };
            run.record(pass.kind(), outcome);
        }
        Ok(())
    }

    /// Which layers tell apart faces that repeat others.
    fn telling(&self) -> TellingLayers<'_> {
        let drops =
            |pass: &AnyPass| matches!(pass, AnyPass::Clean(clean) if clean.repeated == Repeated::Drop);
        if self.passes.iter().any(drops) {
            return TellingLayers::Only(&[]);
        }
        self.held_layers.as_deref().map_or(TellingLayers::All, TellingLayers::Only)
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

    /// Fails when `recompute` ended the pipeline and found what a pass had promised to remove.
    fn check_promises(&self, run: &Run) -> Result<(), PassError> {
        let Some(report) = &run.report else { return Ok(()) };
        let mut promised: Vec<DefectKind> = Vec::new();
        for pass in &self.passes {
            let pass = pass.as_pass();
            let is_bound = pass.requires().iter().all(|kind| promised.contains(kind));
            promised.retain(|kind| !pass.may_introduce().contains(kind));
            if is_bound {
                promised.extend(pass.removes());
            }
        }
        for kind in promised {
            // Copies of a face that differ run the same way along an edge until `split` takes them apart.
            let is_named = |defect: &Defect| {
                matches!(defect.kind(), DefectKind::NonOrientablePatch | DefectKind::DifferingFace)
            };
            let is_twisted = report.non_orientable_patches > 0
                || run.passes.iter().any(|record| record.left.iter().any(is_named));
            if kind == DefectKind::InconsistentEdge && is_twisted {
                continue;
            }
            if let Some(defect) = report.defects.of_kind(kind).next() {
                return Err(PassError::Promise { pass: "the pipeline", defect });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{Connectivity, Draft, EdgeUse, FaceTable, MAX_CORNERS, Sources};
    use meshmend_testkit::{Soup, assert_every_variant, shapes};
    use meshmend_topology::topology;

    use super::*;
    use crate::{NonFinite, Plan};

    fn failure(pipeline: &Pipeline, soup: &Soup) -> PassError {
        pipeline.run(&soup.mesh()).unwrap_err()
    }

    /// The failure of a pipeline whose passes left everything as it was.
    fn promise_of_the_lazy(pipeline: &Pipeline, soup: &Soup) -> Option<PassError> {
        let mesh = soup.mesh();
        let mut run = Run::begin(&mesh, false);
        run.report = Some(Box::new(topology(&EdgeUse::assemble(mesh.complex()), &mesh)));
        pipeline.check_promises(&run).err()
    }

    #[test]
    fn every_failure_says_which_pass_and_why() {
        let plan = |change: fn(&mut Plan)| {
            let mut plan = Plan::default();
            change(&mut plan);
            plan.pipeline()
        };
        let strict = Pipeline::default().on_kernel(KernelKind::HalfEdge);
        let no_distance = plan(|plan| plan.weld.distance = Distance::Absolute(-1.0));
        let no_infinity = plan(|plan| plan.clean.non_finite = NonFinite::Fail);
        let no_band = plan(|plan| plan.orient.non_orientable = NonOrientable::Fail);
        let triangle = Soup::generic(3, [[0, 1, 2]]);
        let mut infinite = triangle.clone();
        infinite.positions[2] = [f64::INFINITY; 3];
        let (mesh, stop) = (triangle.mesh(), AtomicBool::new(true));
        let wrong = Draft::of_faces(&mesh, mesh.faces().clone(), Sources::same(1), Sources::same(2));
        let cases = vec![
            (
                failure(&strict, &shapes::two_tetrahedra_on_a_vertex().soup),
                "the half-edge kernel can't hold this mesh: pinched vertices: 1 (v0 joins 2 umbrellas)",
            ),
            (
                failure(&no_infinity, &infinite),
                "clean: the policy is `fail`, and the mesh has faces with non-finite corners: 1 \
                 (f0 uses v2, which is not finite)",
            ),
            (
                failure(&no_band, &shapes::moebius_band(6, 1, shapes::Tiles::Quads).soup),
                "orient: the policy is `fail`, and the mesh has non-orientable patches: 1 \
                 (a strip of 6 faces from f0 comes back reversed)",
            ),
            (
                failure(&no_distance, &triangle),
                "weld: a tolerance must be a finite number of 0 or more, not -1",
            ),
            (
                failure(&Pipeline::default(), &infinite),
                "the repair would remove the only face: faces with non-finite corners: 1, because of \
                 --non-finite drop",
            ),
            (Pipeline::default().run_watched(&mesh, Some(&stop), |_| {}).unwrap_err(), "cancelled"),
            (
                promise_of_the_lazy(&Pipeline::default(), &shapes::book(3).soup).unwrap(),
                "the pipeline broke its promise, which is a mistake of this program: e0 v0-v1 has 3 sides",
            ),
            (
                FaceTable::triangles(MAX_CORNERS, Vec::new()).unwrap_err().into(),
                "2147483648 vertices are more than the 2147483648 that a table holds",
            ),
            (mesh.rebuild(wrong).unwrap_err().into(), "a draft has 2 corner sources, but needs 3"),
        ];
        assert_every_variant!(
            cases,
            PassError { Refused, Policy, Request, Emptied, Cancelled, Promise, Table, Draft }
        );
    }

    #[test]
    fn sides_that_clash_are_a_broken_promise_where_there_is_a_consistent_side() {
        let pipeline = Plan::default().without(PassKind::Split).pipeline();
        let clashing = promise_of_the_lazy(&pipeline, &Soup::generic(4, [[0, 1, 2], [1, 2, 3]]));
        let is_named = matches!(&clashing, Some(PassError::Promise { defect, .. }) if defect.kind == DefectKind::InconsistentEdge);
        assert!(is_named, "{clashing:?}");
        let band = shapes::moebius_band(6, 1, shapes::Tiles::Quads).soup;
        assert!(promise_of_the_lazy(&pipeline, &band).is_none());
    }
}
