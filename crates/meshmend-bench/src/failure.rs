//! Why something has not been measured.

use std::io;
use std::path::{Path, PathBuf};

use meshmend::mesh::{FaceTableError, MeshError};
use meshmend::{LoopError, PassError, ReadError, Refusal, WriteError};
use thiserror::Error;

/// Why something has not been measured.
#[derive(Debug, Error)]
pub(crate) enum Failure {
    #[error("{path}: {source}", path = path.display())]
    Io { path: PathBuf, source: io::Error },
    #[error("{path}: this program did not write it", path = .0.display())]
    NotAnInput(PathBuf),
    #[error("{what}: the process that measures it failed: {errors}")]
    Process { what: String, errors: String },
    #[error("{0}: not what a process that measures says: {1}")]
    NotFigures(String, serde_json::Error),
    #[error("{0}: no instructions are counted by valgrind")]
    NotCounted(String),
    #[error("{path}:{line}: not an operation and a count", path = path.display())]
    NotACount { path: PathBuf, line: usize },
    #[error("{0}: there is no such operation; `meshmend-bench list` names them")]
    NoSuchOperation(String),
    #[error(transparent)]
    Faces(#[from] FaceTableError),
    #[error(transparent)]
    Mesh(#[from] MeshError),
    #[error(transparent)]
    Pass(#[from] PassError),
    #[error(transparent)]
    Cancelled(#[from] meshmend::mesh::Cancelled),
    #[error(transparent)]
    Plan(#[from] meshmend::passes::PlanError),
    #[error(transparent)]
    Loops(#[from] LoopError),
    #[error(transparent)]
    Refused(#[from] Refusal),
    #[error(transparent)]
    Read(#[from] ReadError),
    #[error(transparent)]
    Write(#[from] WriteError),
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

impl Failure {
    pub(crate) fn io(path: &Path, source: io::Error) -> Self {
        Failure::Io { path: path.to_owned(), source }
    }
}
