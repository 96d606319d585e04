//! Which points are within a distance of each other.

mod classes;
mod grid;
mod nearness;
mod neighbour_cells;

pub use classes::{NoClasses, proximity_classes};
pub use nearness::Nearness;
