//! Which faces of a mesh intersect, and how.
//!
//! What two faces have in common has one smallest cell in each: a corner, an edge or the whole face. The faces meet properly
//! when these are one corner or one edge, and else they intersect. See [`Contact`].

mod crossing_search;
mod hits;
mod join;
mod report;
mod run;
mod search;

pub use crossing_search::{CrossingSearch, do_cross};
pub use report::{Budget, FacePair, Figures, IntersectionOptions, Intersections};
pub use search::intersections;

/// What the search is called to whoever watches.
const STEP: &str = "crossings";
