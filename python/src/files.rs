//! Reading and writing.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use meshmend::formats::{
    Document, Placing, Prepared, PreparedDocument, WriteErrorKind, read_document, read_document_bytes,
};
use meshmend::{Loss, WriteError, WriteOptions};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyBytes;

use crate::document::DocumentHandle;
use crate::errors::{self, Done, Problem};
use crate::how::How;
use crate::mesh::{MeshHandle, Origin};
use crate::words::{ReadWords, WriteWords};

/// Reads a file, or the bytes of one that is called so.
#[pyfunction]
pub(crate) fn read(
    py: Python<'_>,
    name: PathBuf,
    bytes: Option<PyBackedBytes>,
    words: ReadWords,
    how: How<'_>,
) -> PyResult<DocumentHandle> {
    let options = errors::raise(py, words.options())?;
    let shown = name.display().to_string();
    let document = how.watched(py)?.run(|watch| {
        let options = options.with_watch(watch);
        Ok(match &bytes {
            Some(bytes) => read_document_bytes(bytes, &shown, &options)?,
            None => read_document(&name, &options)?,
        })
    })?;
    let document = errors::raise(py, document)?;
    Ok(DocumentHandle { origin: Arc::new(Origin { name: shown, document }) })
}

/// A mesh or a document to write.
#[derive(FromPyObject)]
pub(crate) enum Written<'py> {
    Mesh(Bound<'py, MeshHandle>),
    Document(Bound<'py, DocumentHandle>),
}

/// What is to be written, ready.
pub(crate) enum Ready {
    Mesh(Box<Prepared>),
    Document(PreparedDocument),
}

/// Writes to a file, whole or not at all, or gives the bytes; and says what is lost, as JSON.
#[pyfunction]
pub(crate) fn write<'py>(
    py: Python<'py>,
    what: Written<'py>,
    path: Option<PathBuf>,
    words: WriteWords,
    how: How<'py>,
) -> PyResult<(Option<Bound<'py, PyBytes>>, String)> {
    let options = errors::raise(py, words.options(path.as_deref()))?;
    let strict = words.strict;
    let (mesh, document) = match &what {
        Written::Mesh(mesh) => (Some(mesh.get()), None),
        Written::Document(document) => (None, Some(document.get())),
    };
    let done = how.watched(py)?.run(|watch| -> Done<(Option<Vec<u8>>, Vec<Loss>)> {
        let options = options.with_watch(watch);
        let name = path.as_deref().map_or("output".to_owned(), |path| path.display().to_string());
        let failed = |kind: WriteErrorKind| WriteError { file: name.clone(), kind };
        let ready = match (mesh, document) {
            (Some(mesh), _) => Ready::of_mesh(mesh, options),
            (None, Some(document)) => Ready::of_document(&document.origin.document, &options),
            (None, None) => return Err(Problem::Value("there is nothing to write".to_owned())),
        };
        let ready = ready.map_err(failed)?;
        let losses = ready.losses();
        if strict && !losses.is_empty() {
            return Err(Problem::Losses { file: name, losses });
        }
        Ok((ready.write(path.as_deref())?, losses))
    })?;
    let (bytes, losses) = errors::raise(py, done)?;
    let losses = serde_json::to_string(&losses);
    let losses = errors::written(py, losses)?;
    Ok((bytes.map(|bytes| PyBytes::new(py, &bytes)), losses))
}

impl Ready {
    /// A mesh, in the file that it is from if that holds more and has the same format.
    fn of_mesh(handle: &MeshHandle, options: WriteOptions) -> Result<Self, WriteErrorKind> {
        let Some((origin, part)) = &handle.origin else {
            return Ok(Ready::Mesh(Box::new(Prepared::new(&handle.mesh, &options)?)));
        };
        let shell = &origin.document.shell;
        let options = options.with_shell(shell.clone());
        if options.format.is_some_and(|format| shell.is_spliced_into(format)) {
            let document = origin.document.clone().with_mesh(*part, handle.mesh.clone());
            return Ready::of_document(&document, &options);
        }
        Ok(Ready::Mesh(Box::new(Prepared::new(&handle.mesh, &options)?)))
    }

    fn of_document(document: &Document, options: &WriteOptions) -> Result<Self, WriteErrorKind> {
        let options = options.clone().with_shell(document.shell.clone());
        Ok(Ready::Document(PreparedDocument::placed(document, &options, Placing::Scene)?))
    }

    fn losses(&self) -> Vec<Loss> {
        match self {
            Ready::Mesh(prepared) => prepared.losses(),
            Ready::Document(prepared) => prepared.losses(),
        }
    }

    /// Writes to a file, or gives the bytes.
    fn write(&self, path: Option<&Path>) -> Result<Option<Vec<u8>>, WriteError> {
        let mut bytes = Vec::new();
        match (self, path) {
            (Ready::Mesh(prepared), Some(path)) => prepared.write(path)?,
            (Ready::Document(prepared), Some(path)) => prepared.write(path)?,
            (Ready::Mesh(prepared), None) => prepared.encode(&mut bytes)?,
            (Ready::Document(prepared), None) => prepared.encode(&mut bytes)?,
        }
        Ok(path.is_none().then_some(bytes))
    }
}
