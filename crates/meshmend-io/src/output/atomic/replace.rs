//! A file is replaced all at once, or not at all.
//!
//! The new bytes go to a temporary file beside the target, are flushed to the disk, and then take the name of the
//! target in one step. If anything goes wrong before that, the old file stays as it was and the temporary file is
//! removed. A run that is killed may leave its temporary file behind. The next run that writes to the same target
//! removes it.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::disk::Disk;
use super::file_system::FileSystem;
use super::standing::Standing;
use super::temporary::Temporary;

/// Replaces a file by what a closure writes, or leaves it alone if the closure or the system fails.
///
/// The target may be the file that the bytes were read from. Symbolic links are followed. The new file has the
/// permissions of the old one from its first byte, and its owner and group as far as the system allows. Without an
/// old file it has those of any new file. A file that must not be written is not replaced. A pipe, a device and the
/// like are written to directly.
///
/// # Errors
/// Those of the closure and of the system.
///
/// *Cost*: that of the closure, and a few calls of the system. One of them waits for the disk, another one lists the
/// folder of the target.
pub fn replace_file<E: From<io::Error>>(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    replace_file_on(&Disk, path, fill)
}

/// The file that is written under a name: the end of a chain of symbolic links, whether that file exists or not.
pub fn target_of(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| end_of_links(path))
}

fn replace_file_on<E: From<io::Error>>(
    system: &impl FileSystem,
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    match Place::of(path)? {
        Place::Device(mut device) => {
            fill(&mut device)?;
            Ok(device.flush()?)
        }
        Place::File { target, old } => {
            let temporary = filled(system, &target, old.as_ref(), fill)?;
            Ok(temporary.take_the_name_of(&target)?)
        }
    }
}

/// What is to be written under a name.
pub(super) enum Place {
    /// A pipe, a device and the like.
    Device(File),
    /// A file, and how the old one stands if there is one.
    File { target: PathBuf, old: Option<Standing> },
}

impl Place {
    /// What a name leads to.
    ///
    /// # Errors
    /// If it is a folder, or a file that must not be written.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        let old = match fs::metadata(path) {
            Ok(old) => old,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                return Ok(Place::File { target: end_of_links(path), old: None });
            }
            Err(error) => return Err(error),
        };
        if old.is_dir() {
            return Err(io::Error::from(io::ErrorKind::IsADirectory));
        }
        if !old.is_file() {
            return Ok(Place::Device(OpenOptions::new().write(true).open(path)?));
        }
        if old.permissions().readonly() {
            return Err(io::Error::from(io::ErrorKind::PermissionDenied));
        }
        // Renaming needs the permission of the folder alone, but a file that must not be written must not be replaced.
        OpenOptions::new().write(true).open(path)?;
        Ok(Place::File { target: fs::canonicalize(path)?, old: Some(Standing::of(&old)) })
    }
}

/// A temporary file beside a target, with all that a closure writes on the disk.
pub(super) fn filled<'a, S: FileSystem, E: From<io::Error>>(
    system: &'a S,
    target: &Path,
    old: Option<&Standing>,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<Temporary<'a, S>, E> {
    let mut temporary = Temporary::beside(system, target, old)?;
    fill(&mut temporary.file)?;
    temporary.file.flush()?;
    system.sync(&temporary.file)?;
    Ok(temporary)
}

/// The end of a chain of symbolic links, where no file exists yet.
fn end_of_links(path: &Path) -> PathBuf {
    const LONGEST_CHAIN: usize = 40;
    let mut end = path.to_owned();
    for _ in 0..LONGEST_CHAIN {
        let Ok(next) = fs::read_link(&end) else { break };
        end = end.parent().map_or(next.clone(), |folder| folder.join(&next));
    }
    end
}

#[cfg(test)]
#[path = "tests.rs"]
pub(super) mod tests;
