//! Surfaces: the closed paths that generate them, cutting along these, and shapes whose every figure is known.

use std::num::NonZeroU32;

use meshmend::cutting::CutAlong;
use meshmend::report::{CutDocument, LoopsDocument, json};
use meshmend::shapes::{NAMED_SHAPES, NamedShape, Sizes};
use meshmend::topology::{CoTree, Measure, Roots};
use meshmend::{CutOptions, CutReport, LoopOptions, LoopReport, PathOptions, VertexId, View, cut, loops};
use meshmend_cli::text;
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;

use crate::errors::{self, Done, Problem};
use crate::how::How;
use crate::mesh::{MeshHandle, OfFile, Origin};
use crate::record::numbers;
use crate::words;

/// How to look for paths, and in which view of the mesh.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct PathWords {
    view: Option<String>,
    weld: Option<String>,
    kernel: String,
    greedy: bool,
    hops: bool,
    root: Option<u32>,
    roots: Option<u32>,
    along: String,
}

/// How large a shape is.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct SizeWords {
    resolution: Option<usize>,
    count: Option<usize>,
    genus: Option<usize>,
    cross_caps: Option<usize>,
    holes: Option<usize>,
    refine: usize,
    triangles: bool,
}

/// The file that a mesh is from, and which of its parts it is.
type From = Option<(std::sync::Arc<Origin>, usize)>;

/// The closed paths of a mesh.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct LoopsHandle {
    report: LoopReport,
    origin: From,
}

/// A mesh that was cut open.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct CutHandle {
    report: CutReport,
    along: CutAlong,
    origin: From,
}

impl PathWords {
    fn view(&self, mesh: &MeshHandle) -> Done<View> {
        let usual = mesh.origin.as_ref().map_or(View::Indexed, |(origin, part)| {
            let document = &origin.document;
            let part = document.parts.get(*part);
            part.map_or(View::Indexed, |part| View::usual_for_part(document.format, part))
        });
        words::view(self.view.as_deref(), self.weld.as_deref(), usual)
    }

    fn paths(&self) -> Done<PathOptions> {
        let roots = match (self.root, self.roots.map(NonZeroU32::new)) {
            (None, None) => Roots::Lowest,
            (Some(vertex), None) => Roots::At(VertexId(vertex)),
            (None, Some(Some(count))) => Roots::Best(count),
            (None, Some(None)) => return Err(Problem::Value("roots is 1 or more".to_owned())),
            (Some(_), Some(_)) => return Err(Problem::Value("root and roots exclude each other".to_owned())),
        };
        Ok(PathOptions::default()
            .with_measure(if self.hops { Measure::Hops } else { Measure::Length })
            .with_co_tree(if self.greedy { CoTree::Greedy } else { CoTree::Lowest })
            .with_roots(roots))
    }

    fn along(&self) -> Done<CutAlong> {
        let known = [("cut-graph", CutAlong::CutGraph), ("generators", CutAlong::Generators)];
        words::chosen("along", &self.along, &known)
    }
}

/// The closed paths that generate each surface.
#[pyfunction]
#[pyo3(name = "loops")]
pub(crate) fn find_loops(
    py: Python<'_>,
    mesh: &Bound<'_, MeshHandle>,
    words: PathWords,
    how: How<'_>,
) -> PyResult<LoopsHandle> {
    let handle = mesh.get();
    let report = how.watched(py)?.run(|watch| -> Done<LoopReport> {
        let view = words.view(handle)?.resolved(&handle.mesh, watch)?;
        let options = LoopOptions::default()
            .with_view(view)
            .with_kernel(words::kernel(&words.kernel)?)
            .with_paths(words.paths()?)
            .with_watch(watch);
        Ok(loops(&handle.mesh, &options)?)
    })?;
    Ok(LoopsHandle { report: errors::raise(py, report)?, origin: handle.origin.clone() })
}

/// Cuts each surface open.
#[pyfunction]
#[pyo3(name = "cut")]
pub(crate) fn cut_mesh(
    py: Python<'_>,
    mesh: &Bound<'_, MeshHandle>,
    words: PathWords,
    how: How<'_>,
) -> PyResult<CutHandle> {
    let handle = mesh.get();
    let along = errors::raise(py, words.along())?;
    let report = how.watched(py)?.run(|watch| -> Done<CutReport> {
        let view = words.view(handle)?.resolved(&handle.mesh, watch)?;
        let options = CutOptions::default()
            .with_view(view)
            .with_along(along)
            .with_paths(words.paths()?)
            .with_watch(watch);
        Ok(cut(&handle.mesh, &options)?)
    })?;
    Ok(CutHandle { report: errors::raise(py, report)?, along, origin: handle.origin.clone() })
}

/// A shape whose every figure is known.
#[pyfunction]
pub(crate) fn make(py: Python<'_>, name: &str, words: SizeWords, how: How<'_>) -> PyResult<MeshHandle> {
    let made = how.watched(py)?.run(|_| -> Done<MeshHandle> {
        let SizeWords { resolution, count, genus, cross_caps, holes, refine, triangles } = words;
        let known = || NAMED_SHAPES.iter().map(|shape| shape.name);
        let named = NamedShape::from_name(name).ok_or_else(|| words::unknown("the shape", name, known()))?;
        let sizes = Sizes { resolution, count, genus, cross_caps, holes };
        let failed = |error: meshmend::shapes::ShapeError| Problem::Value(error.to_string());
        let shape = named.make(&sizes).and_then(|shape| shape.refined_times(refine)).map_err(failed)?;
        let shape = if triangles { shape.triangulated().map_err(failed)? } else { shape };
        Ok(MeshHandle::alone(shape.mesh))
    })?;
    errors::raise(py, made)
}

#[pymethods]
impl LoopsHandle {
    /// The mesh in the view in which it was looked at.
    fn mesh(&self) -> MeshHandle {
        MeshHandle { mesh: self.report.mesh.clone(), origin: self.origin.clone() }
    }

    /// The document of the command, with at most so many components.
    fn json(&self, py: Python<'_>, limit: Option<usize>) -> PyResult<String> {
        let text = py.detach(|| json(&self.document(limit.unwrap_or(usize::MAX))));
        errors::written(py, text)
    }

    /// What the command prints for people.
    fn text(&self, limit: usize) -> String {
        text::loops(&self.document(limit))
    }
}

impl LoopsHandle {
    fn document(&self, limit: usize) -> LoopsDocument {
        let OfFile { file, format, notes } = self.mesh().of_file();
        LoopsDocument { file, format, notes, ..LoopsDocument::new(&self.report, limit) }
    }
}

#[pymethods]
impl CutHandle {
    /// The mesh with its cuts open.
    fn mesh(&self) -> MeshHandle {
        MeshHandle { mesh: self.report.discs.mesh.clone(), origin: self.origin.clone() }
    }

    /// Of each vertex now that before, or -1; and how many there were.
    fn sources<'py>(&self, py: Python<'py>) -> (Bound<'py, PyArray1<i32>>, usize) {
        let provenance = &self.report.discs.provenance;
        (numbers(&provenance.vertices).into_pyarray(py), provenance.before.vertices)
    }

    /// The document of the command, with at most so many items in each list.
    fn json(&self, py: Python<'_>, limit: Option<usize>) -> PyResult<String> {
        let text = py.detach(|| json(&self.document(limit.unwrap_or(usize::MAX))));
        errors::written(py, text)
    }

    /// What the command prints for people.
    fn text(&self, limit: usize) -> String {
        text::cut(&self.document(limit))
    }
}

impl CutHandle {
    fn document(&self, limit: usize) -> CutDocument {
        let OfFile { file, notes, .. } = self.mesh().of_file();
        CutDocument { file, notes, ..CutDocument::new(&self.report, self.along, limit) }
    }
}
