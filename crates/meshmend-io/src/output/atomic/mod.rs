//! Files that are replaced all at once, or not at all.

mod disk;
mod file_system;
mod replace;
mod standing;
mod temporary;
mod together;

pub use self::replace::{replace_file, target_of};
pub use self::temporary::abandon_temporary_files;
pub(crate) use self::together::{NewFile, replace_together};
