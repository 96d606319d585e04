//! What replacing a file asks of a file system.

use std::io::{self, Write};
use std::path::Path;

use super::standing::Standing;

/// What it takes to put a new file in the place of an old one; apart, so that every step can be made to fail.
pub(super) trait FileSystem {
    type File: Write;
    /// Makes a file that is not there yet. If it is to stand for an old one, nobody else may read it.
    fn create_new(&self, path: &Path, old: Option<&Standing>) -> io::Result<Self::File>;
    fn claim(&self, file: &Self::File) -> Claim;
    fn stand_for(&self, file: &Self::File, old: &Standing) -> io::Result<()>;
    fn sync(&self, file: &Self::File) -> io::Result<()>;
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;
    fn remove(&self, path: &Path) -> io::Result<()>;
}

/// Whose a new temporary file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Claim {
    /// Ours: others see that it is being written, as far as the file system has locks.
    Ours,
    /// Another run took it for debris before it was locked.
    Lost,
}
