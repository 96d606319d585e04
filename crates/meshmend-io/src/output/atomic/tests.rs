//! Every step of replacing a file, and every step that can fail.

use std::cell::Cell;
use std::fs::File;
use std::ops::Range;
use std::rc::Rc;

use super::*;
use crate::output::atomic::file_system::Claim;
use crate::output::atomic::temporary::SUFFIX;

/// An empty folder that is removed again.
pub(in crate::output::atomic) struct Folder(pub(in crate::output::atomic) PathBuf);

impl Folder {
    pub(in crate::output::atomic) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("meshmend-io-{name}-{}", std::process::id()));
        fs::remove_dir_all(&path).ok();
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    pub(in crate::output::atomic) fn names(&self) -> Vec<String> {
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

/// The name of a temporary file.
fn temporary(target: &str, number: u64) -> String {
    format!(".{target}.{number:016x}{}", SUFFIX)
}

#[test]
fn what_a_killed_run_left_is_removed_and_what_a_live_one_writes_is_not() {
    let folder = Folder::new("debris");
    let (dead, live) = (temporary("mesh.obj", 1), temporary("mesh.obj", u64::MAX));
    let other_target = temporary("other.obj", 3);
    let other_name = format!(".mesh.obj.1-0{}", SUFFIX);
    for name in [&dead, &live, &other_target, &other_name] {
        fs::write(folder.0.join(name), "debris").unwrap();
    }
    // Whoever writes a file has locked it, in whichever process and container.
    let writer = OpenOptions::new().write(true).open(folder.0.join(&live)).unwrap();
    writer.lock().unwrap();
    let path = folder.0.join("mesh.obj");
    let nested: io::Result<()> = replace_file(&path, |out| {
        write(&path, "inner")?;
        out.write_all(b"outer")
    });
    nested.unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "outer");
    let mut expected = vec![other_name, live, other_target, "mesh.obj".to_owned()];
    expected.sort();
    assert_eq!(folder.names(), expected);
}

/// Many writers of one target at once: each sees the others' files beside it.
#[test]
fn writers_of_one_target_take_nothing_from_each_other() {
    let folder = Folder::new("writers");
    let path = folder.0.join("mesh.obj");
    std::thread::scope(|scope| {
        for writer in 0..8 {
            let path = &path;
            scope.spawn(move || {
                for _ in 0..25 {
                    let text = char::from(b'a' + writer).to_string().repeat(10_000);
                    write(path, &text).unwrap();
                    let found = fs::read_to_string(path).unwrap();
                    assert!(found.len() == 10_000 && found.bytes().all(|byte| byte == found.as_bytes()[0]));
                }
            });
        }
    });
    assert_eq!(folder.names(), ["mesh.obj"]);
}

#[cfg(unix)]
#[test]
fn what_lies_in_wait_under_the_name_of_debris_is_left_alone() {
    let folder = Folder::new("traps");
    let victim = folder.0.join("victim");
    fs::write(&victim, "precious").unwrap();
    std::os::unix::fs::symlink(&victim, folder.0.join(temporary("mesh.obj", 7))).unwrap();
    fs::create_dir(folder.0.join(temporary("mesh.obj", 8))).unwrap();
    write(&folder.0.join("mesh.obj"), "new").unwrap();
    assert_eq!(fs::read_to_string(&victim).unwrap(), "precious");
    assert_eq!(folder.names().len(), 4);
}

/// The permissions of the temporary file beside a target, from its first byte on.
#[cfg(unix)]
fn modes_while_writing(folder: &Folder, path: &Path) -> Vec<u32> {
    use std::os::unix::fs::PermissionsExt;
    let mut modes = Vec::new();
    let mut look = || {
        let names = folder.names().into_iter().filter(|name| name.ends_with(SUFFIX));
        modes.extend(
            names.map(|name| fs::metadata(folder.0.join(name)).unwrap().permissions().mode() & 0o7777),
        );
    };
    let written: io::Result<()> = replace_file(path, |out| {
        look();
        out.write_all(b"new bytes")?;
        look();
        out.flush()
    });
    written.unwrap();
    modes.push(fs::metadata(path).unwrap().permissions().mode() & 0o7777);
    modes
}

#[cfg(unix)]
#[test]
fn a_file_has_the_permissions_of_the_old_one_from_its_first_byte() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new("modes");
    let path = folder.0.join("mesh.obj");
    for mode in [0o600, 0o640, 0o644, 0o666, 0o777, 0o200] {
        fs::write(&path, "old").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(mode)).unwrap();
        assert_eq!(modes_while_writing(&folder, &path), [mode; 3], "{mode:o}");
        fs::remove_file(&path).unwrap();
    }
    // A new file is as any other new file.
    let other = folder.0.join("other.obj");
    fs::write(&other, "new").unwrap();
    let usual = fs::metadata(&other).unwrap().permissions().mode() & 0o7777;
    assert_eq!(modes_while_writing(&folder, &path), [usual; 3]);
}

/// Only the administrator may give files away; others are told nothing and lose nothing.
#[cfg(unix)]
#[test]
fn the_administrator_keeps_the_owner_of_a_file() {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, chown};
    let folder = Folder::new("owner");
    let path = folder.0.join("mesh.obj");
    fs::write(&path, "old").unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
    if chown(&path, Some(65534), Some(65534)).is_err() {
        println!("skipped: only the administrator can give a file away");
        return;
    }
    assert_eq!(modes_while_writing(&folder, &path), [0o640; 3]);
    let status = fs::metadata(&path).unwrap();
    assert_eq!((status.uid(), status.gid()), (65534, 65534));
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
pub(in crate::output::atomic) struct Failing {
    calls: Rc<Calls>,
}

struct Calls {
    made: Cell<usize>,
    failing: Range<usize>,
    error: io::ErrorKind,
}

impl Failing {
    pub(in crate::output::atomic) fn at(failing: Range<usize>, error: io::ErrorKind) -> Self {
        Failing { calls: Rc::new(Calls { made: Cell::new(0), failing, error }) }
    }

    pub(in crate::output::atomic) fn calls(&self) -> usize {
        self.calls.made.get()
    }
}

impl Calls {
    fn next(&self) -> io::Result<()> {
        let this = self.made.replace(self.made.get() + 1);
        if self.failing.contains(&this) { Err(self.error.into()) } else { Ok(()) }
    }
}

pub(in crate::output::atomic) struct FailingFile {
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

    fn create_new(&self, path: &Path, old: Option<&Standing>) -> io::Result<FailingFile> {
        self.calls.next()?;
        Ok(FailingFile { file: Disk.create_new(path, old)?, calls: self.calls.clone() })
    }

    fn claim(&self, file: &FailingFile) -> Claim {
        Disk.claim(&file.file)
    }

    fn stand_for(&self, file: &FailingFile, old: &Standing) -> io::Result<()> {
        self.calls.next()?;
        Disk.stand_for(&file.file, old)
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
    let system = Failing::at(failing, error);
    let result = replace_file_on(&system, path, |out| out.write_all(new.as_bytes()));
    (result, system.calls())
}

#[test]
fn whichever_call_fails_the_file_is_the_old_or_the_new_one_and_alone() {
    let folder = Folder::new("each-call");
    let path = folder.0.join("mesh.obj");
    write(&path, "old").unwrap();
    let calls = write_failing(&path, "the new bytes", 0..0, io::ErrorKind::Other).1;
    // Creating, permissions, five writes, flushing, synchronising, renaming, removing.
    assert_eq!(calls, 11);
    for (error, failing) in ERRORS.iter().flat_map(|&error| (0..calls).map(move |k| (error, k))) {
        write(&path, "old").unwrap();
        let result = write_failing(&path, "the new bytes", failing..failing + 1, error).0;
        let is_retried = error == io::ErrorKind::Interrupted && (2..=6).contains(&failing);
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
        let result = write_failing(&path, "the new bytes", failing..usize::MAX, io::ErrorKind::StorageFull).0;
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
