//! A file is replaced all at once, or not at all.
use std::io;
use std::path::Path;

use crate::WriteErrorKind;

/// Replaces a file by what a closure writes.
pub fn replace_file(path: &Path, fill: impl FnOnce(&mut dyn io::Write) -> Result<(), WriteErrorKind>) -> Result<(), WriteErrorKind> {
    let mut file = std::fs::File::create(path)?;
    fill(&mut file)
}
