//! Cuts one polygon in space into triangles by shape, or at its holes into simple polygons.
//!
//! Up to 64 corners the best of all triangulations is found: no triangle lies the wrong way round if that is possible, none
//! is without an area, no diagonal is taken, and what is left is decided by shape. Larger polygons are cut by ears in
//! the plane of their area vector, and those for which that takes n² steps or fails, by a sweep. Where both fail (a
//! polygon that crosses itself) it is cut in halves again and again.

mod best;
mod corners;
mod cost;
mod outline;
mod pieces;
mod projection;
mod sweep;
mod sweep_chains;
mod sweep_line;
mod triangulate;
mod turning;
mod walks;

pub use corners::{Polygon, Triangle};
pub use cost::Avoid;
pub use pieces::{has_hole, simple_pieces};
pub use triangulate::triangulate_polygon;
pub use turning::ExactArea;
