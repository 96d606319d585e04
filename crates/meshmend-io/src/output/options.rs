//! How to write.

use std::path::{Path, PathBuf};

use crate::paths::folder_of;
use crate::{Encoding, Format, ReadFile, Shell, WriteErrorKind};

/// How to write.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct WriteOptions {
    /// The format; by default that of the file's name.
    pub format: Option<Format>,
    /// How to spell numbers; by default as the file that the mesh comes from, if that has the same format, else as the
    /// format does by default.
    pub encoding: Option<Encoding>,
    /// How the file that the mesh comes from was written; a file of the same format is written likewise.
    pub shell: Shell,
    /// How a vertex is written whose attributes differ from corner to corner.
    pub seams: Seams,
    /// In which precision attributes from another format are written.
    pub precision: AttributePrecision,
    /// The folder that the file will be in, where that is known: files that the input names may not be there.
    pub folder: Option<PathBuf>,
}

/// How a vertex is written whose attributes differ from corner to corner, where programs that read the format look for
/// them at the vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Seams {
    /// As several vertices at one place, each with its own values.
    #[default]
    Split,
    /// As one vertex; the values are written for each corner where the format has a way to do so, though other programs
    /// may not look there, and are lost where it has none.
    Corners,
    /// Not at all: the mesh is not written.
    Fail,
}

/// In which precision attributes from another format are written to one whose programs expect single precision.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum AttributePrecision {
    /// As those programs expect: texture coordinates and normals in single precision, colours as bytes where that is what
    /// they come from; what is rounded is a named loss.
    #[default]
    AsExpected,
    /// As they are.
    Double,
}

impl WriteOptions {
    /// A format in its default encoding.
    pub fn of(format: Format) -> Self {
        WriteOptions { format: Some(format), ..WriteOptions::default() }
    }

    /// These options with an encoding.
    pub fn with_encoding(self, encoding: Encoding) -> Self {
        WriteOptions { encoding: Some(encoding), ..self }
    }

    /// These options with another way to write vertices whose attributes differ from corner to corner.
    pub fn with_seams(self, seams: Seams) -> Self {
        WriteOptions { seams, ..self }
    }

    /// These options with another precision of attributes from other formats.
    pub fn with_precision(self, precision: AttributePrecision) -> Self {
        WriteOptions { precision, ..self }
    }

    /// These options, for a mesh that comes from a file with this shell.
    pub fn with_shell(self, shell: Shell) -> Self {
        WriteOptions { shell, ..self }
    }

    /// These options, but what they leave open is done as in a file that was read, if its format is the same.
    pub fn as_read(self, file: &ReadFile) -> Self {
        WriteOptions { shell: file.shell.clone(), ..self }
    }

    /// These options with the format of a file name, where they name none, and its folder.
    pub fn for_path(self, path: &Path) -> Self {
        let format = self.format.or_else(|| Format::from_path(path));
        WriteOptions { format, folder: Some(folder_of(path).to_owned()), ..self }
    }

    /// The format and the encoding that come of these options.
    ///
    /// # Errors
    /// When they name no format, or an encoding that the format does not have.
    pub fn resolved(&self) -> Result<(Format, Encoding), WriteErrorKind> {
        let format = self.format.ok_or(WriteErrorKind::UnknownFormat)?;
        let as_read = self.shell.encoding().filter(|_| self.shell.format() == Some(format));
        let usual = as_read.or_else(|| format.encodings().first().copied());
        let encoding = self.encoding.or(usual).unwrap_or(Encoding::Ascii);
        if format.encodings().contains(&encoding) {
            Ok((format, encoding))
        } else {
            Err(WriteErrorKind::NoSuchEncoding { format, encoding })
        }
    }
}
