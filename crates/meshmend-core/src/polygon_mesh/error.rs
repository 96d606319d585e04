//! Why parts don't make a mesh.

use thiserror::Error;

use crate::words::{counted, there_are};

/// Why parts don't make a mesh.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// The faces were made for another number of vertices.
    #[error("the faces are over {}, but {}", counted(faces, "vertex"), there_are(*positions, "position"))]
    VertexCount {
        /// What the face table says.
        faces: usize,
        /// How many positions there are.
        positions: usize,
    },
    /// A loose element names a vertex that does not exist.
    #[error("{what} {index} names vertex {vertex}, but {}", there_are(*vertex_count, "vertex"))]
    NoSuchVertex {
        /// `loose edge` or `loose point`.
        what: &'static str,
        /// Its place in its list.
        index: usize,
        /// The vertex that it names.
        vertex: u32,
        /// How many vertices there are.
        vertex_count: usize,
    },
    /// An attribute layer is not for this mesh.
    #[error("the layer `{name}` is for {}, but the mesh has {expected}", counted(found, "element"))]
    LayerSize {
        /// The layer's name.
        name: String,
        /// How many elements it speaks of.
        found: usize,
        /// How many the mesh has.
        expected: usize,
    },
    /// An attribute layer names a value that its pool does not hold.
    #[error("the layer `{name}` uses values that it does not have")]
    LayerValues {
        /// The layer's name.
        name: String,
    },
}
