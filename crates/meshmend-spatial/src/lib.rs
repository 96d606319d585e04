//! Where the faces of a mesh lie, decided exactly: questions about distances, sides and intersections, without passes and
//! files.
//!
//! * [`exact`]: signs of real arithmetic on doubles, from which all else is decided.

pub mod exact;
