//! What happens to a mesh before and while it is written. Each step runs once, so its losses are named once.

use std::io;
use std::path::Path;

use meshmend_core::PolygonMesh;

use crate::formats::drivers::driver;
use crate::output::companions::{unnamed_loss, write_with};
use crate::shell::{NamedContent, NamedFile};
use crate::watched::WatchedWrite;
use crate::{Encoding, Format, Loss, Prepared, WriteError, WriteErrorKind, WriteOptions};

impl Prepared {
    /// Makes a mesh ready. The options must name a format.
    ///
    /// # Errors
    /// If the options name no format, name an encoding that the format lacks, or forbid to write a mesh with seams.
    ///
    /// *Cost*: O(1), unless the format needs the mesh to be changed.
    pub fn new(mesh: &PolygonMesh, options: &WriteOptions) -> Result<Self, WriteErrorKind> {
        let (format, encoding) = options.resolved()?;
        let mut prepared = Prepared::as_given(mesh, format, encoding, options.clone());
        options.watch.look("prepare", 0, 0)?;
        prepared.turn_textures()?;
        (driver(format).prepare)(&mut prepared)?;
        let copies = options.copies(prepared.named.iter().map(|name| &name[..]));
        prepared.companions.extend(copies);
        Ok(prepared)
    }

    /// A mesh as it is, to which nothing was done yet.
    pub(crate) fn as_given(
        mesh: &PolygonMesh,
        format: Format,
        encoding: Encoding,
        options: WriteOptions,
    ) -> Self {
        Prepared {
            given: mesh.clone(),
            mesh: mesh.clone(),
            format,
            encoding,
            options,
            losses: Vec::new(),
            record: None,
            companions: Vec::new(),
            named: Vec::new(),
            held: Vec::new(),
            at_vertices: Vec::new(),
        }
    }

    /// What the file won't carry.
    ///
    /// *Cost*: linear in the mesh; sorting for formats without indices.
    pub fn losses(&self) -> Vec<Loss> {
        let mut losses = self.losses.clone();
        losses.extend((driver(self.format).losses)(self));
        losses.extend(self.options.shell.losses_in(self.format));
        losses.extend(self.companion_losses());
        losses
    }

    /// Writes it to a file, whole or not at all (see [`replace_file`](crate::replace_file)), and the files that are to
    /// stand beside it.
    ///
    /// # Errors
    /// If the mesh is too large for the format, the system can't write, or another file has the name of one that is to
    /// stand beside it. All old files then stay as they were.
    ///
    /// *Cost*: linear; a small buffer.
    pub fn write(&self, path: &Path) -> Result<(), WriteError> {
        let failed = |kind| WriteError { file: path.display().to_string(), kind };
        write_with(path, &self.companions, |out| self.encode_watched(out)).map_err(failed)
    }

    /// The losses of the files that the input names.
    fn companion_losses(&self) -> impl Iterator<Item = Loss> {
        let files = self.options.shell.companions();
        let (named, left): (Vec<NamedFile>, Vec<NamedFile>) =
            files.into_iter().partition(|file| self.named.contains(&file.name));
        let is_lost =
            |file: &&NamedFile| file.content != NamedContent::Buffer && !self.held.contains(&file.name);
        let left: Vec<&[u8]> = left.iter().filter(is_lost).map(|file| &file.name[..]).collect();
        self.options.stay_loss(&named).into_iter().chain(unnamed_loss(&left))
    }

    /// Writes it to any sink.
    ///
    /// # Errors
    /// If the mesh is too large for the format or the sink fails.
    ///
    /// *Cost*: linear; a small buffer.
    pub fn encode(&self, out: &mut dyn io::Write) -> Result<(), WriteError> {
        let failed = |kind| WriteError { file: "output".to_owned(), kind };
        self.encode_watched(out).map_err(failed)
    }

    fn encode_watched(&self, out: &mut dyn io::Write) -> Result<(), WriteErrorKind> {
        (driver(self.format).encode)(self, &mut WatchedWrite::new(out, &self.options.watch))
    }
}
