//! Why a file was not repaired.

use meshmend_io::{TooMuchPlaced, WriteError};
use meshmend_repair::PassError;
use thiserror::Error;

use super::{FaceNames, NoSuchPart};

/// Why a file was not repaired.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum FileError {
    /// The parts of the file don't become one mesh.
    #[error("{file}: {error}")]
    Placed {
        /// What the file is called.
        file: String,
        /// Why.
        error: TooMuchPlaced,
    },
    /// A part was asked for that the file does not have.
    #[error(transparent)]
    NoSuchPart(#[from] NoSuchPart),
    /// Faces have no names by which the mesh could be taken apart.
    #[error("{file}: its faces have no {} to take it apart by", names.name())]
    Nameless {
        /// What the file is called.
        file: String,
        /// The names that were asked for.
        names: FaceNames,
    },
    /// The file has several parts, and was to be taken apart as one mesh.
    #[error("{file}: the file has parts of its own; only one mesh is taken apart by the names of its faces")]
    HasParts {
        /// What the file is called.
        file: String,
    },
    /// A pass gave no mesh.
    #[error("{file}: {error}")]
    Pass {
        /// What the file, or the part of it, is called.
        file: String,
        /// Why.
        error: PassError,
    },
    /// No face would be left of any part of the file.
    #[error("{file}: {error}")]
    NoPartLeft {
        /// What the file is called.
        file: String,
        /// Why, for the last of the parts.
        error: PassError,
    },
    /// The result can't be written as the target says.
    #[error(transparent)]
    Write(#[from] WriteError),
}

impl FileError {
    pub(super) fn of_pass(file: &str, error: impl Into<PassError>) -> Self {
        FileError::Pass { file: file.to_owned(), error: error.into() }
    }
}
