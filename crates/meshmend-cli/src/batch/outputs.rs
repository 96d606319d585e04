//! Where results go: a tree like that of the inputs.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use meshmend::Format;

use super::Listed;
use crate::failure::Failure;

/// The tree of the results.
pub(crate) struct Tree<'a> {
    /// Its root.
    pub(crate) root: &'a Path,
    /// What stands between the name of a file and its extension.
    pub(crate) suffix: &'a str,
    /// The format that all have, if one was named.
    pub(crate) format: Option<Format>,
}

impl Tree<'_> {
    /// Where the results of these files go, in their order.
    ///
    /// # Errors
    /// If two would be one file, here or where names that differ in case alone are one; if one would take the place of an
    /// input, which the list of them is too; or if rows would be written into one of these.
    pub(crate) fn outputs(
        &self,
        files: &[Listed],
        list: Option<&Path>,
        ledger: &Path,
    ) -> Result<Vec<PathBuf>, Failure> {
        let wrong = |path: &Path, reason: &str| Failure::usage(format!("{}: {reason}", path.display()));
        let paths = files.iter().map(|file| file.path.as_path()).chain(list);
        let inputs: BTreeSet<PathBuf> = paths.map(real).collect();
        let place = real(ledger);
        if inputs.contains(&place) {
            return Err(wrong(ledger, "the ledger is an input too"));
        }
        let mut makers: BTreeMap<String, &Path> = BTreeMap::new();
        let mut outputs = Vec::new();
        for file in files {
            let output = self.root.join(self.place(&file.place));
            let there = real(&output);
            if inputs.contains(&there) {
                return Err(wrong(&output, "the output would take the place of an input"));
            }
            if there == place {
                return Err(wrong(ledger, "the ledger is an output too"));
            }
            if let Some(other) = makers.insert(output.to_string_lossy().to_lowercase(), &file.path) {
                let (one, other) = (file.path.display(), other.display());
                let reason = format!("the output of both {other} and {one}, where case makes no difference");
                return Err(wrong(&output, &reason));
            }
            outputs.push(output);
        }
        Ok(outputs)
    }

    fn place(&self, place: &Path) -> PathBuf {
        let stem = place.file_stem().unwrap_or_default().to_string_lossy();
        let ending = place.extension().map(|ending| ending.to_string_lossy().into_owned());
        let ending = match self.format {
            Some(format) if Format::from_path(place) != Some(format) => {
                format.extensions().first().map(|ending| (*ending).to_owned())
            }
            _ => ending,
        };
        let ending = ending.map(|ending| format!(".{ending}")).unwrap_or_default();
        place.with_file_name(format!("{stem}{}{ending}", self.suffix))
    }
}

/// A path without links, also that of a file that is not there yet.
fn real(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| match (path.parent(), path.file_name()) {
        (Some(parent), Some(name)) if parent.as_os_str().is_empty() => real(Path::new(".")).join(name),
        (Some(parent), Some(name)) => real(parent).join(name),
        _ => path.to_owned(),
    })
}
