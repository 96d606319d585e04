//! What CONTRIBUTING says of the edits that a new kind of defect takes is what they are.

use std::fs;
use std::path::{Path, PathBuf};

const FILE: &str = "tests/own_defect/crowded_vertex.rs";
const REGISTRY: &str = "tests/own_defect/main.rs";
const ROW: &str = "    crowded_vertex";

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

#[test]
fn the_diff_that_is_shown_is_true() {
    let page = fs::read_to_string(root().join("CONTRIBUTING.md")).unwrap();
    let diff = page.split("```diff\n").find(|block| block.contains(FILE)).expect("the diff is shown");
    let diff = diff.split("```").next().unwrap();
    let (row, file) = diff.split_once(&format!("+++ {FILE}\n")).expect("the file is shown last");
    let shown: Vec<&str> = file.lines().map(|line| line.strip_prefix('+').expect("a new file")).collect();
    let source = fs::read_to_string(root().join(FILE)).unwrap();
    assert_eq!(shown, source.lines().collect::<Vec<_>>());
    let added: Vec<&str> =
        row.lines().filter(|line| line.starts_with('+') && !line.starts_with("+++")).collect();
    assert_eq!(added, [format!("+{ROW}")]);
    assert!(row.contains(&format!("+++ {REGISTRY}\n")));
}

#[test]
fn a_kind_is_one_file_and_one_row() {
    let mut found = Vec::new();
    ["crates", "tests", "fuzz"].iter().for_each(|folder| sources(&root().join(folder), &mut found));
    let this = Path::new(file!()).file_name().unwrap();
    for path in
        found.iter().filter(|path| path.file_name() != Some(this) && !path.ends_with("crowded_vertex.rs"))
    {
        let text = fs::read_to_string(path).unwrap();
        let naming: Vec<&str> = text.lines().filter(|line| line.contains("crowded_vertex")).collect();
        let expected: &[&str] =
            if root().join(REGISTRY).canonicalize().unwrap() == path.canonicalize().unwrap() {
                &[ROW]
            } else {
                &[]
            };
        assert_eq!(naming, expected, "{}", path.display());
    }
}
