//! What happens to a mesh before it is written: each step once, whose losses are named once.

use std::io;
use std::path::Path;

use meshmend_core::{Draft, DraftError, PolygonMesh, Provenance, Sources};

use crate::formats::obj::companions;
use crate::output::atomic::replace_file;
use crate::shell::Shape;
use crate::{Encoding, Format, Loss, WriteError, WriteErrorKind, WriteOptions};

/// A mesh as one format will hold it, ready to be written.
///
/// ```
/// # use meshmend_io::{Format, Prepared, ReadOptions, WriteOptions, read_bytes};
/// let file = read_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "triangle.obj", &ReadOptions::default())?;
/// let prepared = Prepared::new(&file.mesh, &WriteOptions::of(Format::Ply).as_read(&file))?;
/// assert!(prepared.losses().is_empty());
/// let mut bytes = Vec::new();
/// prepared.encode(&mut bytes)?;
/// assert!(bytes.starts_with(b"ply\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Prepared {
    /// The mesh as it will be read again, apart from what the format can't carry.
    pub(crate) mesh: PolygonMesh,
    pub(crate) format: Format,
    pub(crate) encoding: Encoding,
    pub(crate) options: WriteOptions,
    /// What the steps before writing lost.
    pub(crate) losses: Vec<Loss>,
    /// Where its elements were as given, where vertices are written more than once or faces are cut.
    pub(crate) record: Option<Provenance>,
    /// The layers that were brought from the corners to the vertices, by their places.
    pub(crate) at_vertices: Vec<usize>,
}

impl Prepared {
    /// Makes a mesh ready. The options must name a format.
    ///
    /// # Errors
    /// When the options name no format, or an encoding that the format does not have, or say that a mesh with seams is not
    /// to be written.
    ///
    /// *Cost*: O(1), unless the format needs the mesh to be changed.
    pub fn new(mesh: &PolygonMesh, options: &WriteOptions) -> Result<Self, WriteErrorKind> {
        let (format, encoding) = options.resolved()?;
        let (mesh, options) = (mesh.clone(), options.clone());
        let mut prepared = Prepared {
            mesh,
            format,
            encoding,
            options,
            losses: Vec::new(),
            record: None,
            at_vertices: Vec::new(),
        };
        (format.driver().prepare)(&mut prepared)?;
        Ok(prepared)
    }

    /// In which format it will be written.
    pub fn format(&self) -> Format {
        self.format
    }

    /// How its numbers will be spelled.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// The mesh as it will be written: where the format made it necessary, not the one that was given.
    pub fn mesh(&self) -> &PolygonMesh {
        &self.mesh
    }

    /// The mesh that was given with the vertices and faces that it will be read with, and where those were; nothing if
    /// they are written as they are. Its layers are as they were given, but for their home.
    ///
    /// # Errors
    /// When it is not the mesh that was made ready.
    ///
    /// *Cost*: linear in the mesh and its layers.
    pub fn as_written(&self, given: &PolygonMesh) -> Result<Option<(PolygonMesh, Provenance)>, DraftError> {
        let Some(record) = &self.record else { return Ok(None) };
        if !self.format.holds_polygons() {
            return Ok(Some((self.mesh.clone(), record.clone())));
        }
        let counts = given.counts();
        let (faces, corners) = (Sources::same(counts.faces), Sources::same(counts.corners));
        let draft = Draft {
            vertex_sources: record.vertices.clone(),
            ..Draft::of_faces(given, self.mesh.faces().clone(), faces, corners)
        };
        let is_given = |&at: &usize| at < given.layers().len();
        let moved: Vec<usize> = self.at_vertices.iter().copied().filter(is_given).collect();
        given.rebuilt_with_vertex_layers(&moved, draft).map(Some)
    }

    /// What the file won't carry.
    ///
    /// *Cost*: linear in the mesh; sorting for formats without indices.
    pub fn losses(&self) -> Vec<Loss> {
        let mut losses = self.losses.clone();
        losses.extend((self.format.driver().losses)(self));
        if let (Some(Shape::Ply(shape)), true) = (self.shape(), self.format != Format::Ply) {
            losses.extend(shape.table_losses());
        }
        losses.extend(companions::loss(self));
        losses
    }

    /// Writes it to a file, all or nothing (see [`replace_file`]).
    ///
    /// # Errors
    /// When the mesh is too large for the format or the system can't write; an old file is then as it was.
    ///
    /// *Cost*: linear; a small buffer.
    pub fn write(&self, path: &Path) -> Result<(), WriteError> {
        let failed = |kind| WriteError { file: path.display().to_string(), kind };
        replace_file(path, |out| (self.format.driver().encode)(self, out)).map_err(failed)
    }

    /// Writes it to any sink.
    ///
    /// # Errors
    /// When the mesh is too large for the format or the sink fails.
    ///
    /// *Cost*: linear; a small buffer.
    pub fn encode(&self, out: &mut dyn io::Write) -> Result<(), WriteError> {
        let failed = |kind| WriteError { file: "output".to_owned(), kind };
        (self.format.driver().encode)(self, out).map_err(failed)
    }

    /// What the file that the mesh comes from lets a writer of its format choose.
    pub(crate) fn shape(&self) -> Option<&Shape> {
        self.options.shell.shape()
    }
}
