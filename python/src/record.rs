//! What is known of one mesh that was repaired.

use std::sync::Arc;

use meshmend::CheckReport;
use meshmend::files::{KeptChecks, Maps, RepairRecord};
use meshmend::mesh::{Id, Sources};
use meshmend::passes::PassRecord;
use meshmend::report::json;
use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::arrays::{NONE, id, ids};
use crate::check::CheckHandle;
use crate::defects::DefectList;
use crate::errors;
use crate::mesh::{MeshHandle, Origin};
use crate::repair::Mended;

/// What is known of one mesh that was repaired.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct RecordHandle {
    pub(crate) mended: Arc<Mended>,
    pub(crate) outcome: usize,
    /// The file that the mesh is from, and which of its parts it is.
    pub(crate) origin: Option<(Arc<Origin>, usize)>,
}

type Numbers<'py> = Bound<'py, PyArray1<i32>>;
/// Its name, whether it changed anything, what it mended and what it left, and how χ, components and boundary loops changed.
type PassOfRecord = (&'static str, bool, Vec<DefectList>, Vec<DefectList>, Option<(i64, i64, Option<i64>)>);

impl RecordHandle {
    fn record(&self) -> PyResult<RepairRecord<'_>> {
        self.mended.record(self.outcome).ok_or_else(|| PyValueError::new_err("it was not repaired"))
    }

    fn check(&self, of: impl Fn(&KeptChecks) -> Option<Arc<CheckReport>>) -> PyResult<Option<CheckHandle>> {
        Ok(of(self.record()?.checks).map(|report| CheckHandle { report, origin: None }))
    }
}

#[pymethods]
impl RecordHandle {
    /// The mesh as it is now.
    fn mesh(&self) -> PyResult<MeshHandle> {
        Ok(MeshHandle { mesh: self.record()?.repaired.mesh.clone(), origin: self.origin.clone() })
    }

    /// The mesh as it was.
    fn stored(&self) -> PyResult<MeshHandle> {
        Ok(MeshHandle { mesh: self.record()?.stored.clone(), origin: self.origin.clone() })
    }

    /// The check before the first pass, if there was one.
    fn before(&self) -> PyResult<Option<CheckHandle>> {
        let check = self.check(|checks| checks.before.clone())?;
        Ok(check.map(|check| CheckHandle { origin: self.origin.clone(), ..check }))
    }

    /// The check after the last pass, if there was one.
    fn after(&self) -> PyResult<Option<CheckHandle>> {
        self.check(|checks| checks.after.clone())
    }

    /// Of each vertex, face or corner now that before, or -1; and how many there were.
    fn sources<'py>(&self, py: Python<'py>, domain: &str) -> PyResult<(Numbers<'py>, usize)> {
        let provenance = &self.record()?.repaired.provenance;
        let (sources, before) = match domain {
            "vertices" => (numbers(&provenance.vertices), provenance.before.vertices),
            "faces" => (numbers(&provenance.faces), provenance.before.faces),
            "corners" => (numbers(&provenance.corners), provenance.before.corners),
            _ => return Err(PyValueError::new_err(format!("there are no {domain}"))),
        };
        Ok((sources.into_pyarray(py), before))
    }

    /// The faces that run the other way round than before.
    fn flipped<'py>(&self, py: Python<'py>) -> PyResult<Numbers<'py>> {
        Ok(ids(&self.record()?.repaired.provenance.flipped).into_pyarray(py))
    }

    /// The faces of which nothing is left, the pass that removed each, and why.
    fn removed<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Numbers<'py>, Vec<&'static str>, Vec<&'static str>)> {
        let removed = &self.record()?.repaired.removed_faces;
        let faces: Vec<i32> = removed.iter().map(|removed| id(removed.face.index())).collect();
        let passes = removed.iter().map(|removed| removed.pass.name()).collect();
        let reasons = removed.iter().map(|removed| removed.reason.code()).collect();
        Ok((faces.into_pyarray(py), passes, reasons))
    }

    /// What each pass did.
    fn passes(&self) -> PyResult<Vec<PassOfRecord>> {
        Ok(self.record()?.repaired.passes.iter().map(of_pass).collect())
    }

    fn is_changed(&self) -> PyResult<bool> {
        Ok(self.record()?.report.changed)
    }

    /// The report on this mesh alone, with at most so many items in each list.
    fn json(&self, py: Python<'_>, limit: Option<usize>, with_maps: bool) -> PyResult<String> {
        let maps = if with_maps { Maps::Whole } else { Maps::LeftOut };
        let record = self.record()?;
        let text = py.detach(|| json(&record.document(limit.unwrap_or(usize::MAX), maps)));
        errors::written(py, text)
    }

    /// What the command prints for people.
    fn text(&self) -> PyResult<String> {
        Ok(meshmend_cli::text::repair(self.record()?.report))
    }
}

fn of_pass(record: &PassRecord) -> PassOfRecord {
    let delta = record.figures.map(|[before, after]| {
        let loops = before.boundary_loops.zip(after.boundary_loops);
        let change = |before: u64, after: u64| after as i64 - before as i64;
        (
            after.euler_characteristic - before.euler_characteristic,
            change(before.components, after.components),
            loops.map(|(before, after)| change(before, after)),
        )
    });
    let mended = DefectList::by_kind(record.fixed.iter().collect());
    (record.pass.name(), record.is_changed, mended, DefectList::by_kind(record.left.clone()), delta)
}

/// The numbers of the sources of elements, and -1 for those that have none.
pub(crate) fn numbers<I: Id>(sources: &Sources<I>) -> Vec<i32> {
    sources.iter().map(|(_, old)| old.map_or(NONE, |old| id(old.index()))).collect()
}
