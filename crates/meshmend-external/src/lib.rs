//! The topology of meshes that are larger than memory, in parts on disk.
//!
//! A mesh of 10⁹ triangles takes 12 GB for its corners alone, and 54 with its edges. Here its file is read from the beginning to the end a
//! few times, and what has to be looked at together is brought together on disk:
//!
//! | step | on disk | in memory |
//! |---|---|---|
//! | equal positions | positions by a hash of what they are in single precision | one part |
//! | components | – | union-find: 4 bytes a vertex |
//! | faces | each in the parts, by ranges of vertices, in which it has a vertex | blocks |
//! | edges, vertices, repeated faces | – | one part, as a mesh with the table of edges that meshes in memory have |
//! | patches and their sides | uses of edges of degree 3 or more | union-find with sides: 4 bytes a face |
//! | boundary loops | edges of degree 1 | union-find: 4 bytes a vertex |
//! | component kinds | facts of components, by ranges of components | one part |
//! | what is listed | – | the faces round it |
//!
//! A part answers for the vertices of its range, and for the edges whose lower end is one of them: their stars are whole in it. Its
//! vertices have new numbers in the same order, so edges come in the order of the whole mesh, and one running count numbers them.
//!
//! What is on disk lies in files without a name, which are gone with the process, however it ends.
//!
//! *Source*: for bringing together by ranges, and for looking at parts as at whole meshes: S. McMains, J. M. Hellerstein, C. H. Séquin,
//! *Out-of-core build of a topological data structure from polygon soup*, 2001.

mod boundary;
mod budget;
mod check;
mod components;
mod error;
mod excerpt;
mod face_parts;
mod faces;
mod lists;
mod lowest;
mod part;
mod patches;
mod places;
mod ranked;
mod sides;
mod sinks;
mod spill;
mod survey;

pub use check::{ExternalCheck, ExternalOptions, external_check};
pub use error::ExternalError;
pub use excerpt::Excerpt;
