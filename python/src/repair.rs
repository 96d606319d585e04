//! Repairs, and what is known of them.

use std::path::PathBuf;
use std::sync::Arc;

use meshmend::files::{
    CutPolygons, FaceNames, FileError, FileRepair, FileTarget, Judged, Maps, PART, PartChoice, PartOutcome,
    RepairRecord, RepairedFile, RepairedPart, WholeChecks,
};
use meshmend::formats::Shell;
use meshmend::mesh::Watch;
use meshmend::passes::WrittenSeams;
use meshmend::report::json;
use meshmend::{Criterion, Gate, KernelKind, Plan, Rules, Seams, View};
use meshmend_cli::text;
use pyo3::prelude::*;

use crate::check::GeometryWords;
use crate::document::DocumentHandle;
use crate::errors::{self, Done, Problem};
use crate::how::How;
use crate::mesh::{MeshHandle, Origin};
use crate::plan::{self, PlanHandle};
use crate::record::RecordHandle;
use crate::words::{self, WriteWords};

/// How to repair.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct RepairWords<'py> {
    plan: Option<Bound<'py, PlanHandle>>,
    /// Whether the plan was given as one, not as a preset alone.
    is_planned: bool,
    said: Vec<(String, String)>,
    allow_empty: bool,
    kernel: String,
    geometry: GeometryWords,
    report: bool,
    parts: Vec<String>,
    by: Option<String>,
    fail_on: Vec<String>,
    output: Option<(PathBuf, WriteWords)>,
}

/// What was repaired.
pub(crate) enum Mended {
    /// A file, or a part of it.
    File(RepairedFile),
    /// A mesh that is from none.
    Mesh(Box<RepairedPart>),
}

/// A repair.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct RepairHandle {
    mended: Arc<Mended>,
    /// The file that it is from.
    origin: Option<Arc<Origin>>,
}

impl RepairWords<'_> {
    /// The output that it is repaired for, if that is known: what it can hold, and how it stores that.
    fn target(&self, shell: Option<&Shell>) -> Done<Option<FileTarget>> {
        let Some((path, words)) = &self.output else { return Ok(None) };
        let options = words.options(Some(path))?;
        let planned = self.plan.as_ref().and_then(|plan| plan.get().plan.files.seams);
        let options = match planned.and_then(seams) {
            Some((_, seams)) => options.with_seams(seams),
            None => options,
        };
        let options = match shell {
            Some(shell) => options.with_shell(shell.clone()),
            None => options,
        };
        // It is written later, if at all.
        Ok(Some(FileTarget::new(path.display().to_string(), options).rehearsed()))
    }

    fn repair(&self) -> Done<FileRepair> {
        let given = self.plan.as_ref().map(|plan| Plan::clone(&plan.get().plan));
        let cuts = self.is_planned || self.said.iter().any(|(option, _)| option == "triangulate");
        let mut repair =
            FileRepair::of(plan::saying(&given.unwrap_or_default(), &self.said, self.allow_empty)?);
        repair.cut_polygons = if cuts { CutPolygons::AsPlanned } else { CutPolygons::WhereNeeded };
        repair.kernel = kernel(&self.kernel)?;
        let planned = repair.plan.files.clone();
        let words = if self.fail_on.is_empty() { &planned.fail_on } else { &self.fail_on };
        let criteria = words.iter().map(|word| self.criterion(word)).collect::<Done<Vec<_>>>()?;
        repair.gate = Gate::new(criteria);
        repair.limit = planned.limit.unwrap_or(repair.limit);
        repair.geometry = self.geometry.options(&repair.gate.defects())?;
        let is_judged = repair.gate.asks_of_result();
        repair.judged = match (self.report, is_judged) {
            (true, _) => Judged::BeforeAndAfter,
            (false, true) => Judged::After,
            (false, false) => Judged::Neither,
        };
        repair.checks = if self.report { WholeChecks::Kept } else { WholeChecks::Dropped };
        let by = self.by.as_deref().map(face_names).transpose()?;
        repair.parts = PartChoice::of(self.parts.clone()).taken_apart_by(by);
        Ok(repair)
    }
}

impl RepairWords<'_> {
    /// What fails a repair. What is lost is known where the output is.
    fn criterion(&self, word: &str) -> Done<Criterion> {
        match Criterion::of(Rules::builtin(), word) {
            Ok(Criterion::Loss(_)) if self.output.is_none() && !self.fail_on.is_empty() => {
                Err(Problem::Value(format!(
                    "fail_on can't be `{word}` without `output`: `write` tells what is lost, or is `strict`"
                )))
            }
            criterion => criterion.map_err(|error| Problem::Value(error.to_string())),
        }
    }
}

/// How a plan says that vertices are written whose attributes differ from face to face.
pub(crate) fn seams(planned: WrittenSeams) -> Option<(&'static str, Seams)> {
    match planned {
        WrittenSeams::Split => Some(("split", Seams::Split)),
        WrittenSeams::Corners => Some(("corners", Seams::Corners)),
        WrittenSeams::Fail => Some(("fail", Seams::Fail)),
        _ => None,
    }
}

fn kernel(word: &str) -> Done<KernelKind> {
    let known = KernelKind::ALL.iter().map(|kernel| kernel.name());
    KernelKind::from_name(word).ok_or_else(|| words::unknown("the kernel of a repair", word, known))
}

fn face_names(word: &str) -> Done<FaceNames> {
    let known = [FaceNames::Object, FaceNames::Group, FaceNames::Material, FaceNames::Solid];
    words::chosen("by", word, &known.map(|names| (names.name(), names)))
}

/// Repairs a mesh. Of a file that holds more, the rest stays as it is.
#[pyfunction]
pub(crate) fn repair_mesh(
    py: Python<'_>,
    mesh: &Bound<'_, MeshHandle>,
    words: RepairWords<'_>,
    how: How<'_>,
) -> PyResult<RepairHandle> {
    let mut repair = errors::raise(py, words.repair())?;
    let handle = mesh.get();
    let origin = handle.origin.as_ref().map(|(origin, _)| Arc::clone(origin));
    let target = words.target(origin.as_ref().map(|origin| &origin.document.shell));
    let target = errors::raise(py, target)?;
    let mended = how.watched(py)?.run(|watch| -> Done<Mended> {
        let Some((origin, part)) = &handle.origin else {
            let mut repaired = repair.run_mesh(&handle.mesh, View::Indexed, target.as_ref(), watch)?;
            repaired.report.failing = repair.gate.failing(|criterion| repaired.report.count(criterion));
            return Ok(Mended::Mesh(Box::new(repaired)));
        };
        let document = origin.document.clone().with_mesh(*part, handle.mesh.clone());
        if !document.is_whole() {
            repair.parts.parts = vec![part.to_string()];
        }
        Ok(Mended::File(repair.run(&origin.name, document, target.as_ref(), watch)?))
    })?;
    Ok(RepairHandle { mended: Arc::new(errors::raise(py, mended)?), origin })
}

/// Repairs the parts of a file.
#[pyfunction]
pub(crate) fn repair_document(
    py: Python<'_>,
    document: &Bound<'_, DocumentHandle>,
    words: RepairWords<'_>,
    how: How<'_>,
) -> PyResult<RepairHandle> {
    let repair = errors::raise(py, words.repair())?;
    let origin = Arc::clone(&document.get().origin);
    let target = errors::raise(py, words.target(Some(&origin.document.shell)))?;
    let run = |watch: &Watch| repair.run(&origin.name, origin.document.clone(), target.as_ref(), watch);
    let file = how.watched(py)?.run(run)?;
    let file = errors::raise(py, file.map_err(Problem::from))?;
    Ok(RepairHandle { mended: Arc::new(Mended::File(file)), origin: Some(origin) })
}

impl Mended {
    /// What is known of a mesh that was repaired: the only one, or that of an outcome.
    pub(crate) fn record(&self, outcome: usize) -> Option<RepairRecord<'_>> {
        match self {
            Mended::Mesh(part) => Some(part.record()),
            Mended::File(RepairedFile::Mesh(mesh)) => Some(mesh.record()),
            Mended::File(RepairedFile::Parts(parts)) => match &parts.parts.get(outcome)?.1 {
                PartOutcome::Repaired(part) => Some(part.record()),
                _ => None,
            },
        }
    }
}

#[pymethods]
impl RepairHandle {
    fn is_changed(&self) -> bool {
        match &*self.mended {
            Mended::Mesh(part) => part.report.changed,
            Mended::File(file) => file.is_changed(),
        }
    }

    /// What fails it, and how much of each there is.
    fn failing(&self) -> Vec<(String, u64)> {
        let failing = match &*self.mended {
            Mended::Mesh(part) => &part.report.failing[..],
            Mended::File(file) => file.failing(),
        };
        failing.iter().map(|failing| (failing.criterion.to_string(), failing.count)).collect()
    }

    /// The document of the command, with at most so many items in each list.
    fn json(&self, py: Python<'_>, limit: Option<usize>, with_maps: bool) -> PyResult<String> {
        let limit = limit.unwrap_or(usize::MAX);
        let maps = if with_maps { Maps::Whole } else { Maps::LeftOut };
        let text = py.detach(|| match &*self.mended {
            Mended::Mesh(part) => json(&part.record().document(limit, maps)),
            Mended::File(file) => file.report_json_within(limit, maps),
        });
        errors::written(py, text)
    }

    /// What the command prints for people.
    fn text(&self) -> String {
        match &*self.mended {
            Mended::Mesh(part) => text::repair(&part.report),
            Mended::File(file) => text::repaired(file),
        }
    }

    /// Of each part that was worked on its number, what reports call it, and why it was not repaired, if it was not. None for
    /// what is one mesh.
    fn outcomes(&self) -> Option<Vec<(usize, String, Option<String>)>> {
        let Mended::File(RepairedFile::Parts(parts)) = &*self.mended else { return None };
        let told = |(number, outcome): &(usize, PartOutcome)| {
            let title = parts.document.parts.get(*number).map(meshmend::formats::Part::title);
            let reason = match outcome {
                PartOutcome::Repaired(_) => None,
                PartOutcome::Sealed(reason) | PartOutcome::GivenBack(reason) => Some(reason.clone()),
            };
            (*number, title.unwrap_or_else(|| format!("{PART} {number}")), reason)
        };
        Some(parts.parts.iter().map(told).collect())
    }

    /// The file as it is now, if its parts were repaired each by itself.
    fn document(&self) -> Option<DocumentHandle> {
        let Mended::File(RepairedFile::Parts(parts)) = &*self.mended else { return None };
        let origin = Origin { name: parts.name.clone(), document: parts.written().clone() };
        Some(DocumentHandle { origin: Arc::new(origin) })
    }

    /// What is known of the only mesh, or of that of an outcome.
    fn record(&self, outcome: usize) -> Option<RecordHandle> {
        self.mended.record(outcome)?;
        let part = match &*self.mended {
            // What was taken apart by names is no part that the file has.
            Mended::File(RepairedFile::Parts(parts)) if parts.whole.is_none() => parts.parts.get(outcome)?.0,
            _ => 0,
        };
        let is_named =
            matches!(&*self.mended, Mended::File(RepairedFile::Parts(parts)) if parts.whole.is_some());
        let origin = self.origin.as_ref().filter(|_| !is_named).map(|origin| (Arc::clone(origin), part));
        Some(RecordHandle { mended: Arc::clone(&self.mended), outcome, origin })
    }
}

impl From<FileError> for Problem {
    fn from(error: FileError) -> Self {
        match error {
            FileError::Pass { file, error } | FileError::NoPartLeft { file, error } => {
                Problem::Pass { file: Some(file), error }
            }
            FileError::Write(error) => Problem::Write(error),
            error => Problem::Value(error.to_string()),
        }
    }
}
