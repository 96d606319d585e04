//! What a check found.

use std::sync::Arc;

use meshmend::mesh::Found;
use meshmend::report::{CheckDocument, PartsDocument, json};
use meshmend::spatial::Budget;
use meshmend::{
    CheckOptions, CheckReport, DefectKind, Distance, GeometryOptions, Question, Questions, Rules, View, check,
};
use meshmend_cli::text;
use pyo3::prelude::*;

use crate::defects::DefectList;
use crate::document::DocumentHandle;
use crate::errors::{self, Done, Problem};
use crate::how::How;
use crate::mesh::{MeshHandle, OfFile, Origin};
use crate::words;

/// How to check.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct CheckWords {
    view: Option<String>,
    weld: Option<String>,
    kernel: String,
    witness: String,
    geometry: GeometryWords,
    fail_on: Vec<String>,
}

/// What is asked about where the faces lie: nothing, all for an empty list, or some questions.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct GeometryWords {
    questions: Option<Vec<String>>,
    near: Option<String>,
    pair_budget: Option<u64>,
}

/// What a check found.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct CheckHandle {
    pub(crate) report: Arc<CheckReport>,
    /// The file that the mesh is from, and which of its parts it is.
    pub(crate) origin: Option<(Arc<Origin>, usize)>,
}

impl GeometryWords {
    /// What is asked, with what kinds of defect need.
    pub(crate) fn options(&self, fail_on: &[DefectKind]) -> Done<Option<GeometryOptions>> {
        let asked: Vec<Question> = match self.questions.as_deref() {
            Some([]) => Question::ALL.to_vec(),
            Some(words) => words.iter().map(|word| words::question(word)).collect::<Done<_>>()?,
            None => Vec::new(),
        };
        let needed = fail_on.iter().filter_map(|&kind| Question::about(kind));
        let questions: Questions = asked.into_iter().chain(needed).collect();
        if questions.is_empty() {
            return Ok(None);
        }
        let near = words::distance("near", self.near.as_deref().unwrap_or("exact"))?;
        let near = match near {
            Some(near @ (Distance::Exact | Distance::Absolute(_) | Distance::Relative(_))) => near,
            _ => return Err(Problem::Value("near can be exact, a length or a percentage".to_owned())),
        };
        let budget = self.pair_budget.map_or(Budget::Usual, Budget::Tests);
        Ok(Some(GeometryOptions::default().asking(questions).with_near(near).with_budget(budget)))
    }
}

impl CheckWords {
    /// How to check a mesh, and the kinds that are listed beside those that always are.
    fn options(&self, handle: &MeshHandle) -> Done<(CheckOptions, Vec<DefectKind>)> {
        let part = handle.origin.as_ref().and_then(|(origin, part)| {
            let document = &origin.document;
            document.parts.get(*part).map(|part| (document.format, part))
        });
        let usual = part.map_or(View::Indexed, |(format, part)| View::usual_for_part(format, part));
        let mut listed = self.fail_on.iter().map(|word| kind(word)).collect::<Done<Vec<_>>>()?;
        let geometry = self.geometry.options(&listed)?;
        let must_be_closed = part.is_some_and(|(_, part)| part.must_be_closed());
        if must_be_closed && !listed.contains(&DefectKind::BoundaryEdge) {
            listed.push(DefectKind::BoundaryEdge);
        }
        let options = CheckOptions::default()
            .with_view(words::view(self.view.as_deref(), self.weld.as_deref(), usual)?)
            .with_kernel(words::kernel(&self.kernel)?)
            .with_witness(words::witness(&self.witness)?);
        let options = match geometry {
            Some(geometry) => options.with_geometry(geometry),
            None => options,
        };
        Ok((options, listed))
    }
}

fn kind(word: &str) -> Done<DefectKind> {
    let known = || Rules::builtin().kinds().map(DefectKind::code);
    DefectKind::from_code(word).ok_or_else(|| words::unknown("the kind of defect", word, known()))
}

/// Checks a mesh, and changes nothing.
#[pyfunction]
#[pyo3(name = "check")]
pub(crate) fn check_mesh(
    py: Python<'_>,
    mesh: &Bound<'_, MeshHandle>,
    words: CheckWords,
    how: How<'_>,
) -> PyResult<CheckHandle> {
    let handle = mesh.get();
    let (options, listed) = errors::raise(py, words.options(handle))?;
    let report = how.watched(py)?.run(|watch| check(&handle.mesh, &options.with_watch(watch)))?;
    let report = errors::raise(py, report.map_err(Problem::from))?.listing(&listed);
    Ok(CheckHandle { report: Arc::new(report), origin: handle.origin.clone() })
}

#[pymethods]
impl CheckHandle {
    /// The mesh in the view of the check.
    fn mesh(&self) -> MeshHandle {
        MeshHandle { mesh: self.report.mesh.clone(), origin: self.origin.clone() }
    }

    fn is_sound(&self) -> bool {
        self.report.is_sound()
    }

    /// The defects of a kind, if it was looked for.
    fn defects(&self, code: &str) -> Option<DefectList> {
        let kind = DefectKind::from_code(code)?;
        let is_asked = |geometry: &meshmend::GeometryReport| match Question::about(kind) {
            Some(Question::Crossings) => geometry.intersections.is_some(),
            Some(Question::TJunctions) => geometry.t_junctions.is_some(),
            Some(Question::Nesting) => geometry.nesting.is_some(),
            Some(Question::Internal) => geometry.internal.is_some(),
            Some(Question::Shape) => geometry.shapes.is_some(),
            _ => true,
        };
        let is_looked_for = match Question::about(kind) {
            None => !matches!(kind.rule().found, Found::ByPass),
            Some(_) => self.report.geometry.as_ref().is_some_and(is_asked),
        };
        is_looked_for.then(|| DefectList::of_check(&self.report, kind))
    }

    /// How many defects of each kind there are, of those that occur.
    fn counts(&self) -> Vec<(&'static str, usize)> {
        let kinds = self.report.listed_kinds();
        kinds.map(|kind| (kind.code(), self.report.count(kind))).collect()
    }

    /// The document of the command, with at most so many items in each list.
    fn json(&self, py: Python<'_>, limit: Option<usize>) -> PyResult<String> {
        let limit = limit.unwrap_or(usize::MAX);
        let text = py.detach(|| match &self.origin {
            Some((origin, part)) if !origin.document.is_whole() => {
                of_parts(origin, &[(*part, Some(self.report.as_ref()))], limit)
            }
            _ => json(&self.document(limit)),
        });
        errors::written(py, text)
    }

    /// What the command prints for people.
    fn text(&self, limit: usize) -> String {
        text::check(&self.document(limit))
    }
}

impl CheckHandle {
    /// The document, with what is known of the file.
    fn document(&self, limit: usize) -> CheckDocument {
        let OfFile { file, format, notes } = self.mesh().of_file();
        CheckDocument { file, format, notes, ..CheckDocument::new(CheckReport::clone(&self.report), limit) }
    }
}

/// The document of the command for a file of parts: the report on each, or none where it can't be looked at.
#[pyfunction]
pub(crate) fn parts_json(
    py: Python<'_>,
    document: &Bound<'_, DocumentHandle>,
    checks: Vec<(usize, Option<Bound<'_, CheckHandle>>)>,
    limit: Option<usize>,
) -> PyResult<String> {
    let origin = &document.get().origin;
    let reports: Vec<(usize, Option<&CheckReport>)> = checks
        .iter()
        .map(|(part, check)| (*part, check.as_ref().map(|check| check.get().report.as_ref())))
        .collect();
    let text = py.detach(|| of_parts(origin, &reports, limit.unwrap_or(usize::MAX)));
    errors::written(py, text)
}

fn of_parts(
    origin: &Origin,
    reports: &[(usize, Option<&CheckReport>)],
    limit: usize,
) -> Result<String, serde_json::Error> {
    let document = &origin.document;
    let mut together = PartsDocument::default();
    for (number, report) in reports {
        let Some(part) = document.parts.get(*number) else { continue };
        match report {
            Some(report) => {
                together.add(*number, part, &CheckDocument::new(CheckReport::clone(report), limit))?
            }
            None => together.add_without(*number, part, "sealed", part.seal().unwrap_or_default()),
        }
    }
    together.say("file", &origin.name)?;
    together.say("format", &document.variant)?;
    together.say("notes", &document.notes)?;
    json(&together)
}
