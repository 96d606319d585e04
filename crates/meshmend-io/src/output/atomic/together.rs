//! A file and those beside it take their places together.
//!
//! All of them are written to temporary files first. Those beside it then take their names, where no files are, and the
//! file itself is the last one. If anything goes wrong, old files stay as they were and new ones are removed.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::disk::Disk;
use super::file_system::FileSystem;
use super::replace::{Place, filled};
use crate::paths::folder_of;

/// A file that does not exist yet.
pub(crate) struct NewFile<'a> {
    pub(crate) path: PathBuf,
    pub(crate) fill: &'a dyn Fn(&mut dyn Write) -> io::Result<()>,
}

/// Replaces a file as [`replace_file`](super::replace_file) does, and makes others beside it. A pipe or a device has
/// no files beside it.
///
/// # Errors
/// Those of the closures and of the system.
///
/// *Cost*: that of the closures, and a few calls of the system for each file.
pub(crate) fn replace_together<E: From<io::Error>>(
    path: &Path,
    beside: &[NewFile<'_>],
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    replace_together_on(&Disk, path, beside, fill)
}

pub(super) fn replace_together_on<E: From<io::Error>>(
    system: &impl FileSystem,
    path: &Path,
    beside: &[NewFile<'_>],
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let (target, old) = match Place::of(path)? {
        Place::Device(mut device) => {
            fill(&mut device)?;
            return Ok(device.flush()?);
        }
        Place::File { target, old } => (target, old),
    };
    let mut made = Made { system, files: Vec::new(), folders: Vec::new(), is_done: false };
    let mut written = Vec::with_capacity(beside.len());
    for file in beside {
        made.folder(folder_of(&file.path))?;
        written.push(filled(system, &file.path, None, |out| (file.fill)(out))?);
    }
    let main = filled(system, &target, old.as_ref(), fill)?;
    for (temporary, file) in written.into_iter().zip(beside) {
        temporary.take_the_name_of(&file.path)?;
        made.files.push(file.path.clone());
    }
    main.take_the_name_of(&target)?;
    made.is_done = true;
    Ok(())
}

/// The files and folders that were made, which are removed again if not all is done.
struct Made<'a, S: FileSystem> {
    system: &'a S,
    files: Vec<PathBuf>,
    folders: Vec<PathBuf>,
    is_done: bool,
}

impl<S: FileSystem> Made<'_, S> {
    /// Makes a folder, and those that it is in.
    fn folder(&mut self, path: &Path) -> io::Result<()> {
        let missing: Vec<&Path> = path.ancestors().take_while(|folder| !folder.exists()).collect();
        for folder in missing.into_iter().rev().filter(|folder| !folder.as_os_str().is_empty()) {
            match fs::create_dir(folder) {
                Ok(()) => self.folders.push(folder.to_owned()),
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

impl<S: FileSystem> Drop for Made<'_, S> {
    fn drop(&mut self) {
        if !self.is_done {
            self.files.iter().for_each(|file| drop(self.system.remove(file)));
            self.folders.iter().rev().for_each(|folder| drop(fs::remove_dir(folder)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::atomic::replace::tests::{Failing, Folder};

    /// Writes a mesh file and two others, one of them in a folder that does not exist.
    fn write_all(system: &impl FileSystem, folder: &Folder) -> io::Result<()> {
        let new = |name, fill| NewFile { path: folder.0.join(name), fill };
        let (map, library) =
            (|out: &mut dyn Write| out.write_all(b"map"), |out: &mut dyn Write| out.write_all(b"library"));
        let beside = [new("maps/deep/a.png", &map as &dyn Fn(&mut dyn Write) -> _), new("a.mtl", &library)];
        replace_together_on(system, &folder.0.join("a.obj"), &beside, |out| out.write_all(b"new mesh"))
    }

    #[test]
    fn all_files_are_there_or_none_of_them_whichever_call_fails() {
        let folder = Folder::new("together");
        fs::write(folder.0.join("a.obj"), "old").unwrap();
        let system = Failing::at(0..0, io::ErrorKind::Other);
        write_all(&system, &folder).unwrap();
        assert_eq!(folder.names(), ["a.mtl", "a.obj", "maps"]);
        assert_eq!(fs::read(folder.0.join("maps/deep/a.png")).unwrap(), b"map");
        for failing in 0..system.calls() {
            fs::remove_dir_all(&folder.0).unwrap();
            fs::create_dir(&folder.0).unwrap();
            fs::write(folder.0.join("a.obj"), "old").unwrap();
            let result = write_all(&Failing::at(failing..failing + 1, io::ErrorKind::StorageFull), &folder);
            let (names, main) = (folder.names(), fs::read_to_string(folder.0.join("a.obj")).unwrap());
            if result.is_ok() {
                assert_eq!((names.len(), &main[..]), (3, "new mesh"), "call {failing}");
            } else {
                assert_eq!((names, &main[..]), (vec!["a.obj".to_owned()], "old"), "call {failing}");
            }
        }
    }
}
