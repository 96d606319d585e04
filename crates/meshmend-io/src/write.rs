//! Writing: find the format, encode the mesh, put the bytes in the file's place all at once.

use std::io;
use std::path::Path;

use meshmend_core::PolygonMesh;

use crate::atomic::replace_file;
use crate::{Encoding, Format, Loss, WriteError, WriteErrorKind};

/// How to write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WriteOptions {
    /// The format; by default that of the file's name.
    pub format: Option<Format>,
    /// How to spell numbers; by default as the format does by default.
    pub encoding: Option<Encoding>,
}

impl WriteOptions {
    /// A format in its default encoding.
    pub fn of(format: Format) -> Self {
        WriteOptions { format: Some(format), encoding: None }
    }

    /// These options with an encoding.
    pub fn with_encoding(self, encoding: Encoding) -> Self {
        WriteOptions { encoding: Some(encoding), ..self }
    }

    /// These options with the format of a file name, where they name none.
    pub fn for_path(self, path: &Path) -> Self {
        WriteOptions { format: self.format.or_else(|| Format::from_path(path)), ..self }
    }

    fn resolved(self) -> Result<(Format, Encoding), WriteErrorKind> {
        let format = self.format.ok_or(WriteErrorKind::UnknownFormat)?;
        let default = format.encodings().first().copied().unwrap_or(Encoding::Ascii);
        let encoding = self.encoding.unwrap_or(default);
        if format.encodings().contains(&encoding) {
            Ok((format, encoding))
        } else {
            Err(WriteErrorKind::NoSuchEncoding { format, encoding })
        }
    }
}

/// Writes a mesh to a file, all or nothing (see [`replace_file`]), and says what the format can't carry.
///
/// # Errors
/// When the name tells no format, the format has no such encoding, the mesh is too large for it or the system
/// can't write; an old file is then as it was.
///
/// *Cost*: linear; a small buffer.
pub fn write(path: &Path, mesh: &PolygonMesh, options: &WriteOptions) -> Result<Vec<Loss>, WriteError> {
    let failed = |kind| WriteError { file: path.display().to_string(), kind };
    let (format, encoding) = options.for_path(path).resolved().map_err(failed)?;
    replace_file(path, |out| (format.driver().encode)(mesh, encoding, out)).map_err(failed)?;
    Ok((format.driver().losses)(mesh, encoding))
}

/// Writes a mesh to any sink, and says what the format can't carry. The options must name a format.
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
    let (format, encoding) = options.resolved().map_err(failed)?;
    (format.driver().encode)(mesh, encoding, out).map_err(failed)?;
    Ok((format.driver().losses)(mesh, encoding))
}

/// What a file would not carry, without writing it. Options that can't be written with lose nothing.
///
/// *Cost*: linear in the mesh; sorting for formats without indices.
pub fn losses(mesh: &PolygonMesh, options: &WriteOptions) -> Vec<Loss> {
    match options.resolved() {
        Ok((format, encoding)) => (format.driver().losses)(mesh, encoding),
        Err(_) => Vec::new(),
    }
}
