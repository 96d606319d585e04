//! The edges of a mesh, and the corners of each vertex.

mod edge_table;
mod grouping;
mod numbering;
pub(crate) mod vertex_corners;

pub use edge_table::{EdgeSide, EdgeTable};
