//! Why a list of faces is not a face table.

use thiserror::Error;

use crate::words::{counted, there_are};

/// A table holds fewer corners (and vertices, and faces) than this.
pub const MAX_CORNERS: usize = 1 << 31;

/// Why a list of faces is not a face table.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum FaceTableError {
    /// A corner names a vertex that does not exist.
    #[error("corner {corner} of face {face} names vertex {vertex}, but {}", there_are(*vertex_count, "vertex"))]
    NoSuchVertex {
        /// The face, by its place.
        face: usize,
        /// The corner, by its place in the face.
        corner: usize,
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
    /// The corners don't make whole triangles.
    #[error("{} can't be cut into triangles of three", counted(corner_count, "corner"))]
    NotTriangles {
        /// How many corners there are.
        corner_count: usize,
    },
    /// There are more or fewer corners than the faces have.
    #[error("the faces have {}, but {}", counted(expected, "corner"), there_are(*found, "corner"))]
    CornerCount {
        /// How many there are.
        found: usize,
        /// How many the faces have.
        expected: usize,
    },
    /// There are no starts; even a table without a face has one, the end of its corners.
    #[error("the starts of the faces are empty; without a face they are [0]")]
    NoStarts,
    /// The first face begins after the first corner.
    #[error("the first of the starts is {start}, not 0")]
    FirstStart {
        /// The first start.
        start: u32,
    },
    /// A face ends before it begins.
    #[error("face {face} begins at corner {start} and ends before it, at corner {end}")]
    Descending {
        /// The face, by its place.
        face: usize,
        /// Where it begins.
        start: u32,
        /// Where it ends.
        end: u32,
    },
    /// The last start is not the number of corners.
    #[error("the last of the starts is {start}, but {}", there_are(*corner_count, "corner"))]
    LastStart {
        /// The last start.
        start: u32,
        /// How many corners there are.
        corner_count: usize,
    },
}
