//! Where the faces of a mesh lie, decided exactly: questions about distances, sides and intersections, without passes and
//! files.
//!
//! * [`exact`]: signs of real arithmetic on doubles, from which all else is decided.
//! * Shape: [`shapes`] finds the faces that are too thin, [`sliver_kind`] and [`compare_aspects`] judge triangles,
//!   [`is_straight`] points.

pub mod exact;
mod shape;

pub use shape::{Shapes, Sliver, SliverKind, compare_aspects, is_straight, shapes, sliver_kind};
