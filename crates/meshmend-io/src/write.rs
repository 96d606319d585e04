//! Writing: find the format, prepare the mesh, replace the file in one step.

use std::io;
use std::path::Path;

use meshmend_core::PolygonMesh;

use crate::{Document, Loss, Prepared, PreparedDocument, WriteError, WriteOptions};

/// Writes a mesh to a file, whole or not at all (see [`replace_file`](crate::replace_file)), and returns what the
/// format can't carry.
///
/// # Errors
/// If neither options nor name show a format, the format lacks the encoding, the mesh is too large, or the system
/// can't write. An old file then stays as it was.
///
/// *Cost*: linear; a small buffer.
pub fn write(path: &Path, mesh: &PolygonMesh, options: &WriteOptions) -> Result<Vec<Loss>, WriteError> {
    let failed = |kind| WriteError { file: path.display().to_string(), kind };
    let prepared = Prepared::new(mesh, &options.clone().for_path(path)).map_err(failed)?;
    prepared.write(path)?;
    Ok(prepared.losses())
}

/// Writes a document to a file, whole or not at all, and returns what the file does not carry. A file of the kind that
/// was read keeps all that is round its meshes; in another format its parts become one mesh.
///
/// # Errors
/// As [`write()`].
///
/// *Cost*: linear.
pub fn write_document(
    path: &Path,
    document: &Document,
    options: &WriteOptions,
) -> Result<Vec<Loss>, WriteError> {
    let failed = |kind| WriteError { file: path.display().to_string(), kind };
    let prepared = PreparedDocument::new(document, &options.clone().for_path(path)).map_err(failed)?;
    prepared.write(path)?;
    Ok(prepared.losses())
}

/// Writes a mesh to any sink, and returns what the format can't carry. The options must name a format.
///
/// # Errors
/// As [`write()`].
///
/// *Cost*: linear; a small buffer.
pub fn encode(
    mesh: &PolygonMesh,
    options: &WriteOptions,
    out: &mut dyn io::Write,
) -> Result<Vec<Loss>, WriteError> {
    let failed = |kind| WriteError { file: "output".to_owned(), kind };
    let prepared = Prepared::new(mesh, options).map_err(failed)?;
    prepared.encode(out)?;
    Ok(prepared.losses())
}

/// What a file would not carry. It is not written. The list is empty for options with which no file can be written.
///
/// *Cost*: linear in the mesh; sorting for formats without indices.
pub fn losses(mesh: &PolygonMesh, options: &WriteOptions) -> Vec<Loss> {
    Prepared::new(mesh, options).map(|prepared| prepared.losses()).unwrap_or_default()
}
