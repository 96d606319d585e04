//! A file is replaced all at once, or not at all.
//!
//! The new bytes go to a temporary file beside the target, are flushed to the disk, and then take the target's
//! name in one step. Whatever goes wrong before that, the old file is as it was and the temporary file is
//! removed. A run that is killed may leave its temporary file behind; the next run that writes to the same target
//! removes it.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Replaces a file by what a closure writes, or leaves it alone when the closure or the system fails.
///
/// The target may be the file that the bytes were read from. A symbolic link is followed; the permissions of an
/// old file are kept, and one that may not be written is not replaced. What is no regular file, such as a pipe
/// or a device, is written to directly.
///
/// # Errors
/// What the closure returns, or what the system says.
///
/// *Cost*: beside the closure a few calls of the system, one of which waits for the disk, and a look at the
/// names in the target's folder.
pub fn replace_file<E: From<io::Error>>(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    replace_file_on(&Disk, path, fill)
}

/// What it takes to put a new file in the place of an old one; apart, so that every step can be made to fail.
trait FileSystem {
    type File: Write;
    fn create_new(&self, path: &Path) -> io::Result<Self::File>;
    fn set_permissions(&self, file: &Self::File, permissions: fs::Permissions) -> io::Result<()>;
    fn sync(&self, file: &Self::File) -> io::Result<()>;
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;
    fn remove(&self, path: &Path) -> io::Result<()>;
}

/// The system's own files.
struct Disk;

impl FileSystem for Disk {
    type File = File;

    fn create_new(&self, path: &Path) -> io::Result<File> {
        OpenOptions::new().write(true).create_new(true).open(path)
    }

    fn set_permissions(&self, file: &File, permissions: fs::Permissions) -> io::Result<()> {
        file.set_permissions(permissions)
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

fn replace_file_on<E: From<io::Error>>(
    system: &impl FileSystem,
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let old = match fs::metadata(path) {
        Ok(old) => Some(old),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(error) => return Err(error.into()),
    };
    if old.as_ref().is_some_and(fs::Metadata::is_dir) {
        return Err(io::Error::from(io::ErrorKind::IsADirectory).into());
    }
    if old.as_ref().is_some_and(|old| !old.is_file()) {
        let mut device = OpenOptions::new().write(true).open(path)?;
        fill(&mut device)?;
        return Ok(device.flush()?);
    }
    if old.as_ref().is_some_and(|old| old.permissions().readonly()) {
        return Err(io::Error::from(io::ErrorKind::PermissionDenied).into());
    }
    if old.is_some() {
        // Renaming asks for the folder's permission alone; a file that may not be written is not to be replaced.
        OpenOptions::new().write(true).open(path)?;
    }
    let target = if old.is_some() { fs::canonicalize(path)? } else { end_of_links(path) };
    let mut temporary = Temporary::beside(system, &target)?;
    fill(&mut temporary.file)?;
    temporary.file.flush()?;
    if let Some(old) = old {
        system.set_permissions(&temporary.file, old.permissions())?;
    }
    system.sync(&temporary.file)?;
    Ok(temporary.take_the_name_of(&target)?)
}

/// Where a chain of symbolic links leads that ends at no file yet.
fn end_of_links(path: &Path) -> PathBuf {
    const LONGEST_CHAIN: usize = 40;
    let mut end = path.to_owned();
    for _ in 0..LONGEST_CHAIN {
        let Ok(next) = fs::read_link(&end) else { break };
        end = end.parent().map_or(next.clone(), |folder| folder.join(&next));
    }
    end
}

/// A temporary file, removed when dropped.
struct Temporary<'a, S: FileSystem> {
    system: &'a S,
    file: S::File,
    path: PathBuf,
}

/// What the names of temporary files end in.
const SUFFIX: &str = ".meshmend-tmp";

/// How much of a target's name is in that of its temporary file: names have a longest length.
const LONGEST_STEM: usize = 120;

impl<'a, S: FileSystem> Temporary<'a, S> {
    fn beside(system: &'a S, target: &Path) -> io::Result<Self> {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let (folder, stem) = folder_and_stem(target)?;
        remove_debris(folder, &stem);
        loop {
            let mut name = stem.clone();
            name.push(format!("{}-{}{SUFFIX}", std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed)));
            let path = folder.join(name);
            let is_new = in_use().insert(path.clone());
            match system.create_new(&path) {
                Ok(file) => return Ok(Temporary { system, file, path }),
                Err(error) => {
                    if is_new {
                        in_use().remove(&path);
                    }
                    if error.kind() != io::ErrorKind::AlreadyExists {
                        return Err(error);
                    }
                }
            }
        }
    }

    fn take_the_name_of(self, target: &Path) -> io::Result<()> {
        self.system.rename(&self.path, target)?;
        // The new name must reach the disk as well. Where folders can't be synchronised there is nothing to do.
        if let (Ok((folder, _)), true) = (folder_and_stem(target), cfg!(unix)) {
            File::open(folder).and_then(|folder| folder.sync_all()).ok();
        }
        Ok(())
    }
}

impl<S: FileSystem> Drop for Temporary<'_, S> {
    fn drop(&mut self) {
        // After the renaming there is no such file, and nothing to remove.
        self.system.remove(&self.path).ok();
        in_use().remove(&self.path);
    }
}

/// The temporary files of this process that are being written.
fn in_use() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    static IN_USE: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    IN_USE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The folder of a target, and what the names of its temporary files begin with.
fn folder_and_stem(target: &Path) -> io::Result<(&Path, OsString)> {
    let name = target.file_name().ok_or_else(|| io::Error::from(io::ErrorKind::InvalidFilename))?;
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut stem = OsString::from(".");
    match name.to_str() {
        Some(name) => stem.push(name.chars().take(LONGEST_STEM / 4).collect::<String>()),
        None => stem.push("mesh"),
    }
    stem.push(".");
    Ok((folder, stem))
}

/// Removes temporary files of this target whose process is gone. What can't be removed stays.
fn remove_debris(folder: &Path, stem: &OsStr) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let (Some(stem), in_use) = (stem.to_str(), in_use().clone()) else { return };
    for entry in entries.flatten() {
        let name = entry.file_name();
        let middle = name.to_str().and_then(|name| name.strip_prefix(stem)?.strip_suffix(SUFFIX));
        let Some(process) = middle.and_then(|middle| middle.split_once('-')?.0.parse::<u32>().ok()) else {
            continue;
        };
        let is_ours = process == std::process::id();
        let is_live = if is_ours { in_use.contains(&folder.join(&name)) } else { may_run(process, &entry) };
        if !is_live {
            fs::remove_file(entry.path()).ok();
        }
    }
}

/// Whether a process may still be writing a file: it is listed, or, where processes are not listed, the file has
/// changed lately.
fn may_run(process: u32, entry: &fs::DirEntry) -> bool {
    let list = Path::new("/proc");
    if list.join("self").exists() { list.join(process.to_string()).exists() } else { changed_lately(entry) }
}

/// Whether a file has changed within the hour, or can't be asked.
fn changed_lately(entry: &fs::DirEntry) -> bool {
    const LONGEST_PAUSE: Duration = Duration::from_secs(3600);
    let age = entry.metadata().and_then(|status| status.modified()).map(|changed| changed.elapsed());
    !matches!(age, Ok(Ok(age)) if age > LONGEST_PAUSE)
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;
    use std::ops::Range;
    use std::rc::Rc;

    use super::*;

    /// An empty folder that is removed again.
    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let path = std::env::temp_dir().join(format!("meshmend-io-{name}-{}", std::process::id()));
            fs::remove_dir_all(&path).ok();
            fs::create_dir_all(&path).unwrap();
            Folder(path)
        }

        fn names(&self) -> Vec<String> {
            let entries = fs::read_dir(&self.0).unwrap();
            let mut names: Vec<String> =
                entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
            names.sort();
            names
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            fs::remove_dir_all(&self.0).ok();
        }
    }

    fn write(path: &Path, text: &str) -> io::Result<()> {
        replace_file(path, |out| out.write_all(text.as_bytes()))
    }

    #[test]
    fn a_file_is_made_and_replaced_and_nothing_is_left_beside_it() {
        let folder = Folder::new("made");
        let path = folder.0.join("mesh.obj");
        write(&path, "one").unwrap();
        write(&path, "two").unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "two");
        assert_eq!(folder.names(), ["mesh.obj"]);
    }

    #[test]
    fn a_failed_write_leaves_the_old_file_alone() {
        let folder = Folder::new("failed");
        let path = folder.0.join("mesh.obj");
        write(&path, "old").unwrap();
        let failed: io::Result<()> = replace_file(&path, |out| {
            out.write_all(b"half")?;
            Err(io::Error::from(io::ErrorKind::StorageFull))
        });
        assert_eq!(failed.unwrap_err().kind(), io::ErrorKind::StorageFull);
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(folder.names(), ["mesh.obj"]);
    }

    #[test]
    fn a_panic_in_the_middle_leaves_the_old_file_alone() {
        let folder = Folder::new("panic");
        let path = folder.0.join("mesh.obj");
        write(&path, "old").unwrap();
        let attempt = || replace_file::<io::Error>(&path, |_| panic!("while writing"));
        assert!(std::panic::catch_unwind(attempt).is_err());
        assert_eq!(fs::read_to_string(&path).unwrap(), "old");
        assert_eq!(folder.names(), ["mesh.obj"]);
    }

    #[test]
    fn a_failed_first_write_leaves_nothing() {
        let folder = Folder::new("nothing");
        let failed: io::Result<()> =
            replace_file(&folder.0.join("mesh.obj"), |_| Err(io::Error::from(io::ErrorKind::Other)));
        assert!(failed.is_err());
        assert!(folder.names().is_empty());
    }

    #[test]
    fn what_a_killed_run_left_is_removed_and_what_a_live_one_writes_is_not() {
        let folder = Folder::new("debris");
        // No process has the highest number: it is beyond the limit of every system.
        let dead = format!(".mesh.obj.{}-0{SUFFIX}", u32::MAX);
        let own = format!(".mesh.obj.{}-999999{SUFFIX}", std::process::id());
        let other_target = format!(".other.obj.{}-0{SUFFIX}", u32::MAX);
        for name in [&dead, &own, &other_target] {
            fs::write(folder.0.join(name), "debris").unwrap();
        }
        let path = folder.0.join("mesh.obj");
        let nested: io::Result<()> = replace_file(&path, |out| {
            write(&path, "inner")?;
            out.write_all(b"outer")
        });
        nested.unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), "outer");
        let expected = if Path::new("/proc/self").exists() {
            vec![other_target, "mesh.obj".to_owned()]
        } else {
            vec![dead, other_target, "mesh.obj".to_owned()]
        };
        assert_eq!(folder.names(), expected);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn what_another_live_process_writes_is_left_alone() {
        let folder = Folder::new("live");
        let live = format!(".mesh.obj.{}-0{SUFFIX}", std::os::unix::process::parent_id());
        fs::write(folder.0.join(&live), "being written").unwrap();
        write(&folder.0.join("mesh.obj"), "new").unwrap();
        assert_eq!(folder.names(), [live.as_str(), "mesh.obj"]);
    }

    #[test]
    fn a_file_has_changed_lately_within_an_hour() {
        let folder = Folder::new("lately");
        let file = File::create(folder.0.join("mesh.obj")).unwrap();
        let entry = fs::read_dir(&folder.0).unwrap().next().unwrap().unwrap();
        for (minutes, is_lately) in [(0, true), (59, true), (61, false)] {
            file.set_modified(std::time::SystemTime::now() - Duration::from_secs(60 * minutes)).unwrap();
            assert_eq!(changed_lately(&entry), is_lately, "{minutes} minutes ago");
        }
    }

    #[test]
    fn folders_and_missing_folders_are_errors() {
        let folder = Folder::new("folders");
        assert!(write(&folder.0, "x").is_err());
        assert!(write(&folder.0.join("missing/mesh.obj"), "x").is_err());
        assert!(folder.names().is_empty());
    }

    #[test]
    fn a_name_of_the_longest_length_can_be_written() {
        let folder = Folder::new("long");
        let path = folder.0.join("x".repeat(251) + ".obj");
        write(&path, "x").unwrap();
        assert_eq!(folder.names().len(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn permissions_and_links_are_kept() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = Folder::new("links");
        let (real, link) = (folder.0.join("real.obj"), folder.0.join("link.obj"));
        write(&real, "old").unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o640)).unwrap();
        symlink("real.obj", &link).unwrap();
        write(&link, "new").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read_to_string(&real).unwrap(), "new");
        assert_eq!(fs::metadata(&real).unwrap().permissions().mode() & 0o777, 0o640);
        fs::remove_file(&real).unwrap();
        write(&link, "again").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink(), "a link to nothing yet is followed too");
        assert_eq!(fs::read_to_string(&real).unwrap(), "again");
        write(&real, "new").unwrap();
        fs::set_permissions(&real, fs::Permissions::from_mode(0o440)).unwrap();
        assert_eq!(write(&real, "x").unwrap_err().kind(), io::ErrorKind::PermissionDenied);
        assert_eq!(fs::read_to_string(&real).unwrap(), "new");
    }

    /// A file system whose calls fail, one of them or all from there on.
    struct Failing {
        calls: Rc<Calls>,
    }

    struct Calls {
        made: Cell<usize>,
        failing: Range<usize>,
        error: io::ErrorKind,
    }

    impl Calls {
        fn next(&self) -> io::Result<()> {
            let this = self.made.replace(self.made.get() + 1);
            if self.failing.contains(&this) { Err(self.error.into()) } else { Ok(()) }
        }
    }

    struct FailingFile {
        file: File,
        calls: Rc<Calls>,
    }

    impl Write for FailingFile {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.calls.next()?;
            self.file.write(&bytes[..bytes.len().min(3)])
        }

        fn flush(&mut self) -> io::Result<()> {
            self.calls.next()
        }
    }

    impl FileSystem for Failing {
        type File = FailingFile;

        fn create_new(&self, path: &Path) -> io::Result<FailingFile> {
            self.calls.next()?;
            Ok(FailingFile { file: Disk.create_new(path)?, calls: self.calls.clone() })
        }

        fn set_permissions(&self, file: &FailingFile, permissions: fs::Permissions) -> io::Result<()> {
            self.calls.next()?;
            Disk.set_permissions(&file.file, permissions)
        }

        fn sync(&self, file: &FailingFile) -> io::Result<()> {
            self.calls.next()?;
            Disk.sync(&file.file)
        }

        fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
            self.calls.next()?;
            Disk.rename(from, to)
        }

        fn remove(&self, path: &Path) -> io::Result<()> {
            self.calls.next()?;
            Disk.remove(path)
        }
    }

    const ERRORS: [io::ErrorKind; 3] =
        [io::ErrorKind::StorageFull, io::ErrorKind::Other, io::ErrorKind::Interrupted];

    /// Writes `new` with failing calls; whether that worked, and how many calls were made.
    fn write_failing(
        path: &Path,
        new: &str,
        failing: Range<usize>,
        error: io::ErrorKind,
    ) -> (io::Result<()>, usize) {
        let calls = Rc::new(Calls { made: Cell::new(0), failing, error });
        let system = Failing { calls: calls.clone() };
        let result = replace_file_on(&system, path, |out| out.write_all(new.as_bytes()));
        (result, calls.made.get())
    }

    #[test]
    fn whichever_call_fails_the_file_is_the_old_or_the_new_one_and_alone() {
        let folder = Folder::new("each-call");
        let path = folder.0.join("mesh.obj");
        write(&path, "old").unwrap();
        let calls = write_failing(&path, "the new bytes", 0..0, io::ErrorKind::Other).1;
        // Creating, five writes, flushing, permissions, synchronising, renaming, removing.
        assert_eq!(calls, 11);
        for (error, failing) in ERRORS.iter().flat_map(|&error| (0..calls).map(move |k| (error, k))) {
            write(&path, "old").unwrap();
            let result = write_failing(&path, "the new bytes", failing..failing + 1, error).0;
            let is_retried = error == io::ErrorKind::Interrupted && (1..=5).contains(&failing);
            // Removing comes last, when the renaming has left nothing to remove.
            let works = is_retried || failing == 10;
            assert_eq!(result.is_ok(), works, "{error} at call {failing}");
            let expected = if works { "the new bytes" } else { "old" };
            assert_eq!(fs::read_to_string(&path).unwrap(), expected, "{error} at call {failing}");
            assert_eq!(folder.names(), ["mesh.obj"], "{error} at call {failing}");
        }
    }

    #[test]
    fn when_all_calls_fail_from_one_on_the_old_file_is_whole_and_the_next_run_clears() {
        let folder = Folder::new("from-a-call-on");
        let path = folder.0.join("mesh.obj");
        for failing in 0..10 {
            write(&path, "old").unwrap();
            let result =
                write_failing(&path, "the new bytes", failing..usize::MAX, io::ErrorKind::StorageFull).0;
            assert_eq!(result.unwrap_err().kind(), io::ErrorKind::StorageFull);
            assert_eq!(fs::read_to_string(&path).unwrap(), "old");
            // What was created could not be removed either.
            assert_eq!(folder.names().len(), if failing == 0 { 1 } else { 2 });
            write(&path, "next").unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), "next");
            assert_eq!(folder.names(), ["mesh.obj"]);
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn what_can_not_be_flushed_to_a_disk_is_an_error() {
        assert!(Disk.sync(&OpenOptions::new().write(true).open("/dev/null").unwrap()).is_err());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_device_is_an_error_and_stays_a_device() {
        let path = Path::new("/dev/full");
        if path.exists() {
            assert!(write(path, "x").is_err());
            assert!(!fs::metadata(path).unwrap().is_file());
        }
    }
}
