//! Random meshes, each changed in a way whose effect on every figure is known, whatever the mesh.
//!
//! * [`names`]: what a mesh is called and where it lies is no part of its topology.
//! * [`sums`]: meshes beside one another add up; a handle, a cross-cap and a hole count as one.
//! * [`planted`]: what was done to a sound mesh is found, and nothing else, and is mended.
//! * [`repairs`]: what a repair makes of a mesh does not depend on names, places in lists or units.

mod figures;
mod names;
mod planted;
mod repairs;
mod sums;
