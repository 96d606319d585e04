//! Components, their boundaries, and what the classification theorem calls them.

mod boundary;
pub(crate) mod component_kinds;
mod components;
mod gluing;
mod permutations;
mod surface;

pub use boundary::{BoundaryLoops, boundary_loops};
pub use component_kinds::{ComponentFacts, ComponentKind, component_facts, component_kinds};
pub use components::{Components, components};
pub use gluing::{GluingWord, Letter};
pub use permutations::{Permutations, permutations};
pub use surface::{Surface, surface_name};
