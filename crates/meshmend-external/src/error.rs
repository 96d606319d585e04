//! Why a mesh larger than memory was not checked.

use std::io;

use bytesize::ByteSize;
use meshmend_core::Cancelled;
use meshmend_io::ReadError;
use thiserror::Error;

/// Why a mesh larger than memory was not checked.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ExternalError {
    /// The file can't be read, or not row by row.
    #[error("{0}")]
    Read(#[from] ReadError),
    /// The disk takes no more, or does not give back what it took.
    #[error("{folder}: {error}")]
    Spill {
        /// The folder for what does not fit memory.
        folder: String,
        /// What the system says.
        error: io::Error,
    },
    /// The memory that may be used is too little for this mesh.
    #[error("{what} takes about {}, more than the {} that may be used", ByteSize(*.needed), ByteSize(*.allowed))]
    Memory {
        /// What takes it.
        what: &'static str,
        /// How many bytes.
        needed: u64,
        /// How many may be used.
        allowed: u64,
    },
    /// Whoever watches asked to stop.
    #[error("{0}")]
    Cancelled(#[from] Cancelled),
}

impl ExternalError {
    /// What the system says about the folder of what is spilled.
    #[cold]
    pub(crate) fn spilling(folder: &str, error: io::Error) -> Self {
        ExternalError::Spill { folder: folder.to_owned(), error }
    }
}
