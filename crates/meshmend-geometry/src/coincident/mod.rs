//! Which points are at one place.

mod coincidence;
mod equal_keys;
mod pose;
mod shared_finder;
mod shared_places;

pub use coincidence::{Coincidence, coincident_in_single, coincident_vertices, watched_coincident_vertices};
pub use pose::{equal_in_pose, near_in_pose};
pub use shared_finder::SharedFinder;
pub use shared_places::each_shared_place;
