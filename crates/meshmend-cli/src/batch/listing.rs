//! Which files a batch has: those that are named, those of folders and of patterns, and those of a list.

use std::fs::{self, Metadata};
use std::path::{Component, Path, PathBuf};

use humantime::format_rfc3339_nanos;
use meshmend::Format;
use walkdir::WalkDir;

use crate::failure::Failure;

/// A file of a batch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Listed {
    /// As it is named, or found in what is named.
    pub(crate) path: PathBuf,
    /// Its place in the tree of results.
    pub(crate) place: PathBuf,
    /// How long it is; `None` if it is not there.
    pub(crate) size: Option<u64>,
    /// When it was changed last: RFC 3339, in UTC.
    pub(crate) mtime: Option<String>,
}

/// The files that a word of the command line stands for. Results are not among them: what is in `out` is passed over in folders.
pub(crate) fn listed(word: &Path, out: &Path) -> Result<Vec<Listed>, Failure> {
    let pattern = word.to_string_lossy();
    let is_pattern = pattern.contains(['*', '?', '[']) && fs::symlink_metadata(word).is_err();
    if !is_pattern {
        return in_tree(word, word.parent().unwrap_or(Path::new("")), word.is_dir(), out);
    }
    let wrong = |reason: String| Failure::usage(format!("{pattern}: {reason}"));
    let base: PathBuf = word
        .components()
        .take_while(|part| !part.as_os_str().to_string_lossy().contains(['*', '?', '[']))
        .collect();
    let mut files = Vec::new();
    for found in glob::glob(&pattern).map_err(|error| wrong(error.to_string()))? {
        let found = found.map_err(|error| wrong(error.to_string()))?;
        files.extend(in_tree(&found, &base, false, out)?);
    }
    if files.is_empty() {
        return Err(wrong("no file matches".to_owned()));
    }
    Ok(files)
}

/// The files of a line of a list: its path is its place.
pub(crate) fn of_line(line: &str, out: &Path) -> Result<Vec<Listed>, Failure> {
    let path = Path::new(line);
    if path.components().any(|part| part == Component::ParentDir) {
        return Err(Failure::usage(format!(
            "{line}: a line of a list has no `..`: it is a place in the output too"
        )));
    }
    in_tree(path, Path::new("/"), false, out)
}

/// A file, or those in a folder that have the name of a mesh. Links in it are not followed.
fn in_tree(path: &Path, base: &Path, is_base: bool, out: &Path) -> Result<Vec<Listed>, Failure> {
    let base = if is_base { path } else { base };
    if !path.is_dir() {
        return Ok(vec![of(path, base, fs::metadata(path).ok())]);
    }
    let out = out.canonicalize().ok();
    let is_wanted = |entry: &walkdir::DirEntry| {
        let is_out = || out.is_some() && entry.path().canonicalize().ok() == out;
        entry.depth() == 0 || !(entry.file_type().is_dir() && is_out())
    };
    let mut files = Vec::new();
    for entry in WalkDir::new(path).sort_by_file_name().into_iter().filter_entry(is_wanted) {
        let entry = entry.map_err(|error| Failure::usage(error.to_string()))?;
        if entry.file_type().is_file() && Format::from_path(entry.path()).is_some() {
            files.push(of(entry.path(), base, entry.metadata().ok()));
        }
    }
    Ok(files)
}

fn of(path: &Path, base: &Path, status: Option<Metadata>) -> Listed {
    let below = path.strip_prefix(base).unwrap_or(path);
    let place = below.components().filter(|part| matches!(part, Component::Normal(_))).collect();
    let mtime = status.as_ref().and_then(|status| status.modified().ok());
    Listed {
        path: path.to_owned(),
        place,
        size: status.map(|status| status.len()),
        mtime: mtime.map(|time| format_rfc3339_nanos(time).to_string()),
    }
}
