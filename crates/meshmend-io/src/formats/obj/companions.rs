//! Material libraries and their images: whether they exist, and what the materials look like.
//!
//! A file names them, but the mesh does not depend on them. Only files in the folder of the mesh file are opened.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::formats::obj::library::images;
use crate::formats::obj::materials::materials;
use crate::input::folder::{Folder, Lead};
use crate::shell::{NamedContent, NamedFile};
use crate::text::{self, words};
use crate::{Material, Note, NoteKind, Place};

/// How many files are looked for at most.
const MOST_FILES: usize = 64;

/// How many bytes of a library are read at most.
const MOST_BYTES: u64 = 1 << 26;

/// What a search found: the files that exist, as the file spells them, what their materials look like, and notes about
/// the others.
#[derive(Default)]
pub(super) struct Found {
    pub(super) companions: Vec<NamedFile>,
    pub(super) materials: Vec<Material>,
    pub(super) notes: Vec<Note>,
}

/// Looks for the files that the statements of a mesh file name. The path is that of the mesh file.
///
/// *Cost*: constant without a statement; else that of reading the libraries.
pub(super) fn look_for(libraries: &[&[u8]], path: &Path) -> Found {
    let folder = if libraries.is_empty() { None } else { Folder::of(path) };
    let Some(folder) = folder else { return Found::default() };
    let mut search = Search { folder, found: Found::default(), looked: 0 };
    libraries.iter().for_each(|statement| search.libraries(statement));
    search.found
}

/// A search for the files that a mesh file names.
struct Search {
    folder: Folder,
    found: Found,
    looked: usize,
}

impl Search {
    /// Looks for the libraries of one statement: the whole statement if it is the name of a file, else each word.
    fn libraries(&mut self, statement: &[u8]) {
        let is_whole = matches!(self.folder.find(statement), Lead::There(_));
        let names: Vec<&[u8]> = if is_whole { vec![statement] } else { words(statement).collect() };
        for name in names {
            if let Some(path) = self.companion(NamedContent::Materials, name) {
                match read_start(&path) {
                    Ok(text) => {
                        images(&text).for_each(|readings| self.image(&readings));
                        let companions = &self.found.companions;
                        let is_there = |name: &[u8]| companions.iter().any(|file| file.name == name);
                        let materials = materials(&text, &is_there);
                        self.found.materials.extend(materials);
                    }
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
        let is_last = !matches!(self.folder.find(whole), Lead::There(_))
            && matches!(self.folder.find(last), Lead::There(_));
        self.companion(NamedContent::Picture, if is_last { last } else { whole });
    }

    /// The path of a file, if it exists; else a note says so. Each name is looked for once.
    fn companion(&mut self, content: NamedContent, name: &[u8]) -> Option<PathBuf> {
        let is_known = self.found.companions.iter().any(|file| file.name == name);
        if name.is_empty() || is_known || self.looked == MOST_FILES {
            return None;
        }
        let what = if content == NamedContent::Materials { "material library" } else { "image" };
        self.looked += 1;
        let shown = text::shown(name);
        let (kind, message) = match self.folder.find(name) {
            Lead::There(path) => {
                self.found.companions.push(NamedFile { name: name.to_vec(), content });
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
        if !self.found.notes.iter().any(|note| note.message == message) {
            self.found.notes.push(Note { kind, count: 1, first: Place::File, message });
        }
    }
}

fn read_start(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES).read_to_end(&mut bytes)?;
    Ok(bytes)
}
