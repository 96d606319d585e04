//! Defects of one kind as columns.

use std::sync::Arc;

use meshmend::mesh::{Aspect, Detail, Element, Id};
use meshmend::report::PlacedDefect;
use meshmend::{CheckReport, Defect, DefectKind, Severity};
use numpy::{IntoPyArray, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::{NONE, id, ids};
use crate::errors;

/// The defects of one kind, all of them.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct DefectList {
    kind: DefectKind,
    of: Of,
}

/// Where the defects are.
enum Of {
    Check(Arc<CheckReport>),
    List(Arc<[Defect]>),
}

/// What there is to be said of each defect, by column.
#[derive(Default)]
struct Columns {
    rows: usize,
    vertices: Vec<i32>,
    edges: Vec<i32>,
    faces: Vec<i32>,
    index: Vec<i32>,
    strips: Vec<Vec<i32>>,
    counts: Vec<i64>,
    beside: Vec<i32>,
    boundary_only: Vec<bool>,
    words: Vec<String>,
    /// What the words are called, if there are any.
    told: Option<&'static str>,
    has_boundary_only: bool,
}

impl DefectList {
    /// The defects of a kind that a check found.
    pub(crate) fn of_check(report: &Arc<CheckReport>, kind: DefectKind) -> Self {
        DefectList { kind, of: Of::Check(Arc::clone(report)) }
    }

    /// Some defects, a list for each kind that occurs.
    pub(crate) fn by_kind(mut defects: Vec<Defect>) -> Vec<DefectList> {
        defects.sort_by_key(Defect::kind);
        let runs = defects.chunk_by(|one, other| one.kind() == other.kind());
        let list = |run: &[Defect]| Some(DefectList { kind: run.first()?.kind(), of: Of::List(run.into()) });
        runs.filter_map(list).collect()
    }

    /// Each defect, with the numbers that vertices and faces have as stored.
    fn defects(&self) -> Box<dyn Iterator<Item = Defect> + '_> {
        match &self.of {
            Of::List(list) => Box::new(list.iter().cloned()),
            Of::Check(report) => Box::new(report.defects_of_kind(self.kind).map(|defect| {
                defect.with_vertices(|v| report.stored_vertex(v)).with_faces(|f| report.stored_face(f))
            })),
        }
    }
}

#[pymethods]
impl DefectList {
    #[getter]
    fn kind(&self) -> &'static str {
        self.kind.code()
    }

    #[getter]
    fn title(&self) -> &'static str {
        self.kind.title()
    }

    #[getter]
    fn explanation(&self) -> &'static str {
        self.kind.explanation()
    }

    #[getter]
    fn severity(&self) -> &'static str {
        match self.kind.severity() {
            Severity::Note => "note",
            Severity::Defect => "defect",
        }
    }

    fn __len__(&self) -> usize {
        match &self.of {
            Of::List(list) => list.len(),
            Of::Check(report) => report.defects_of_kind(self.kind).count(),
        }
    }

    /// The columns by name; those that the kind does not have are empty or absent.
    fn columns<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let columns = Columns::of(self.defects());
        let (all, data) = (PyDict::new(py), PyDict::new(py));
        let width = columns.vertices.len().checked_div(columns.rows).unwrap_or(1);
        let vertices = columns.vertices.into_pyarray(py);
        if width == 2 {
            all.set_item("vertices", vertices.reshape([columns.rows, 2])?)?;
        } else {
            all.set_item("vertices", vertices)?;
        }
        all.set_item("edges", columns.edges.into_pyarray(py))?;
        all.set_item("faces", columns.faces.into_pyarray(py))?;
        let strips: Vec<_> = columns.strips.into_iter().map(|faces| faces.into_pyarray(py)).collect();
        all.set_item("strips", strips)?;
        if let Some(name) = self.kind.rule().counts {
            data.set_item(name, columns.counts.into_pyarray(py))?;
        }
        if columns.beside.iter().any(|&beside| beside != NONE) {
            data.set_item("beside", columns.beside.into_pyarray(py))?;
        }
        if !columns.index.is_empty() {
            data.set_item("index", columns.index.into_pyarray(py))?;
        }
        if columns.has_boundary_only {
            data.set_item("boundary_only", columns.boundary_only.into_pyarray(py))?;
        }
        if let Some(name) = columns.told {
            data.set_item(name, columns.words)?;
        }
        all.set_item("data", data)?;
        Ok(all)
    }

    /// The defects as the items of a JSON report, all of them, as JSON.
    fn items(&self, py: Python<'_>) -> PyResult<String> {
        let text = match &self.of {
            Of::List(list) => serde_json::to_string(&list[..]),
            Of::Check(report) => {
                let placed = report.defects_of_kind(self.kind);
                let placed = placed.map(|defect| PlacedDefect::of_report(defect, report, usize::MAX));
                serde_json::to_string(&placed.collect::<Vec<_>>())
            }
        };
        errors::written(py, text)
    }
}

impl Columns {
    fn of(defects: impl Iterator<Item = Defect>) -> Self {
        let mut columns = Columns::default();
        defects.for_each(|defect| columns.add(&defect));
        columns
    }

    fn add(&mut self, defect: &Defect) {
        self.rows += 1;
        self.add_element(&defect.at);
        self.counts.push(defect.count.into());
        self.beside.push(defect.beside.as_ref().map_or(NONE, number));
        self.boundary_only.push(defect.detail == Detail::BoundaryOnly(true));
        let (told, word) = match &defect.detail {
            Detail::Differs(differs) => {
                (Some("differs"), differs.iter().map(Aspect::name).collect::<Vec<_>>().join(","))
            }
            Detail::Unjudged(_) => (Some("reason"), defect.detail.to_string()),
            Detail::Lies(lie) => (Some("how"), lie.name().to_owned()),
            _ => (None, String::new()),
        };
        self.has_boundary_only |= matches!(defect.detail, Detail::BoundaryOnly(_));
        self.told = self.told.or(told);
        self.words.push(word);
    }

    fn add_element(&mut self, element: &Element) {
        self.vertices.extend(element.vertex().map(|vertex| id(vertex.index())));
        self.vertices.extend(element.ends().iter().flatten().map(|end| id(end.index())));
        self.edges.extend(element.edge().map(|edge| id(edge.index())));
        self.faces.extend(element.face().map(|face| id(face.index())));
        match element {
            Element::LooseEdge { index, .. } | Element::LoosePoint { index, .. } => {
                self.index.push(id(*index as usize));
            }
            Element::Strip(strip) => self.strips.push(ids(&strip.faces)),
            _ => {}
        }
    }
}

/// The number of an element: of its vertex, its edge or its face.
fn number(element: &Element) -> i32 {
    let edge = || element.edge().map(|edge| edge.index());
    let face = || element.face().map(|face| face.index());
    element.vertex().map(|vertex| vertex.index()).or_else(edge).or_else(face).map_or(NONE, id)
}
