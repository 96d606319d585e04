//! What replacing a file asks of a file system.

use std::io::{self, Write};
use std::path::Path;

use super::standing::Standing;

/// The steps of replacing a file. In tests each of them can be made to fail.
pub(super) trait FileSystem {
    type File: Write;
    /// Makes a new file. If it is to replace an old one, nobody else may read it.
    fn create_new(&self, path: &Path, old: Option<&Standing>) -> io::Result<Self::File>;
    fn claim(&self, file: &Self::File) -> Claim;
    fn stand_for(&self, file: &Self::File, old: &Standing) -> io::Result<()>;
    fn sync(&self, file: &Self::File) -> io::Result<()>;
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;
    fn remove(&self, path: &Path) -> io::Result<()>;
}

/// Whether a new temporary file is ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Claim {
    /// It is: if the file system has locks, others see that it is being written.
    Ours,
    /// Another run took it for debris before it was locked.
    Lost,
}
