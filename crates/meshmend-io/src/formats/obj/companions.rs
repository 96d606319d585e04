//! Material libraries and their images: whether they are there, and whether the output will find them.
//!
//! A file names them; nothing of a mesh depends on them. Only what lies in the folder of the file is opened, and only to see
//! whether it is there and, in a library, which images it names.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};

use crate::formats::obj::library::images;
use crate::paths::folder_of;
use crate::shell::Output;
use crate::text::{self, words};
use crate::{Loss, LossKind, Note, NoteKind, Place};

/// How many files are looked for at most.
const MOST_FILES: usize = 64;

/// How many bytes of a library are read at most.
const MOST_BYTES: u64 = 1 << 26;

/// How many files a message names at most.
const MOST_NAMES: usize = 8;

/// The files that are there, with their folder.
#[derive(Debug, PartialEq)]
pub(super) struct Companions {
    folder: PathBuf,
    /// As the file spells them, in its order.
    names: Vec<Vec<u8>>,
}

/// What a search found: the files that are there, and notes about those that are not.
pub(super) struct Found {
    pub(super) companions: Option<Companions>,
    pub(super) notes: Vec<Note>,
}

/// Looks for the files that the statements of a file name. The path is that of the file.
///
/// *Cost*: constant without a statement; else that of reading the libraries.
pub(super) fn look_for(libraries: &[&[u8]], path: &Path) -> Found {
    let nothing = Found { companions: None, notes: Vec::new() };
    if libraries.is_empty() {
        return nothing;
    }
    let Ok(folder) = fs::canonicalize(folder_of(path)) else { return nothing };
    let mut search = Search { folder, names: Vec::new(), notes: Vec::new(), looked: 0 };
    libraries.iter().for_each(|statement| search.libraries(statement));
    let Search { folder, names, notes, .. } = search;
    let companions = (!names.is_empty()).then_some(Companions { folder, names });
    Found { companions, notes }
}

/// What is found out about the files that a file names.
struct Search {
    folder: PathBuf,
    names: Vec<Vec<u8>>,
    notes: Vec<Note>,
    looked: usize,
}

/// Where a name leads.
enum Lead {
    There(PathBuf),
    Missing,
    Outside,
}

impl Search {
    /// The libraries of one statement: its words, or all of it where that is the name of a file.
    fn libraries(&mut self, statement: &[u8]) {
        let is_whole = matches!(self.find(statement), Lead::There(_));
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
            !matches!(self.find(whole), Lead::There(_)) && matches!(self.find(last), Lead::There(_));
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
            Lead::There(path) => {
                self.names.push(name.to_vec());
                return Some(path);
            }
            Lead::Missing => (NoteKind::CompanionMissing, format!("{what} `{shown}` is not there")),
            Lead::Outside => {
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

    fn find(&self, name: &[u8]) -> Lead {
        let Some(path) = within(name) else { return Lead::Outside };
        match fs::canonicalize(self.folder.join(path)) {
            Err(_) => Lead::Missing,
            Ok(path) if !path.starts_with(&self.folder) => Lead::Outside,
            Ok(path) if path.is_file() => Lead::There(path),
            Ok(_) => Lead::Missing,
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
pub(super) fn loss(companions: &Companions, output: Output<'_>) -> Option<Loss> {
    let (is_obj, folder) = match output {
        Output::OfSameFormat(folder) => (true, folder),
        Output::OfOtherFormat => (false, None),
    };
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
