//! What a process leaves when it is told to end while it writes. Alone in its process, since that is about all files
//! that a process is writing.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

use std::fs;
use std::io;

use meshmend_io::{abandon_temporary_files, replace_file};

#[test]
fn what_is_abandoned_leaves_the_old_file_and_nothing_beside_it() {
    let folder = std::env::temp_dir().join(format!("meshmend-io-abandoned-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("mesh.obj");
    fs::write(&path, "old").unwrap();
    let names = || fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect::<Vec<_>>();
    let ended: io::Result<()> = replace_file(&path, |out| {
        out.write_all(b"half")?;
        assert_eq!(names().len(), 2);
        abandon_temporary_files(|| assert_eq!(names(), ["mesh.obj"]));
        out.write_all(b"and more")
    });
    assert_eq!(ended.unwrap_err().kind(), io::ErrorKind::NotFound);
    assert_eq!(fs::read_to_string(&path).unwrap(), "old");
    assert_eq!(names(), ["mesh.obj"]);
    // Nothing is abandoned for good: the next file is written.
    replace_file::<io::Error>(&path, |out| out.write_all(b"new")).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap(), "new");
    fs::remove_dir_all(&folder).unwrap();
}
