//! A file as a whole, with its parts.

use std::sync::Arc;

use meshmend::formats::{Document, Placing};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::errors;
use crate::mesh::{MeshHandle, Origin};

/// A file.
#[pyclass(frozen, module = "meshmend._native")]
pub(crate) struct DocumentHandle {
    pub(crate) origin: Arc<Origin>,
}

impl DocumentHandle {
    fn document(&self) -> &Document {
        &self.origin.document
    }
}

#[pymethods]
impl DocumentHandle {
    fn name(&self) -> &str {
        &self.origin.name
    }

    /// The form of the file, such as `ply-le`.
    fn variant(&self) -> &'static str {
        self.document().variant
    }

    /// Whether the file is one mesh, as all files of formats without parts are.
    fn is_whole(&self) -> bool {
        self.document().is_whole()
    }

    /// Of each part its name, what reports call it, and why it can't be edited, if it can't.
    fn parts<'py>(&self, py: Python<'py>) -> Vec<(Bound<'py, PyBytes>, String, Option<String>)> {
        let parts = self.document().parts.iter();
        parts
            .map(|part| (PyBytes::new(py, &part.name), part.title(), part.seal().map(str::to_owned)))
            .collect()
    }

    /// The mesh of a part, in its own space.
    fn mesh(&self, part: usize) -> PyResult<MeshHandle> {
        let mesh = self.document().parts.get(part).map(|part| part.mesh.clone());
        let mesh = mesh.ok_or_else(|| PyValueError::new_err(format!("there is no part {part}")))?;
        Ok(MeshHandle { mesh, origin: Some((Arc::clone(&self.origin), part)) })
    }

    /// The document with other meshes in its parts.
    fn with_meshes(&self, meshes: Vec<(usize, PyRef<'_, MeshHandle>)>) -> DocumentHandle {
        let replaced = |document: Document, (part, mesh): (usize, PyRef<'_, MeshHandle>)| {
            document.with_mesh(part, mesh.mesh.clone())
        };
        let document = meshes.into_iter().fold(self.document().clone(), replaced);
        DocumentHandle { origin: Arc::new(Origin { name: self.origin.name.clone(), document }) }
    }

    /// All parts as one mesh: as the file places them, or each once in its own space.
    fn as_one(&self, py: Python<'_>, is_scene: bool) -> PyResult<DocumentHandle> {
        let placing = if is_scene { Placing::Scene } else { Placing::Parts };
        let name = self.origin.name.clone();
        let document = self.document().clone();
        let file = py.detach(|| document.into_mesh(placing));
        let file = file.map_err(|reason| PyValueError::new_err(format!("{name}: {reason}")))?;
        Ok(DocumentHandle { origin: Arc::new(Origin { name, document: file.into() }) })
    }

    /// What the reader had to say, as JSON.
    fn notes(&self, py: Python<'_>) -> PyResult<String> {
        let notes = serde_json::to_string(&self.document().notes);
        errors::written(py, notes)
    }
}
