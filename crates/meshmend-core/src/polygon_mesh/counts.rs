//! How many elements a mesh has.

/// How many elements a mesh has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Counts {
    /// Vertices, unreferenced ones included.
    pub vertices: usize,
    /// Faces, degenerate ones included.
    pub faces: usize,
    /// Corners of all faces.
    pub corners: usize,
}
