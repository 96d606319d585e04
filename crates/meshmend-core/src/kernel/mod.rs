//! What a kernel is, what it admits, and the default one.

mod admission;
mod arrays;
mod build;
mod capabilities;
mod connectivity;
mod costs;
mod edge_use;
mod grouped;
mod ladder;
mod lesson;
mod oriented_surface;
mod pointers;
mod stars;
mod task;

pub use admission::{Refusal, admission};
pub use arrays::{Array, Per};
pub use build::Build;
pub use capabilities::Capabilities;
pub use connectivity::{Connectivity, ManifoldConnectivity};
pub use costs::{Cost, Costs};
pub use edge_use::EdgeUse;
pub use grouped::Grouped;
pub use ladder::{Adjacency, Incidence};
pub use lesson::Lesson;
pub use pointers::{Cell, CellError, Pointer, Target};
pub use stars::{
    EdgeClass, Umbrellas, VertexClass, edge_class, irregular_vertices, is_inconsistent, is_manifold,
    umbrellas, vertex_classes, vertex_classes_in,
};
pub use task::KernelTask;
