//! Cuts polygon meshes along edges.
//!
//! [`cut_open`] cuts along edges that the caller names, [`cut_to_discs`] opens every component into a disc, and
//! [`cut_to_square`] opens a torus into a square. Each result comes with its provenance, and says which two sides of
//! the boundary were one edge before.
//!
//! A cut is not a pass: it does not repair anything, and its result is no better than its input.

mod discs;
mod error;
mod open;
mod square;

pub use discs::{CutAlong, Discs, Piece, cut_to_discs};
pub use error::CutError;
pub use open::{CutOpen, CutSeam, cut_open};
pub use square::{SquareCut, cut_to_square};
