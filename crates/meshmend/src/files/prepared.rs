//! A repaired file that is ready to be written.

use std::io::Write;
use std::path::Path;

use meshmend_io::{Encoding, Format, Loss, Prepared, PreparedDocument, WriteError};

/// A repaired file that is ready to be written.
#[derive(Clone, Debug)]
pub enum PreparedFile {
    /// A file of one mesh.
    Mesh(Box<Prepared>),
    /// A file whose parts were repaired each by itself.
    Parts(PreparedDocument),
}

impl PreparedFile {
    /// The format and the encoding in which it will be written.
    pub fn form(&self) -> (Format, Encoding) {
        match self {
            PreparedFile::Mesh(prepared) => (prepared.format(), prepared.encoding()),
            PreparedFile::Parts(prepared) => (prepared.format(), prepared.encoding()),
        }
    }

    /// What the file won't carry of the repaired meshes.
    ///
    /// *Cost*: that of [`Prepared::losses`].
    pub fn losses(&self) -> Vec<Loss> {
        match self {
            PreparedFile::Mesh(prepared) => prepared.losses(),
            PreparedFile::Parts(prepared) => prepared.losses(),
        }
    }

    /// Writes it to a file, whole or not at all, with the files that it names.
    ///
    /// # Errors
    /// If the system can't write. An old file then stays as it was.
    pub fn write(&self, path: &Path) -> Result<(), WriteError> {
        match self {
            PreparedFile::Mesh(prepared) => prepared.write(path),
            PreparedFile::Parts(prepared) => prepared.write(path),
        }
    }

    /// Writes it to any sink. Files that it names are not written.
    ///
    /// # Errors
    /// If the sink can't take it.
    pub fn encode(&self, out: &mut dyn Write) -> Result<(), WriteError> {
        match self {
            PreparedFile::Mesh(prepared) => prepared.encode(out),
            PreparedFile::Parts(prepared) => prepared.encode(out),
        }
    }
}
