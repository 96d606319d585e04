//! A mesh that is ready to be written.

use meshmend_core::{Draft, DraftError, PolygonMesh, Provenance, Sources};

use crate::shell::Shape;
use crate::{Encoding, Format, Loss, WriteOptions};

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

    /// What the file that the mesh comes from lets a writer of its format choose, if it has the format whose choices are of
    /// this type.
    pub(crate) fn shape<T: Shape>(&self) -> Option<&T> {
        self.options.shell.shape()
    }
}
