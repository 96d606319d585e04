//! Boxes along the axes, and a tree that finds which of them overlap.

mod bounds;
mod tree;

pub use bounds::Bounds;
pub use tree::{BoxTree, Query};
