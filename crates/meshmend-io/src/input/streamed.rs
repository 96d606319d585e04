//! A file row by row: for those who can't hold its mesh.

use meshmend_core::{Cancelled, VertexId};

use crate::input::notes::Notes;
use crate::{Encoding, Format, Note};

/// Takes the vertices and faces of a file in the order in which they stand there.
///
/// What it answers with an error ends the reading, which then fails as
/// [cancelled](crate::ReadErrorKind::Cancelled). A sink that has more to say keeps it.
///
/// # Errors
/// Each answer is [`Cancelled`] if the sink wants no more.
pub trait MeshSink: Send {
    /// Is told what will come, before any of it.
    fn begin(&mut self, announced: &Announced) -> Result<(), Cancelled>;

    /// Takes the next vertices.
    fn vertices(&mut self, positions: &[[f64; 3]]) -> Result<(), Cancelled>;

    /// Takes the next face, as stored. Each of its vertices is below the number that was announced.
    fn face(&mut self, vertices: &[VertexId]) -> Result<(), Cancelled>;
}

/// What a file says that it holds. Its length bears it out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Announced {
    /// In which format.
    pub format: Format,
    /// How many vertices.
    pub vertices: u64,
    /// How many faces.
    pub faces: u64,
    /// How many corners at most; as many as the bytes of the file can hold.
    pub corners: u64,
    /// Whether all coordinates are stored in single precision.
    pub is_single: bool,
    /// Whether each face has three vertices of its own, in the order of the faces.
    pub is_soup: bool,
}

/// What is known of a file when all of it was handed over.
#[derive(Clone, Debug)]
pub struct Streamed {
    /// The format.
    pub format: Format,
    /// Which form of the format, such as `ply-le`.
    pub variant: &'static str,
    /// What there is to say about the file: the same that [`read`](crate::read) says.
    pub notes: Vec<Note>,
    /// Edges that are elements of their own.
    pub loose_edges: Vec<[VertexId; 2]>,
}

/// What a format's reader knows when it has handed over all rows.
pub(crate) struct Rows {
    pub(crate) encoding: Encoding,
    pub(crate) notes: Notes,
    pub(crate) loose_edges: Vec<[VertexId; 2]>,
}
