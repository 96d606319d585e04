//! The files that stand beside an output: those that it names.

use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::input::folder::{Folder, Lead, below};
use crate::output::atomic::{NewFile, replace_together};
use crate::paths::folder_of;
use crate::shell::NamedFile;
use crate::{Companions, Loss, LossKind, WriteErrorKind, WriteOptions, text};

/// How many files a message names at most.
const MOST_NAMES: usize = 8;

/// A file that is to stand beside an output.
#[derive(Clone, Debug)]
pub(crate) struct Companion {
    /// Its path below the folder of the output.
    pub(crate) name: Vec<u8>,
    pub(crate) content: Content,
}

/// Where the bytes of a companion are.
#[derive(Clone, Debug)]
pub(crate) enum Content {
    Bytes(Arc<[u8]>),
    File(PathBuf),
}

impl WriteOptions {
    /// Copies of some files beside the input, which an output names as well. There are none if that is in the same
    /// folder, its folder is not known, or the options say so.
    pub(crate) fn copies<'a>(&self, names: impl Iterator<Item = &'a [u8]>) -> Vec<Companion> {
        let (Some(from), Some(to), Companions::Copy) = (self.shell.folder(), &self.folder, self.companions)
        else {
            return Vec::new();
        };
        if fs::canonicalize(to).is_ok_and(|to| to == from) {
            return Vec::new();
        }
        let folder = Folder::at(from);
        let copy = |name: &[u8]| match folder.find(name) {
            Lead::There(path) => Some(Companion { name: name.to_vec(), content: Content::File(path) }),
            Lead::Missing | Lead::Outside => None,
        };
        names.filter_map(copy).collect()
    }

    /// The loss of files that an output names and that are not beside it.
    pub(crate) fn stay_loss(&self, files: &[NamedFile]) -> Option<Loss> {
        let (Some(from), Some(to), Companions::Skip) = (self.shell.folder(), &self.folder, self.companions)
        else {
            return None;
        };
        let is_there = |name: &[u8]| {
            let (Ok(to), Some(path)) = (fs::canonicalize(to), below(name)) else { return false };
            to == from || same_content(&from.join(&path), &to.join(&path)).unwrap_or(false)
        };
        let left: Vec<&[u8]> =
            files.iter().map(|file| &file.name[..]).filter(|name| !is_there(name)).collect();
        Loss::if_any(LossKind::Companion, left.len(), |count| {
            let names = listed(&left);
            match count {
                1 => format!("{names}, which the output names, stays in the folder of the input"),
                _ => {
                    format!("{count} files, which the output names, stay in the folder of the input: {names}")
                }
            }
        })
    }
}

/// The loss of files that an input names and an output does not.
pub(crate) fn unnamed_loss(names: &[&[u8]]) -> Option<Loss> {
    Loss::if_any(LossKind::Companion, names.len(), |count| {
        let names = listed(names);
        match count {
            1 => format!("{names}, which the input names and the output does not"),
            _ => format!("{count} files, which the input names and the output does not: {names}"),
        }
    })
}

fn listed(names: &[&[u8]]) -> String {
    let mut shown: Vec<String> =
        names.iter().take(MOST_NAMES).map(|name| format!("`{}`", text::shown(name))).collect();
    let more = names.len().saturating_sub(MOST_NAMES);
    shown.extend((more > 0).then(|| format!("and {more} more")));
    shown.join(", ")
}

/// Writes a file by a closure, and the companions that are not beside it yet.
///
/// # Errors
/// Those of the closure and of the system, and if another file has the name of a companion.
pub(crate) fn write_with(
    path: &Path,
    companions: &[Companion],
    fill: impl FnOnce(&mut dyn Write) -> Result<(), WriteErrorKind>,
) -> Result<(), WriteErrorKind> {
    let has_folder = fs::metadata(path).map_or(true, |status| status.is_file());
    let missing = if has_folder { missing(companions, folder_of(path))? } else { Vec::new() };
    let fills: Vec<_> =
        missing.iter().map(|(_, companion)| |out: &mut dyn Write| companion.write(out)).collect();
    let files = missing.iter().zip(&fills);
    let beside: Vec<NewFile<'_>> =
        files.map(|((path, _), fill)| NewFile { path: path.clone(), fill }).collect();
    replace_together(path, &beside, fill)
}

/// The companions that are not beside an output yet, with their paths.
///
/// # Errors
/// If another file has the name of one of them, or its path leads out of the folder.
///
/// *Cost*: that of reading those that are there.
fn missing<'a>(
    companions: &'a [Companion],
    folder: &Path,
) -> Result<Vec<(PathBuf, &'a Companion)>, WriteErrorKind> {
    let mut missing: Vec<(PathBuf, &Companion)> = Vec::new();
    for companion in companions {
        let occupied = || WriteErrorKind::Occupied { name: text::shown(&companion.name) };
        let path = folder.join(below(&companion.name).ok_or_else(occupied)?);
        if missing.iter().any(|(other, _)| *other == path) {
            continue;
        }
        if !leads_below(&path, folder) {
            return Err(occupied());
        }
        match fs::symlink_metadata(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => missing.push((path, companion)),
            Err(error) => return Err(error.into()),
            Ok(_) if companion.is_at(&path)? => {}
            Ok(_) => return Err(occupied()),
        }
    }
    Ok(missing)
}

/// Whether the folders on the way to a path that exist are in a folder: a link may lead out of it.
fn leads_below(path: &Path, folder: &Path) -> bool {
    let Ok(folder) = fs::canonicalize(folder) else { return true };
    let existing = path.ancestors().skip(1).find_map(|ancestor| fs::canonicalize(ancestor).ok());
    existing.is_none_or(|existing| existing.starts_with(&folder))
}

impl Companion {
    /// Writes its bytes.
    pub(crate) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        match &self.content {
            Content::Bytes(bytes) => out.write_all(bytes),
            Content::File(path) => io::copy(&mut File::open(path)?, out).map(drop),
        }
    }

    /// Whether the file at a path has its bytes.
    fn is_at(&self, path: &Path) -> io::Result<bool> {
        if !fs::metadata(path).is_ok_and(|status| status.is_file()) {
            return Ok(false);
        }
        match &self.content {
            Content::Bytes(bytes) => same_bytes(&mut &bytes[..], &mut File::open(path)?),
            Content::File(from) => same_content(from, path),
        }
    }
}

/// Whether two files have the same bytes.
fn same_content(one: &Path, other: &Path) -> io::Result<bool> {
    let (mut one, mut other) = (File::open(one)?, File::open(other)?);
    if one.metadata()?.len() != other.metadata()?.len() {
        return Ok(false);
    }
    same_bytes(&mut one, &mut other)
}

fn same_bytes(one: &mut dyn Read, other: &mut dyn Read) -> io::Result<bool> {
    const BLOCK: u64 = 1 << 16;
    loop {
        let (mut bytes, mut other_bytes) = (Vec::new(), Vec::new());
        one.take(BLOCK).read_to_end(&mut bytes)?;
        other.take(BLOCK).read_to_end(&mut other_bytes)?;
        if bytes != other_bytes || bytes.is_empty() {
            return Ok(bytes == other_bytes);
        }
    }
}
