//! A mesh that is ready to be written.

use std::sync::Arc;

use meshmend_core::{Draft, DraftError, PolygonMesh, Provenance, Sources};

use crate::output::companions::Companion;
use crate::shell::Shape;
use crate::{Encoding, Format, Loss, Material, WriteOptions};

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
    /// The mesh that was to be made ready.
    pub(crate) given: PolygonMesh,
    /// The mesh as it will be read again, but for what the format can't carry.
    pub(crate) mesh: PolygonMesh,
    pub(crate) format: Format,
    pub(crate) encoding: Encoding,
    pub(crate) options: WriteOptions,
    /// What was lost before writing.
    pub(crate) losses: Vec<Loss>,
    /// Where its elements were in the given mesh, if vertices are written more than once or faces are cut.
    pub(crate) record: Option<Provenance>,
    /// The files that are to stand beside it, as far as they are not there.
    pub(crate) companions: Vec<Companion>,
    /// The files that the input names and the output names as well.
    pub(crate) named: Vec<Vec<u8>>,
    /// The files that the input names and whose content is in the output.
    pub(crate) held: Vec<Vec<u8>>,
    /// The places of the layers that were moved from the corners to the vertices.
    pub(crate) at_vertices: Vec<usize>,
}

impl Prepared {
    /// The format in which it will be written.
    pub fn format(&self) -> Format {
        self.format
    }

    /// The encoding in which it will be written.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// The mesh as it will be written. It differs from the given one if the format requires that.
    pub fn mesh(&self) -> &PolygonMesh {
        &self.mesh
    }

    /// The given mesh with the vertices and faces of the file, and a record of where those were. Returns `None` if
    /// they are written as they are. The layers are those of the given mesh, at the elements where the file has them.
    ///
    /// # Errors
    /// If it is not the mesh that was made ready.
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

    /// Puts another mesh in the place of this one, and adds to the record where its elements were in this one.
    pub(crate) fn become_mesh(&mut self, mesh: PolygonMesh, record: Provenance) {
        let whole = match self.record.take() {
            Some(before) => before.then(&record, self.given.faces(), mesh.faces()),
            None => record,
        };
        (self.mesh, self.record) = (mesh, Some(whole));
    }

    /// What the materials look like, as the options say or else the file that the mesh comes from.
    pub(crate) fn materials(&self) -> Arc<[Material]> {
        self.options.materials.clone().unwrap_or_else(|| self.options.shell.materials())
    }

    /// The choices of the file that the mesh comes from, if it has the format of this type.
    pub(crate) fn shape<T: Shape>(&self) -> Option<&T> {
        self.options.shell.shape()
    }
}
