//! Examples of additions that CONTRIBUTING shows: what it says of their edits is what they are.

use std::fs;
use std::path::{Path, PathBuf};

/// An addition that is one file, and one row in `main.rs` beside it.
#[derive(Clone, Copy, Debug)]
pub struct Example {
    /// The folder, from the root of the project: it holds `main.rs` and the addition alone.
    pub folder: &'static str,
    /// The macro in which the row stands.
    pub registry: &'static str,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The files of Rust below a folder.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !path.ends_with("target") {
            sources(&path, found);
        } else if path.extension().is_some_and(|suffix| suffix == "rs") {
            found.push(path);
        }
    }
}

impl Example {
    /// The name of the added file, without its ending.
    fn name(&self) -> String {
        let mut found = Vec::new();
        sources(&root().join(self.folder), &mut found);
        let mut names = found.iter().map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned());
        names.find(|name| name != "main").expect("a file beside main.rs")
    }

    fn path(&self) -> String {
        format!("{}/{}.rs", self.folder, self.name())
    }

    fn main(&self) -> String {
        format!("{}/main.rs", self.folder)
    }

    fn row(&self) -> String {
        format!("    {}", self.name())
    }

    /// The diff in CONTRIBUTING adds the row, and the file to the letter.
    pub fn assert_shown(&self) {
        let page = fs::read_to_string(root().join("CONTRIBUTING.md")).unwrap();
        let diff =
            page.split("```diff\n").find(|block| block.contains(&self.path())).expect("the diff is shown");
        let diff = diff.split("```").next().unwrap();
        let (row, file) = diff.split_once(&format!("+++ {}\n", self.path())).expect("the file is shown last");
        let shown: Vec<&str> = file.lines().map(|line| line.strip_prefix('+').expect("a new file")).collect();
        let source = fs::read_to_string(root().join(self.path())).unwrap();
        assert_eq!(shown, source.lines().collect::<Vec<_>>());
        let added: Vec<&str> =
            row.lines().filter(|line| line.starts_with('+') && !line.starts_with("+++")).collect();
        assert_eq!(added, [format!("+{}", self.row())]);
        assert!(row.contains(&format!("+++ {}\n", self.main())));
        assert!(row.contains(&format!(" {}! {{\n", self.registry)));
    }

    /// No other file of the project names the addition, but for the row.
    pub fn assert_one_file_and_one_row(&self) {
        let mut found = Vec::new();
        ["crates", "tests", "fuzz"].iter().for_each(|folder| sources(&root().join(folder), &mut found));
        let [file, main] = [self.path(), self.main()].map(|path| root().join(path).canonicalize().unwrap());
        let (name, row) = (self.name(), self.row());
        for path in found.iter().map(|path| path.canonicalize().unwrap()).filter(|path| *path != file) {
            let text = fs::read_to_string(&path).unwrap();
            let naming: Vec<&str> = text.lines().filter(|line| line.contains(&name)).collect();
            let expected: &[&str] = if path == main { &[&row] } else { &[] };
            assert_eq!(naming, expected, "{}", path.display());
        }
    }
}
