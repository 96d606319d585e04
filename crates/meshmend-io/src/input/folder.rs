//! The files beside a file. Nothing outside of its folder is opened.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use crate::Limits;
use crate::paths::folder_of;

/// The folder of a file that was read, with what was opened in it.
pub(crate) struct Folder {
    path: PathBuf,
    opened: Mutex<Opened>,
}

/// How many files were opened, and how many bytes they had together.
#[derive(Default)]
struct Opened {
    files: u64,
    bytes: u64,
}

/// What a name leads to.
pub(crate) enum Lead {
    /// A file in the folder.
    There(PathBuf),
    /// Nothing that is a file.
    Missing,
    /// Out of the folder.
    Outside,
}

/// Why a file is not opened.
pub(crate) enum NotOpened {
    /// There is no file of this name.
    Missing,
    /// The name leads out of the folder.
    Outside,
    /// As many files were opened as may be.
    TooManyFiles,
    /// The files would have more bytes together than they may.
    TooManyBytes,
    /// The system can't read it.
    Io(io::Error),
}

impl Folder {
    /// The folder of the file at a path, if the system finds it.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let path = fs::canonicalize(folder_of(path)).ok()?;
        Some(Folder { path, opened: Mutex::default() })
    }

    /// A folder whose path is canonical.
    pub(crate) fn at(path: &Path) -> Self {
        Folder { path: path.to_owned(), opened: Mutex::default() }
    }

    /// Where the folder is.
    pub(crate) fn into_path(self) -> PathBuf {
        self.path
    }

    /// What a name leads to. A link counts as what it leads to.
    pub(crate) fn find(&self, name: &[u8]) -> Lead {
        let Some(path) = below(name) else { return Lead::Outside };
        match fs::canonicalize(self.path.join(path)) {
            Err(_) => Lead::Missing,
            Ok(path) if !path.starts_with(&self.path) => Lead::Outside,
            Ok(path) if path.is_file() => Lead::There(path),
            Ok(_) => Lead::Missing,
        }
    }

    /// The bytes of a file.
    ///
    /// *Cost*: linear in them.
    pub(crate) fn open(&self, name: &[u8], limits: &Limits) -> Result<Vec<u8>, NotOpened> {
        let path = match self.find(name) {
            Lead::There(path) => path,
            Lead::Missing => return Err(NotOpened::Missing),
            Lead::Outside => return Err(NotOpened::Outside),
        };
        let mut opened = self.opened.lock().unwrap_or_else(PoisonError::into_inner);
        if opened.files >= limits.max_companion_files {
            return Err(NotOpened::TooManyFiles);
        }
        let room = limits.max_companion_bytes.saturating_sub(opened.bytes);
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(NotOpened::Io)?;
        file.take(room.saturating_add(1)).read_to_end(&mut bytes).map_err(NotOpened::Io)?;
        if bytes.len() as u64 > room {
            return Err(NotOpened::TooManyBytes);
        }
        opened.files += 1;
        opened.bytes += bytes.len() as u64;
        Ok(bytes)
    }
}

/// A name as a path below a folder, or `None` if it leads out of the folder. `\` separates folders as `/` does.
pub(crate) fn below(name: &[u8]) -> Option<PathBuf> {
    let name = String::from_utf8_lossy(name).replace('\\', "/");
    let path = PathBuf::from(name);
    let mut depth = 0_usize;
    for component in path.components() {
        match component {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir => depth = depth.checked_sub(1)?,
            Component::RootDir | Component::Prefix(_) => return None,
        }
    }
    (depth > 0).then_some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_opened_in_the_folder_alone_and_within_the_limits() {
        let root = std::env::temp_dir().join(format!("meshmend-folder-{}", std::process::id()));
        fs::create_dir_all(root.join("models/maps")).unwrap();
        fs::write(root.join("secret"), b"no").unwrap();
        fs::write(root.join("models/maps/a.bin"), b"12345").unwrap();
        let folder = Folder::of(&root.join("models/car.gltf")).unwrap();
        let limits = Limits::default().with_max_companion_files(2).with_max_companion_bytes(12);
        let open = |name: &str| folder.open(name.as_bytes(), &limits);
        assert!(matches!(open("../secret"), Err(NotOpened::Outside)));
        assert!(matches!(open("/etc/passwd"), Err(NotOpened::Outside)));
        assert!(matches!(open("maps"), Err(NotOpened::Missing)));
        assert!(matches!(open("maps/b.bin"), Err(NotOpened::Missing)));
        assert!(matches!(open("maps\\a.bin"), Ok(bytes) if bytes == b"12345"));
        let narrow = limits.with_max_companion_bytes(9);
        assert!(matches!(folder.open(b"maps/a.bin", &narrow), Err(NotOpened::TooManyBytes)));
        assert!(open("maps/../maps/a.bin").is_ok());
        assert!(matches!(open("maps/a.bin"), Err(NotOpened::TooManyFiles)));
        fs::remove_dir_all(root).unwrap();
    }
}
