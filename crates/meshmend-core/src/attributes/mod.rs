//! Attribute layers: values, what they mean, and what becomes of them.

mod differences;
mod layer;
mod parts;
mod pooling;
mod role;
pub(crate) mod turning;
mod values;

pub use differences::{Aspect, Differences};
pub use layer::{Carry, Domain, Layer, NO_VALUE};
pub use parts::LayerParts;
pub use role::{FlippedNormals, Role};
pub use turning::turned_normals;
pub use values::Values;
