//! The page for contributors beside the files that it shows.

use std::fs;
use std::path::{Path, PathBuf};

/// An example of the page: the files that it adds, and the rows that it adds to a registry.
#[derive(Clone, Debug)]
pub struct Example {
    /// The new files, in the order of the page.
    pub files: Vec<String>,
    /// The file with the registry.
    pub registry: String,
    /// The line there above the rows.
    pub above: String,
    /// The lines that are added there.
    pub rows: Vec<String>,
    /// The word by which the example is known, which is said nowhere else.
    pub word: String,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

impl Example {
    /// The one file beside `main.rs` in a folder, with its name as a row of a macro there.
    ///
    /// # Panics
    /// When there is no such file.
    pub fn beside_main(folder: &str, registry: &str) -> Self {
        let mut found = Vec::new();
        sources(&root().join(folder), &mut found);
        let mut names = found.iter().filter_map(|path| path.file_stem()?.to_str());
        let word = names.find(|name| *name != "main").expect("a file beside main.rs").to_owned();
        Example {
            files: vec![format!("{folder}/{word}.rs")],
            registry: format!("{folder}/main.rs"),
            above: format!("{registry}! {{"),
            rows: vec![format!("    {word}")],
            word,
        }
    }

    /// Asserts that the page shows the files as they are, and adds just these rows to the registry.
    ///
    /// # Panics
    /// When it does not.
    pub fn assert_shown(&self) {
        let page = fs::read_to_string(root().join("CONTRIBUTING.md")).expect("the page is there");
        let diff = page.split("```diff\n").find(|block| block.contains(&self.files[0])).expect("it is shown");
        let diff = diff.split("```").next().unwrap_or_default();
        let mut parts = diff.split("--- ");
        let registry = parts.by_ref().find(|part| !part.is_empty()).unwrap_or_default();
        assert!(registry.contains(&format!("+++ {}\n", self.registry)));
        let added = registry.lines().filter(|line| line.starts_with('+') && !line.starts_with("+++"));
        let rows: Vec<String> = self.rows.iter().map(|row| format!("+{row}")).collect();
        assert_eq!(added.collect::<Vec<_>>(), rows);
        assert!(registry.contains(&format!("\n {}\n{}\n", self.above, rows.join("\n"))), "{registry}");
        for file in &self.files {
            let part = parts.next().unwrap_or_else(|| panic!("{file} is not shown"));
            let shown = part
                .strip_prefix("/dev/null\n+++ ")
                .and_then(|part| part.strip_prefix(file.as_str())?.strip_prefix('\n'));
            let shown = shown.unwrap_or_else(|| panic!("{file} is not shown as a new file"));
            let lines: Vec<&str> =
                shown.lines().map(|line| line.strip_prefix('+').expect("a new line")).collect();
            let source = fs::read_to_string(root().join(file)).expect("the file is there");
            assert_eq!(lines, source.lines().collect::<Vec<_>>(), "{file}");
        }
        assert_eq!(parts.next(), None, "more files are shown");
    }

    /// Asserts that the rows of the registry are all that the sources say of the example, but for its own files and these
    /// others.
    ///
    /// # Panics
    /// When a file says something else of it.
    pub fn assert_said_nowhere_else(&self, others: &[&str]) {
        let mut found = Vec::new();
        ["crates", "tests", "fuzz"].iter().for_each(|folder| sources(&root().join(folder), &mut found));
        let own: Vec<PathBuf> = self
            .files
            .iter()
            .map(String::as_str)
            .chain(others.iter().copied())
            .map(|file| root().join(file))
            .collect();
        for path in found.iter().filter(|path| !own.contains(path)) {
            let text = fs::read_to_string(path).expect("a source is text");
            let naming: Vec<&str> = text.lines().filter(|line| line.contains(&self.word)).collect();
            let is_registry = *path == root().join(&self.registry);
            let rows: Vec<&str> =
                self.rows.iter().map(String::as_str).filter(|row| row.contains(&self.word)).collect();
            assert_eq!(naming, if is_registry { rows } else { Vec::new() }, "{}", path.display());
        }
    }
}

/// The files of Rust below a folder.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the folder is there") {
        let path = entry.expect("the folder can be read").path();
        if path.is_dir() && !path.ends_with("target") {
            sources(&path, found);
        } else if path.extension().is_some_and(|suffix| suffix == "rs") {
            found.push(path);
        }
    }
}
