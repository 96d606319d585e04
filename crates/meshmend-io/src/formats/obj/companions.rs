//! Material libraries and their images: whether they exist, and whether the output will find them.
//!
//! A file names them, but the mesh does not depend on them. Only files in the folder of the mesh file are opened, to
//! see whether they exist, and which images a library names.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::formats::obj::library::images;
use crate::input::folder::{Folder, Lead, below};
use crate::shell::Output;
use crate::text::{self, words};
use crate::{Loss, LossKind, Note, NoteKind, Place};

/// How many files are looked for at most.
const MOST_FILES: usize = 64;

/// How many bytes of a library are read at most.
const MOST_BYTES: u64 = 1 << 26;

/// How many files a message names at most.
const MOST_NAMES: usize = 8;

/// The files that exist, with their folder.
#[derive(Debug, PartialEq)]
pub(super) struct Companions {
    folder: PathBuf,
    /// As the file spells them, in its order.
    names: Vec<Vec<u8>>,
}

/// What a search found: the files that exist, and notes about the others.
pub(super) struct Found {
    pub(super) companions: Option<Companions>,
    pub(super) notes: Vec<Note>,
}

/// Looks for the files that the statements of a mesh file name. The path is that of the mesh file.
///
/// *Cost*: constant without a statement; else that of reading the libraries.
pub(super) fn look_for(libraries: &[&[u8]], path: &Path) -> Found {
    let none = Found { companions: None, notes: Vec::new() };
    if libraries.is_empty() {
        return none;
    }
    let Some(folder) = Folder::of(path) else { return none };
    let mut search = Search { folder, names: Vec::new(), notes: Vec::new(), looked: 0 };
    libraries.iter().for_each(|statement| search.libraries(statement));
    let Search { folder, names, notes, .. } = search;
    let folder = folder.into_path();
    let companions = (!names.is_empty()).then_some(Companions { folder, names });
    Found { companions, notes }
}

/// A search for the files that a mesh file names.
struct Search {
    folder: Folder,
    names: Vec<Vec<u8>>,
    notes: Vec<Note>,
    looked: usize,
}

impl Search {
    /// Looks for the libraries of one statement: the whole statement if it is the name of a file, else each word.
    fn libraries(&mut self, statement: &[u8]) {
        let is_whole = matches!(self.folder.find(statement), Lead::There(_));
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

    /// Looks for an image. Its name can be read in two ways; the one that leads to a file is right.
    fn image(&mut self, [whole, last]: &[&[u8]; 2]) {
        let is_last =
            !matches!(self.folder.find(whole), Lead::There(_)) && matches!(self.folder.find(last), Lead::There(_));
        self.companion("image", if is_last { last } else { whole });
    }

    /// The path of a file, if it exists; else a note says so. Each name is looked for once.
    fn companion(&mut self, what: &str, name: &[u8]) -> Option<PathBuf> {
        if name.is_empty() || self.names.iter().any(|known| known == name) || self.looked == MOST_FILES {
            return None;
        }
        self.looked += 1;
        let shown = text::shown(name);
        let (kind, message) = match self.folder.find(name) {
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
}

fn read_start(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The loss of the files that the input names and the output won't find.
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
        let (Ok(folder), Some(path)) = (fs::canonicalize(folder), below(name)) else { return false };
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
