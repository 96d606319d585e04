//! What all readers do last: check every index once, and put the parts together.

use meshmend_core::{FaceTableBuilder, Layer, MeshError, Metadata, PolygonMesh, Role, VertexId, counted};

use crate::note::Notes;
use crate::output::layers::is_numeric;
use crate::read::Source;
use crate::{Limits, NoteKind, Place, ReadError};

/// What a reader collects.
#[derive(Default)]
pub(crate) struct Parts {
    pub(crate) positions: Vec<[f64; 3]>,
    pub(crate) faces: FaceTableBuilder,
    pub(crate) loose_edges: Vec<[VertexId; 2]>,
    pub(crate) loose_points: Vec<VertexId>,
    pub(crate) layers: Vec<Layer>,
    pub(crate) metadata: Vec<Metadata>,
    pub(crate) highest: MaxIndex,
    pub(crate) notes: Notes,
}

/// The highest index that was read, and the first place where. Faces may come before the vertices that they
/// name, so an index can be checked only when all is read; then the highest speaks for all.
#[derive(Clone, Copy, Default)]
pub(crate) struct MaxIndex {
    found: Option<(u32, usize)>,
}

impl MaxIndex {
    #[inline]
    pub(crate) fn see(&mut self, index: u32, at: usize) {
        if self.found.is_none_or(|(highest, _)| index > highest) {
            self.found = Some((index, at));
        }
    }

    /// Sees what another one has seen at later places.
    pub(crate) fn see_all(&mut self, later: MaxIndex) {
        if let Some((index, at)) = later.found {
            self.see(index, at);
        }
    }

    /// The highest index and its place, if it is not below the count.
    pub(crate) fn beyond(self, count: usize) -> Option<(u32, usize)> {
        self.found.filter(|&(index, _)| index as usize >= count)
    }
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

    /// Takes faces that were parsed elsewhere and come after all that are here, with the highest index in them.
    pub(crate) fn take_faces(&mut self, faces: &FaceTableBuilder, highest: MaxIndex) {
        self.faces.append(faces);
        self.highest.see_all(highest);
    }

    /// The mesh, or an error at the highest index if there is no such vertex. `first` is the number of the first
    /// vertex as the format counts.
    pub(crate) fn assemble(
        mut self,
        source: &Source<'_>,
        first: u64,
        place: impl Fn(usize) -> Place,
    ) -> Result<(PolygonMesh, Notes), ReadError> {
        let count = self.positions.len();
        if let Some((index, at)) = self.highest.beyond(count) {
            let number = u64::from(index) + first;
            return Err(source.malformed(place(at), no_such_vertex(number as i64, count)));
        }
        let infinite = self.positions.iter().filter(|p| !p.iter().all(|x| x.is_finite())).count() as u64;
        let message = "vertices whose position is not finite";
        self.notes.add_many(NoteKind::NonFinite, message, infinite, || Place::File);
        if count == 0 {
            self.notes.add(NoteKind::Empty, "the file holds no vertex", || Place::File);
        }
        // Readers keep to limits within which all of this fits a mesh.
        let faces = self.faces.build(count).map_err(|e| source.malformed(Place::File, e.to_string()))?;
        let failed = |error: MeshError| source.malformed(Place::File, error.to_string());
        let mesh = PolygonMesh::new(self.positions, faces).map_err(failed)?;
        let mesh = mesh.with_loose(self.loose_edges, self.loose_points).map_err(failed)?;
        let layers = self.layers.into_iter().map(with_usual_role).collect();
        let mesh = mesh.with_layers(layers).map_err(failed)?;
        Ok((mesh.with_metadata(self.metadata), self.notes))
    }
}

/// A layer with the role that its name and width have in every format that is read.
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

/// The reason when a file names a vertex that it does not hold.
pub(crate) fn no_such_vertex(number: i64, count: usize) -> String {
    format!("vertex {number} does not exist: the file has {}", counted(count, "vertex"))
}

/// A corner attribute that is named by index: which value each corner uses, none until one is named.
#[derive(Default)]
pub(crate) struct Uses {
    uses: Vec<u32>,
    highest: MaxIndex,
}

impl Uses {
    /// Lets an element use a value; elements before it that were given none have none.
    #[inline]
    pub(crate) fn set(&mut self, element: usize, value: u32, at: usize) {
        self.uses.resize(element, meshmend_core::NO_VALUE);
        self.uses.push(value);
        self.highest.see(value, at);
    }

    /// Lets the element after all that have a value use one.
    #[inline]
    pub(crate) fn push(&mut self, value: u32, at: usize) {
        self.uses.push(value);
        self.highest.see(value, at);
    }

    /// Lets as many elements from this one on use what those of another list use, which come later in the file.
    pub(crate) fn append(&mut self, element: usize, later: &Uses) {
        if !later.is_empty() {
            self.uses.resize(element, meshmend_core::NO_VALUE);
            self.uses.extend_from_slice(&later.uses);
            self.highest.see_all(later.highest);
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.uses.is_empty()
    }

    /// How many elements there are up to the last one that was given a value.
    pub(crate) fn len(&self) -> usize {
        self.uses.len()
    }

    /// Forgets all uses, and keeps the memory for others.
    pub(crate) fn clear(&mut self) {
        self.return_to((0, MaxIndex::default()));
    }

    /// What to return to when what follows is to be forgotten.
    #[inline]
    pub(crate) fn mark(&self) -> (usize, MaxIndex) {
        (self.uses.len(), self.highest)
    }

    /// Forgets what came after a mark.
    #[inline]
    pub(crate) fn return_to(&mut self, (length, highest): (usize, MaxIndex)) {
        self.uses.truncate(length);
        self.highest = highest;
    }

    /// The uses of all elements; values that don't exist are counted, with the place of the highest, and taken
    /// away.
    pub(crate) fn checked(mut self, elements: usize, values: usize) -> (Vec<u32>, Option<(u64, usize)>) {
        self.uses.resize(elements, meshmend_core::NO_VALUE);
        let Some((_, at)) = self.highest.beyond(values) else {
            return (self.uses, None);
        };
        let mut wrong = 0;
        for slot in &mut self.uses {
            if *slot != meshmend_core::NO_VALUE && *slot as usize >= values {
                *slot = meshmend_core::NO_VALUE;
                wrong += 1;
            }
        }
        (self.uses, Some((wrong, at)))
    }
}
