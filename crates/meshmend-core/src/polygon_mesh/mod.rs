//! The mesh as a value.

mod arrays;
mod counts;
mod error;
mod mesh;
mod metadata;
pub(crate) mod points;

pub use arrays::MeshArrays;
pub use counts::Counts;
pub use error::MeshError;
pub use mesh::PolygonMesh;
pub use metadata::Metadata;
pub use points::SharedPlaces;
