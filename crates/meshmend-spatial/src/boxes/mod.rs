//! Boxes along the axes, and a tree that finds which of them overlap.

mod bounds;
mod few;
mod join;
mod tree;

pub use bounds::Bounds;
pub(crate) use few::FewBoxes;
pub use join::{JoinPart, Leaf};
pub use tree::{BoxTree, Query};
