//! The geometry that repairs and writers share. It knows points and meshes, but neither passes nor files.
//!
//! * Points: [`FreePoints`] finds room for new ones, [`vector`] is their arithmetic in doubles, [`coincident`] tells which are at one place, [`proximity`] which
//!   are within a distance, [`diagonal`] how large the box round them is, [`rounding`] what single precision does to them.
//! * Faces: [`polygon`] cuts one polygon in space into triangles, or at its holes; [`words`] finds the simple loops of a
//!   face; [`FaceCutter`] cuts the faces of a mesh into triangles.
//! * Meshes: [`edge_lengths`], and [`SignedVolume`] for closed patches.
//! * [`sorting`] sorts by exact predicates, which may contradict themselves where numbers underflow.

mod bounds;
pub mod coincident;
mod edge_lengths;
mod face_cutter;
mod free_points;
mod gathered_room;
pub mod polygon;
mod precision;
pub mod proximity;
pub mod rounding;
mod signed_volume;
pub mod sorting;
mod taken;
pub mod vector;
pub mod words;

pub use bounds::diagonal;
pub use edge_lengths::edge_lengths;
pub use face_cutter::{FaceCutter, OnDiagonal, Room};
pub use free_points::{FreePoints, Spacing};
pub use gathered_room::GatheredRoom;
pub use precision::Precision;
pub use signed_volume::SignedVolume;
pub use taken::Edges;
