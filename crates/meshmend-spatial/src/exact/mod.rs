//! Signs of real arithmetic on coordinates as doubles, for all finite doubles.
//!
//! Each question is answered in up to four steps: a sum in doubles with a bound of its error; whole numbers of 128 bits, the
//! coordinates times a common power of two; expansions ([`robust`]), where no product can under- or overflow; else whole
//! numbers of any size.
//! Coordinates that are not finite get some answer.

mod centroid;
pub(crate) mod integers;
mod lines;
pub(crate) mod nearest;
mod sides;
mod sign;
mod volume;

pub use centroid::Centroid;
pub use lines::{are_collinear, are_in_same_half_plane, compare_along, projection_of};
pub use sides::{Axis, Plane, side_of_plane, turn, turn_along};
pub use sign::Sign;
pub use volume::volume_sign;
