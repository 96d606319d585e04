//! What a kernel is, what it admits, and the default one.

mod admission;
mod build;
mod capabilities;
mod connectivity;
mod edge_use;
mod stars;

pub use admission::{Refusal, admission};
pub use build::Build;
pub use capabilities::Capabilities;
pub use connectivity::{Connectivity, ManifoldConnectivity};
pub use edge_use::EdgeUse;
pub use stars::{
    EdgeClass, Umbrellas, VertexClass, edge_class, irregular_vertices, is_inconsistent, is_manifold,
    umbrellas, vertex_classes,
};
