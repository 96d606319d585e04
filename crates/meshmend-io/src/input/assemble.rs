//! The last step of all readers: every index is checked once, and the parts become a mesh.

use meshmend_core::{
    FaceTableBuilder, Id, Layer, MeshError, Metadata, PolygonMesh, Role, SharedPlaces, VertexId, counted,
};
use meshmend_geometry::vector::is_finite;

use crate::input::indices::MaxIndex;
use crate::input::notes::Notes;
use crate::input::source::Source;
use crate::layers::is_numeric;
use crate::{Limits, NoteKind, Place, ReadError};

/// What a reader collects.
#[derive(Default)]
pub(crate) struct Parts {
    pub(crate) positions: Vec<[f64; 3]>,
    /// The places of all vertices, in place of positions, if it is known which of them share one.
    pub(crate) places: Option<SharedPlaces>,
    pub(crate) faces: FaceTableBuilder,
    pub(crate) loose_edges: Vec<[VertexId; 2]>,
    pub(crate) loose_points: Vec<VertexId>,
    pub(crate) layers: Vec<Layer>,
    pub(crate) metadata: Vec<Metadata>,
    pub(crate) max_index: MaxIndex,
    pub(crate) notes: Notes,
}

impl Parts {
    /// Keeps a comment or another statement about the whole file, up to the limit.
    pub(crate) fn keep_statement(
        &mut self,
        key: &str,
        value: &[u8],
        limits: &Limits,
        place: impl FnOnce() -> Place,
    ) {
        if self.metadata.len() < limits.max_comments {
            self.metadata.push(Metadata { key: key.to_owned(), value: value.to_vec() });
        } else {
            self.notes.add(NoteKind::SkippedComment, "comments beyond the limit were skipped", place);
        }
    }

    /// Appends faces that were parsed elsewhere, with the highest index in them.
    pub(crate) fn take_faces(&mut self, faces: &FaceTableBuilder, max_index: MaxIndex) {
        self.faces.append(faces);
        self.max_index.see_all(max_index);
    }

    /// The mesh, or an error at the highest index if no vertex has it. `first` is the number that the format gives
    /// the first vertex.
    pub(crate) fn assemble(
        mut self,
        source: &Source<'_>,
        first: u64,
        place: impl Fn(usize) -> Place,
    ) -> Result<(PolygonMesh, Notes), ReadError> {
        let count = self.places.as_ref().map_or(self.positions.len(), |places| places.of_vertex().len());
        if let Some((index, at)) = self.max_index.beyond(count) {
            let number = u64::from(index) + first;
            return Err(source.malformed(place(at), no_such_vertex(number as i64, count)));
        }
        VertexNotes { vertices: count as u64, infinite: self.infinite() }.note(&mut self.notes);
        // The limits of readers are those of a mesh, so all of this fits.
        let faces = self.faces.build(count).map_err(|e| source.malformed(Place::File, e.to_string()))?;
        let failed = |error: MeshError| source.malformed(Place::File, error.to_string());
        let mesh = match self.places {
            Some(places) => PolygonMesh::of_shared_places(places, faces),
            None => PolygonMesh::new(self.positions, faces),
        };
        let mesh = mesh.map_err(failed)?;
        let mesh = mesh.with_loose(self.loose_edges, self.loose_points).map_err(failed)?;
        let layers = self.layers.into_iter().map(with_usual_role).collect();
        let mesh = mesh.with_layers(layers).map_err(failed)?;
        Ok((mesh.with_metadata(self.metadata), self.notes))
    }
}

impl Parts {
    /// How many vertices have a position that is not finite.
    fn infinite(&self) -> u64 {
        let is_infinite = |point: &[f64; 3]| !is_finite(point);
        let Some(places) = &self.places else {
            return self.positions.iter().filter(|point| is_infinite(point)).count() as u64;
        };
        if !places.points().iter().any(is_infinite) {
            return 0;
        }
        let point = |place: &&VertexId| is_infinite(&places.points()[place.index()]);
        places.of_vertex().iter().filter(point).count() as u64
    }
}

/// What there is to say about the vertices of a file.
#[derive(Default)]
pub(crate) struct VertexNotes {
    vertices: u64,
    infinite: u64,
}

impl VertexNotes {
    /// Takes in the next vertices.
    #[inline]
    pub(crate) fn see(&mut self, positions: &[[f64; 3]]) {
        self.vertices += positions.len() as u64;
        self.infinite += positions.iter().filter(|point| !is_finite(point)).count() as u64;
    }

    pub(crate) fn note(&self, notes: &mut Notes) {
        let message = "vertices whose position is not finite";
        notes.add_many(NoteKind::NonFinite, message, self.infinite, || Place::File);
        if self.vertices == 0 {
            notes.add(NoteKind::Empty, "the file holds no vertex", || Place::File);
        }
    }
}

/// A layer with the role that its name and width stand for in every format.
fn with_usual_role(layer: Layer) -> Layer {
    let role = match (layer.name(), layer.width()) {
        _ if !is_numeric(&layer) || layer.role() != Role::Plain => layer.role(),
        ("normal", 3) => Role::Normal,
        ("texcoord", _) => Role::TexCoord,
        ("color", 3 | 4) => Role::Color,
        (_, _) => Role::Plain,
    };
    layer.with_role(role)
}

/// The reason when a file names a vertex that does not exist.
pub(crate) fn no_such_vertex(number: i64, count: usize) -> String {
    format!("vertex {number} does not exist: the file has {}", counted(count, "vertex"))
}
