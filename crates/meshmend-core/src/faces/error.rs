//! Why a list of faces is not a face table.

use thiserror::Error;

use crate::words::there_are;

/// A table holds fewer corners (and vertices, and faces) than this.
pub const MAX_CORNERS: usize = 1 << 31;

/// Why a list of faces is not a face table.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum FaceTableError {
    /// A corner names a vertex that does not exist.
    #[error("face {face} names vertex {vertex}, but {}", there_are(*vertex_count, "vertex"))]
    NoSuchVertex {
        /// The face, by its place.
        face: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
    /// There are more elements than ids.
    #[error("{count} {what} are more than the {MAX_CORNERS} that a table holds")]
    TooLarge {
        /// Which elements.
        what: &'static str,
        /// How many of them.
        count: usize,
    },
    /// The starts don't ascend from 0 to the number of corners.
    #[error("the starts of the faces do not ascend from 0 to {corner_count}")]
    BadStarts {
        /// How many corners there are.
        corner_count: usize,
    },
}
