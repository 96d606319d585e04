//! How many elements a mesh has.

use serde::Serialize;

/// How many elements a mesh has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Vertices, unreferenced ones included.
    pub vertices: usize,
    /// Faces, degenerate ones included.
    pub faces: usize,
    /// Corners of all faces.
    pub corners: usize,
}
