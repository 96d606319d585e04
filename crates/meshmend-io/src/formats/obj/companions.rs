//! Material libraries and their images: whether they are there, and whether the output will find them.
//!
//! A file names them; nothing of a mesh depends on them. Only what lies in the folder of the file is opened, and only to see
//! whether it is there and, in a library, which images it names.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

use crate::formats::obj::library::images;
use crate::text::{self, words};
use crate::{Format, Loss, LossKind, Note, NoteKind, Place, Prepared, ReadFile};

/// How many files are looked for at most.
const MOST_FILES: usize = 64;

/// How many bytes of a library are read at most.
const MOST_BYTES: u64 = 1 << 26;

/// How many files a message names at most.
const MOST_NAMES: usize = 8;

/// The files that are there, with their folder.
#[derive(Debug, PartialEq)]
pub(crate) struct Companions {
    folder: PathBuf,
    /// As the file spells them, in its order.
    names: Vec<Vec<u8>>,
}

/// The folder that a file is in.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// A file that was read, with what there is to say about the files that it names.
///
/// *Cost*: constant for a file that names none; else that of reading its libraries.
pub(crate) fn looked_for(mut file: ReadFile, path: &Path) -> ReadFile {
    let statements = file.mesh.metadata().iter().filter(|statement| statement.key == "mtllib");
    let libraries: Vec<&[u8]> = statements.map(|statement| &statement.value[..]).collect();
    if file.format != Format::Obj || libraries.is_empty() {
        return file;
    }
    let Ok(folder) = fs::canonicalize(folder_of(path)) else { return file };
    let mut search = Search { folder, names: Vec::new(), notes: Vec::new(), looked: 0 };
    libraries.into_iter().for_each(|statement| search.libraries(statement));
    file.notes.extend(search.notes);
    file.notes.sort_by_key(|note| note.kind);
    let companions = Companions { folder: search.folder, names: search.names };
    if !companions.names.is_empty() {
        file.shell = file.shell.with_companions(companions);
    }
    file
}

/// What is found out about the files that a file names.
struct Search {
    folder: PathBuf,
    names: Vec<Vec<u8>>,
    notes: Vec<Note>,
    looked: usize,
}

/// Where a name leads.
enum Found {
    There(PathBuf),
    Missing,
    Outside,
}

impl Search {
    /// The libraries of one statement: its words, or all of it where that is the name of a file.
    fn libraries(&mut self, statement: &[u8]) {
        let is_whole = matches!(self.find(statement), Found::There(_));
        let names: Vec<&[u8]> = if is_whole { vec![statement] } else { words(statement).collect() };
        for name in names {
            if let Some(path) = self.companion("material library", name) {
                match read_start(&path) {
                    Ok(text) => images(&text).for_each(|readings| self.image(&readings)),
                    Err(_) => {
                        let message = format!("material library `{}` can't be read", text::shown(name));
                        self.note(NoteKind::CompanionMissing, message);
                    }
                }
            }
        }
    }

    /// An image, whose name is read in two ways: the one that leads to a file is right.
    fn image(&mut self, [whole, last]: &[&[u8]; 2]) {
        let is_last =
            !matches!(self.find(whole), Found::There(_)) && matches!(self.find(last), Found::There(_));
        self.companion("image", if is_last { last } else { whole });
    }

    /// The path of a file that is there; what is not is noted. Each name is looked for once.
    fn companion(&mut self, what: &str, name: &[u8]) -> Option<PathBuf> {
        if name.is_empty() || self.names.iter().any(|known| known == name) || self.looked == MOST_FILES {
            return None;
        }
        self.looked += 1;
        let shown = text::shown(name);
        let (kind, message) = match self.find(name) {
            Found::There(path) => {
                self.names.push(name.to_vec());
                return Some(path);
            }
            Found::Missing => (NoteKind::CompanionMissing, format!("{what} `{shown}` is not there")),
            Found::Outside => {
                let message =
                    format!("{what} `{shown}` is outside the folder of the file and was not opened");
                (NoteKind::CompanionOutside, message)
            }
        };
        self.note(kind, message);
        None
    }

    fn note(&mut self, kind: NoteKind, message: String) {
        if !self.notes.iter().any(|note| note.message == message) {
            self.notes.push(Note { kind, count: 1, first: Place::File, message });
        }
    }

    fn find(&self, name: &[u8]) -> Found {
        let Some(path) = within(name) else { return Found::Outside };
        match fs::canonicalize(self.folder.join(path)) {
            Err(_) => Found::Missing,
            Ok(path) if !path.starts_with(&self.folder) => Found::Outside,
            Ok(path) if path.is_file() => Found::There(path),
            Ok(_) => Found::Missing,
        }
    }
}

/// A name as a path below a folder, if it does not lead out of it. `\` parts folders as `/` does.
fn within(name: &[u8]) -> Option<PathBuf> {
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

fn read_start(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The loss of the files that the input names and that the output won't find.
pub(crate) fn loss(prepared: &Prepared) -> Option<Loss> {
    let companions = prepared.options.shell.companions()?;
    let is_obj = prepared.format == Format::Obj;
    let folder = prepared.options.folder.as_deref();
    let stays = |name: &&Vec<u8>| !is_obj || folder.is_some_and(|folder| !companions.is_in(folder, name));
    let left: Vec<&Vec<u8>> = companions.names.iter().filter(stays).collect();
    Loss::if_any(LossKind::Companion, left.len(), |count| {
        let mut names: Vec<String> =
            left.iter().take(MOST_NAMES).map(|name| format!("`{}`", text::shown(name))).collect();
        names.extend((count > MOST_NAMES).then(|| format!("and {} more", count - MOST_NAMES)));
        let names = names.join(", ");
        match (is_obj, count) {
            (true, 1) => format!("{names}, which the output names, stays in the folder of the input"),
            (true, _) => {
                format!("{count} files, which the output names, stay in the folder of the input: {names}")
            }
            (false, 1) => format!("{names}, which the input names and the output does not"),
            (false, _) => format!("{count} files, which the input names and the output does not: {names}"),
        }
    })
}

impl Companions {
    /// Whether a folder has the same file under the same name.
    fn is_in(&self, folder: &Path, name: &[u8]) -> bool {
        let (Ok(folder), Some(path)) = (fs::canonicalize(folder), within(name)) else { return false };
        folder == self.folder || same_content(&self.folder.join(&path), &folder.join(&path)).unwrap_or(false)
    }
}

/// Whether two files have the same bytes.
fn same_content(one: &Path, other: &Path) -> io::Result<bool> {
    let (one, other) = (File::open(one)?, File::open(other)?);
    let (length, other_length) = (one.metadata()?.len(), other.metadata()?.len());
    if length != other_length || length > MOST_BYTES {
        return Ok(false);
    }
    let (mut bytes, mut other_bytes) = (Vec::new(), Vec::new());
    one.take(MOST_BYTES).read_to_end(&mut bytes)?;
    other.take(MOST_BYTES).read_to_end(&mut other_bytes)?;
    Ok(bytes == other_bytes)
}
