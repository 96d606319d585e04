//! Temporary files: their names, their locks, and their removal.
//!
//! A temporary file has a random name, and the run that writes it holds a lock on it. So a file without a lock is
//! debris of a run that was killed. That also holds for runs in different containers, whatever their process numbers
//! are.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::hash::{BuildHasher, RandomState};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use super::file_system::{Claim, FileSystem};
use super::standing::Standing;
use crate::paths::folder_of;

/// A temporary file, removed when dropped.
pub(super) struct Temporary<'a, S: FileSystem> {
    system: &'a S,
    pub(super) file: S::File,
    path: PathBuf,
}

/// The end of the names of temporary files.
pub(super) const SUFFIX: &str = ".meshmend-tmp";

/// How many bytes of the target's name are in the name of its temporary file. The length of names is limited.
const LONGEST_STEM: usize = 120;

/// How many random names are tried before the folder is blamed.
const MOST_NAMES: usize = 100;

impl<'a, S: FileSystem> Temporary<'a, S> {
    /// An empty file beside a target, with the permissions of the old file.
    pub(super) fn beside(system: &'a S, target: &Path, old: Option<&Standing>) -> io::Result<Self> {
        let (folder, stem) = folder_and_stem(target)?;
        remove_debris(folder, &stem);
        for _ in 0..MOST_NAMES {
            let mut name = stem.clone();
            name.push(format!("{:016x}{SUFFIX}", random()));
            match Self::at(system, folder.join(name), old) {
                Ok(Some(temporary)) => return Ok(temporary),
                Ok(None) => {}
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Err(io::Error::from(io::ErrorKind::AlreadyExists))
    }

    /// A new file of a name. Returns `None` if another run took it for debris.
    fn at(system: &'a S, path: PathBuf, old: Option<&Standing>) -> io::Result<Option<Self>> {
        let file = {
            let mut in_use = in_use();
            let file = system.create_new(&path, old)?;
            in_use.insert(path.clone());
            file
        };
        // From here on the file is removed, whatever happens.
        let temporary = Temporary { system, file, path };
        if system.claim(&temporary.file) == Claim::Lost {
            return Ok(None);
        }
        if let Some(old) = old {
            system.stand_for(&temporary.file, old)?;
        }
        Ok(Some(temporary))
    }

    pub(super) fn take_the_name_of(self, target: &Path) -> io::Result<()> {
        {
            let _not_while_abandoning = in_use();
            self.system.rename(&self.path, target)?;
        }
        // The new name must reach the disk as well, as far as folders can be synchronised.
        if let (Ok((folder, _)), true) = (folder_and_stem(target), cfg!(unix)) {
            File::open(folder).and_then(|folder| folder.sync_all()).ok();
        }
        Ok(())
    }
}

impl<S: FileSystem> Drop for Temporary<'_, S> {
    fn drop(&mut self) {
        // After the renaming the file does not exist any more.
        self.system.remove(&self.path).ok();
        in_use().remove(&self.path);
    }
}

/// Removes the temporary files that this process is writing, then runs a closure. Until that returns, no file can
/// take the name of its target, and no new one can be made. The closure usually ends the process, as a signal asks
/// for. Targets stay as they were.
///
/// *Cost*: a call of the system for each file.
pub fn abandon_temporary_files<R>(end: impl FnOnce() -> R) -> R {
    let in_use = in_use();
    for path in in_use.iter() {
        fs::remove_file(path).ok();
    }
    end()
}

/// The temporary files of this process that are being written.
fn in_use() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    static IN_USE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    IN_USE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Locks a new file, so that no other run takes it for debris. Without locks, its age protects it.
pub(super) fn claim(file: &File) -> Claim {
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => Claim::Lost,
        Err(TryLockError::Error(_)) => Claim::Ours,
        Ok(()) if is_removed(file) => Claim::Lost,
        Ok(()) => Claim::Ours,
    }
}

/// Whether another run has removed a file before it was locked.
#[cfg(unix)]
fn is_removed(file: &File) -> bool {
    use std::os::unix::fs::MetadataExt;
    file.metadata().is_ok_and(|status| status.nlink() == 0)
}

#[cfg(not(unix))]
fn is_removed(_: &File) -> bool {
    false
}

/// A random number that no other run draws.
fn random() -> u64 {
    RandomState::new().hash_one(std::process::id())
}

/// The folder of a target, and the start of the names of its temporary files.
fn folder_and_stem(target: &Path) -> io::Result<(&Path, OsString)> {
    let name = target.file_name().ok_or_else(|| io::Error::from(io::ErrorKind::InvalidFilename))?;
    let folder = folder_of(target);
    let mut stem = OsString::from(".");
    match name.to_str() {
        Some(name) => stem.push(name.chars().take(LONGEST_STEM / 4).collect::<String>()),
        None => stem.push("mesh"),
    }
    stem.push(".");
    Ok((folder, stem))
}

/// Removes the temporary files of this target that no run is writing. Files that can't be removed stay.
fn remove_debris(folder: &Path, stem: &OsStr) {
    let (Ok(entries), Some(stem)) = (fs::read_dir(folder), stem.to_str()) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let middle = name.to_str().and_then(|name| name.strip_prefix(stem)?.strip_suffix(SUFFIX));
        let is_ours = middle
            .is_some_and(|middle| middle.len() == 16 && middle.bytes().all(|byte| byte.is_ascii_hexdigit()));
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if is_ours && is_file {
            remove_if_abandoned(&entry.path());
        }
    }
}

/// Removes a temporary file while we hold its lock, so that no other run can be writing it. Without locks, it is
/// removed if it has not changed for long.
fn remove_if_abandoned(path: &Path) {
    let Ok(file) = OpenOptions::new().write(true).open(path) else { return };
    let is_abandoned = match file.try_lock() {
        Ok(()) => true,
        Err(TryLockError::WouldBlock) => false,
        Err(TryLockError::Error(_)) => !changed_lately(&file),
    };
    if is_abandoned {
        fs::remove_file(path).ok();
    }
}

/// Whether a file has changed within the last hour, or the system can't say.
fn changed_lately(file: &File) -> bool {
    const LONGEST_PAUSE: Duration = Duration::from_secs(3600);
    let age = file.metadata().and_then(|status| status.modified()).map(|changed| changed.elapsed());
    !matches!(age, Ok(Ok(age)) if age > LONGEST_PAUSE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_has_changed_lately_within_an_hour() {
        let path = std::env::temp_dir().join(format!("meshmend-io-lately-{:016x}", random()));
        let file = File::create(&path).unwrap();
        for (minutes, is_lately) in [(0, true), (59, true), (61, false)] {
            file.set_modified(std::time::SystemTime::now() - Duration::from_secs(60 * minutes)).unwrap();
            assert_eq!(changed_lately(&file), is_lately, "{minutes} minutes ago");
        }
        fs::remove_file(path).unwrap();
    }

    #[test]
    fn names_are_not_drawn_twice() {
        let names: BTreeSet<u64> = (0..1000).map(|_| random()).collect();
        assert_eq!(names.len(), 1000);
    }
}
