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
    /// If two would be one file, or one would take the place of an input.
    pub(crate) fn outputs(&self, files: &[Listed]) -> Result<Vec<PathBuf>, Failure> {
        let real = |path: &Path| path.canonicalize().ok();
        let inputs: BTreeSet<PathBuf> = files.iter().filter_map(|file| real(&file.path)).collect();
        let mut makers: BTreeMap<PathBuf, &Path> = BTreeMap::new();
        let mut outputs = Vec::new();
        for file in files {
            let output = self.root.join(self.place(&file.place));
            let shown = output.display();
            if real(&output).is_some_and(|output| inputs.contains(&output)) {
                return Err(Failure::usage(format!("{shown}: the output would take the place of an input")));
            }
            if let Some(other) = makers.insert(output.clone(), &file.path) {
                let (one, other) = (file.path.display(), other.display());
                return Err(Failure::usage(format!("{shown}: the output of both {other} and {one}")));
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
