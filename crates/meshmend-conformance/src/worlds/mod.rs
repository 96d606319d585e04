//! The meshes on which laws are asked: every small one, shapes, random tables, and families of any size.

mod families;
mod random;
mod sets;
mod shapes;
mod shrink;
mod tables;
mod world;

pub(crate) use families::{FAMILIES, Family, sized_meshes};
pub(crate) use shrink::shrunk;
pub(crate) use world::World;

pub use sets::{oriented_triangle_sets, triangle_sets};
