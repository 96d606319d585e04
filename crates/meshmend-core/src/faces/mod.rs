//! Faces: as stored, and in normal form.

mod complex;
mod cycles;
mod error;
mod face_index;
mod face_table;
mod face_table_builder;

pub use complex::{Complex, normalised};
pub use cycles::{canonical_rotation, distinct_count};
pub use error::{FaceTableError, MAX_CORNERS};
pub use face_index::FaceIndex;
pub use face_table::FaceTable;
pub use face_table_builder::FaceTableBuilder;
