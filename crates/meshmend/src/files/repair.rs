//! How a file is repaired.

use meshmend_core::{PolygonMesh, Rules, Watch};
use meshmend_io::{Document, Format, held_layers};
use meshmend_kernels::KernelKind;
use meshmend_repair::{PassKind, Pipeline, Plan, Precision, TriangulateFaces};

use super::judging::Judging;
use super::{FileError, FileTarget, Judged, PartChoice, RepairedFile, WholeChecks};
use crate::{Gate, GeometryOptions};

/// How a file is repaired, and what is said of it.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct FileRepair {
    /// The passes and their policies.
    pub plan: Plan,
    /// Whether the plan cuts polygons for an output that holds only triangles.
    pub cut_polygons: CutPolygons,
    /// The kernel to compute on.
    pub kernel: KernelKind,
    /// Which kinds of defect are looked for.
    pub rules: Rules,
    /// What is asked about where the faces lie, if anything is.
    pub geometry: Option<GeometryOptions>,
    /// Which states of a mesh the report shows.
    pub judged: Judged,
    /// How many items each list of the report shows.
    pub limit: usize,
    /// Whether the checks that the report shows are kept whole beside it.
    pub checks: WholeChecks,
    /// Whether the report says where each element came from.
    pub maps: Maps,
    /// Which parts of the file are repaired.
    pub parts: PartChoice,
    /// What of the result fails the run.
    pub gate: Gate,
}

/// What is done to polygons for an output that holds only triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum CutPolygons {
    /// The pass `triangulate`, which never repeats an edge, is added to the plan and cuts them.
    #[default]
    WhereNeeded,
    /// The plan alone says; what it leaves is cut by the writer.
    AsPlanned,
}

/// Whether a report says where each element came from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Maps {
    /// It does not.
    #[default]
    LeftOut,
    /// It does, for each vertex and face of the result.
    Whole,
}

/// How many items each list of a report shows, if nothing else is said.
const USUAL_LIMIT: usize = 10;

impl Default for FileRepair {
    /// The repair by the default plan.
    fn default() -> Self {
        FileRepair::of(Plan::default())
    }
}

impl FileRepair {
    /// The repair by a plan. For an output that holds only triangles, it cuts polygons as well.
    pub fn of(plan: Plan) -> Self {
        FileRepair {
            plan,
            cut_polygons: CutPolygons::default(),
            kernel: KernelKind::default(),
            rules: Rules::default(),
            geometry: None,
            judged: Judged::default(),
            limit: USUAL_LIMIT,
            checks: WholeChecks::default(),
            maps: Maps::default(),
            parts: PartChoice::default(),
            gate: Gate::default(),
        }
    }

    /// Repairs a file of this name for an output. Without one, nothing is made ready to be written, and the meshes are those
    /// that a format without limits of its own would hold; [`RepairedFile::prepared_for`] makes them ready later.
    ///
    /// # Errors
    /// When a policy says so, a kernel can't hold a mesh, no face would be left, a part that was asked for does not exist, or
    /// the result can't be written as the target says.
    ///
    /// *Cost*: that of the passes; linear beside that.
    pub fn run(
        &self,
        name: &str,
        document: Document,
        target: Option<&FileTarget>,
        watch: &Watch,
    ) -> Result<RepairedFile, FileError> {
        let mut repaired = if self.is_by_parts(&document) {
            RepairedFile::Parts(Box::new(self.run_by_parts(name, document, target, watch)?))
        } else {
            RepairedFile::Mesh(Box::new(self.run_as_one(name, document, target, watch)?))
        };
        repaired.pass_through(&self.gate);
        Ok(repaired)
    }

    /// Whether the parts of a file are repaired each by itself.
    pub fn is_by_parts(&self, document: &Document) -> bool {
        !document.is_whole() || self.parts.by.is_some()
    }

    /// How meshes are judged.
    pub(super) fn judging(&self) -> Judging {
        Judging {
            rules: self.rules,
            limit: self.limit,
            checks: self.checks,
            geometry: self.geometry,
            listed: self.gate.defects(),
        }
    }

    /// The passes of the plan, for what an output can hold.
    pub(super) fn pipeline(&self, mesh: &PolygonMesh, target: Option<&FileTarget>) -> Pipeline {
        let Some(target) = target else { return self.plan.pipeline().in_precision(Precision::Double) };
        let pipeline = self.plan_for(target.options.format).pipeline();
        let held = match target.is_spliced() {
            true => vec![true; mesh.layers().len()],
            false => held_layers(mesh, &target.options),
        };
        pipeline.for_layers(held).in_precision(target.precision()).storing(target.storage())
    }

    /// The plan for an output of a format.
    pub fn plan_for(&self, format: Option<Format>) -> Plan {
        let cuts = self.cut_polygons == CutPolygons::WhereNeeded
            && format.is_some_and(|format| !format.holds_polygons());
        if !cuts {
            return self.plan.clone();
        }
        let mut plan = self.plan.clone().with(PassKind::Triangulate);
        plan.triangulate.faces = TriangulateFaces::All;
        plan
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;
    use std::sync::{Arc, Mutex};

    use meshmend_io::{WriteOptions, read_document_bytes};
    use serde_json::Value;

    use super::*;

    /// A square of two triangles that share no vertex, one of them there twice.
    const SQUARE: &[u8] =
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 5 6\nf 1 2 3\n";
    /// Two solids of a triangle each, of which one is degenerate.
    const SOLIDS: &[u8] = b"o good\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no bad\nf 1 1 2\n";

    fn document(bytes: &[u8]) -> Document {
        read_document_bytes(bytes, "a.obj", &Default::default()).unwrap()
    }

    fn report(repaired: &RepairedFile) -> Value {
        serde_json::from_str(&repaired.report_json().unwrap()).unwrap()
    }

    #[test]
    fn an_output_that_comes_later_holds_the_mesh_and_is_not_in_the_report() {
        let repaired = FileRepair::default().run("a.obj", document(SQUARE), None, &Watch::NOBODY).unwrap();
        assert!(repaired.prepared().is_none() && repaired.is_changed());
        let before = report(&repaired);
        let target = FileTarget::new("a.off", WriteOptions::of(Format::Off));
        let mut bytes = Vec::new();
        repaired.prepared_for(&target).unwrap().encode(&mut bytes).unwrap();
        assert!(bytes.starts_with(b"OFF\n4 2 0\n"), "{}", String::from_utf8_lossy(&bytes));
        assert_eq!((&before["output"], &before), (&Value::Null, &report(&repaired)));
    }

    #[test]
    fn a_report_is_told_again_with_longer_lists_and_maps() {
        for by in [None, Some(crate::files::FaceNames::Object)] {
            let run = |limit, maps, checks| {
                let parts = PartChoice { by, ..PartChoice::default() };
                let repair = FileRepair { limit, maps, checks, parts, ..FileRepair::default() };
                repair.run("a.obj", document(SOLIDS), None, &Watch::NOBODY).unwrap()
            };
            let short = run(0, Maps::LeftOut, WholeChecks::Kept);
            for (limit, maps) in [(0, Maps::LeftOut), (1, Maps::Whole), (usize::MAX, Maps::LeftOut)] {
                let long = run(limit, maps, WholeChecks::Dropped).report_json().unwrap();
                assert_eq!(short.report_json_within(limit, maps).unwrap(), long);
            }
        }
    }

    #[test]
    fn a_rehearsal_names_losses_and_no_output() {
        let target = FileTarget::new("a.stl", WriteOptions::of(Format::Stl));
        let run = |target: FileTarget| {
            let repair = FileRepair::default();
            report(&repair.run("a.obj", document(SQUARE), Some(&target), &Watch::NOBODY).unwrap())
        };
        let (written, rehearsed) = (run(target.clone()), run(target.rehearsed()));
        assert_eq!((&written["output"], &rehearsed["output"]), (&"a.stl".into(), &Value::Null));
        assert_eq!((&written["losses"], &written["passes"]), (&rehearsed["losses"], &rehearsed["passes"]));
    }

    #[test]
    fn polygons_are_cut_for_triangles_unless_the_plan_is_to_be_kept() {
        let mut repair = FileRepair::default();
        assert!(repair.plan_for(Some(Format::Stl)).passes.contains(&PassKind::Triangulate));
        assert_eq!(repair.plan_for(Some(Format::Stl)).triangulate.faces, TriangulateFaces::All);
        assert_eq!((repair.plan_for(Some(Format::Ply)), repair.plan_for(None)), Default::default());
        repair.cut_polygons = CutPolygons::AsPlanned;
        assert_eq!(repair.plan_for(Some(Format::Stl)), Plan::default());
    }

    #[test]
    fn a_part_of_which_no_face_would_be_left_is_given_back_and_all_steps_are_told() {
        let parts = PartChoice::default().taken_apart_by(crate::files::FaceNames::Object);
        let mut repair = FileRepair { parts, ..FileRepair::default() };
        let told = Arc::new(Mutex::new(Vec::new()));
        let parts_told = told.clone();
        let watch = Watch::new(move |at| {
            if at.step == crate::files::PART {
                parts_told.lock().unwrap().push((at.done, at.total));
            }
            ControlFlow::Continue(())
        });
        let repaired = repair.run("a.obj", document(SOLIDS), None, &watch).unwrap();
        let parts = report(&repaired)["parts"].clone();
        assert_eq!((parts[0]["changed"].clone(), parts[1]["given_back"].is_string()), (false.into(), true));
        assert_eq!(*told.lock().unwrap(), [(0, 2), (1, 2)]);
        repair.parts = PartChoice::of(vec!["7".to_owned()]);
        let error = repair.run("a.obj", document(SOLIDS), None, &watch).unwrap_err();
        assert_eq!(error.to_string(), "there is no part `7`; the parts are 0: whole file");
    }
}
