//! What happens to a mesh before and while it is written. Each step runs once, so its losses are named once.

use std::io;
use std::path::Path;

use meshmend_core::PolygonMesh;

use crate::formats::drivers::driver;
use crate::{Loss, Prepared, WriteError, WriteErrorKind, WriteOptions, replace_file};

impl Prepared {
    /// Makes a mesh ready. The options must name a format.
    ///
    /// # Errors
    /// If the options name no format, name an encoding that the format lacks, or forbid to write a mesh with seams.
    ///
    /// *Cost*: O(1), unless the format needs the mesh to be changed.
    pub fn new(mesh: &PolygonMesh, options: &WriteOptions) -> Result<Self, WriteErrorKind> {
        let (format, encoding) = options.resolved()?;
        let mut prepared = Prepared {
            given: mesh.clone(),
            mesh: mesh.clone(),
            format,
            encoding,
            options: options.clone(),
            losses: Vec::new(),
            record: None,
            at_vertices: Vec::new(),
        };
        prepared.turn_textures()?;
        (driver(format).prepare)(&mut prepared)?;
        Ok(prepared)
    }

    /// What the file won't carry.
    ///
    /// *Cost*: linear in the mesh; sorting for formats without indices.
    pub fn losses(&self) -> Vec<Loss> {
        let mut losses = self.losses.clone();
        losses.extend((driver(self.format).losses)(self));
        losses.extend(self.options.shell.losses_in(self.format, self.options.folder.as_deref()));
        losses
    }

    /// Writes it to a file, whole or not at all (see [`replace_file`]).
    ///
    /// # Errors
    /// If the mesh is too large for the format or the system can't write. An old file then stays as it was.
    ///
    /// *Cost*: linear; a small buffer.
    pub fn write(&self, path: &Path) -> Result<(), WriteError> {
        let failed = |kind| WriteError { file: path.display().to_string(), kind };
        replace_file(path, |out| (driver(self.format).encode)(self, out)).map_err(failed)
    }

    /// Writes it to any sink.
    ///
    /// # Errors
    /// If the mesh is too large for the format or the sink fails.
    ///
    /// *Cost*: linear; a small buffer.
    pub fn encode(&self, out: &mut dyn io::Write) -> Result<(), WriteError> {
        let failed = |kind| WriteError { file: "output".to_owned(), kind };
        (driver(self.format).encode)(self, out).map_err(failed)
    }
}
