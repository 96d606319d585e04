//! A mesh with what is true of it.

use meshmend_core::PolygonMesh;

use crate::truth::Truth;

/// A mesh and what is true of it.
#[derive(Clone, Debug)]
pub struct Shape {
    /// What it is called, with its sizes.
    pub name: String,
    /// The mesh.
    pub mesh: PolygonMesh,
    /// Its figures.
    pub truth: Truth,
}
