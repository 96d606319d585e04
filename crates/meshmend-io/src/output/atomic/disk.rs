//! The system's own files.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::Path;

use super::file_system::{Claim, FileSystem};
use super::standing::{self, Standing};
use super::temporary;

/// The system's own files.
pub(super) struct Disk;

impl FileSystem for Disk {
    type File = File;

    fn create_new(&self, path: &Path, old: Option<&Standing>) -> io::Result<File> {
        let mut options = OpenOptions::new();
        options.write(true).create_new(true);
        if old.is_some() {
            standing::only_for_us(&mut options);
        }
        options.open(path)
    }

    fn claim(&self, file: &File) -> Claim {
        temporary::claim(file)
    }

    fn stand_for(&self, file: &File, old: &Standing) -> io::Result<()> {
        old.give_to(file)
    }

    fn sync(&self, file: &File) -> io::Result<()> {
        file.sync_all()
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        fs::rename(from, to)
    }

    fn remove(&self, path: &Path) -> io::Result<()> {
        fs::remove_file(path)
    }
}
