//! The geometry that repairs and writers share: it knows points, and nothing of passes or files.
//!
//! [`FaceCutter`] cuts faces of a mesh into triangles; [`polygon`] cuts one polygon in space into triangles, or at its
//! holes; [`words`] tells the simple loops of a face; [`vector`] is the arithmetic of points in doubles; [`sorting`] sorts
//! by exact predicates, which may contradict themselves where numbers underflow; [`places`] tells which points are one;
//! [`rounding`] tells what single precision does to points and faces.

mod face_cutter;
pub mod places;
pub mod polygon;
pub mod rounding;
pub mod sorting;
mod taken;
pub mod vector;
pub mod words;

pub use face_cutter::{FaceCutter, OnDiagonal, Room};
