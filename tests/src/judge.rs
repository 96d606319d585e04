//! The independent checker of repaired meshes.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;

use crate::shared::shared;

/// How many files one run of the checker looks at: its start is slow, and two runs at a time are enough.
const FILES_A_RUN: usize = 40;

/// A Python with numpy; nothing, and a message, where there is none.
pub fn python() -> Option<&'static str> {
    static FOUND: OnceLock<Option<String>> = OnceLock::new();
    let found = FOUND.get_or_init(|| {
        let name = std::env::var("MESHMEND_PYTHON").unwrap_or_else(|_| "python3".to_owned());
        let output = Command::new(&name).args(["-c", "import numpy"]).output();
        output.is_ok_and(|output| output.status.success()).then_some(name)
    });
    if found.is_none() {
        println!("skipped: there is no python3 with numpy (MESHMEND_PYTHON can name one)");
    }
    found.as_deref()
}

/// The checker of attributes finds no difference between two files but those that options allow. Nothing is checked where it
/// can't run.
///
/// # Panics
/// If it finds one.
pub fn assert_attributes_kept(before: &Path, after: &Path, options: &[&str], name: &str) {
    let (Some(checker), Some(python)) = (shared("tools/check_attributes.py"), python()) else { return };
    let mut command = Command::new(python);
    command.env("PYTHONDONTWRITEBYTECODE", "1").arg(checker).args(options).args([before, after]);
    let output = command.output().expect("the interpreter runs");
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{name}: {said}");
}

/// What the checker says of one file.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The file.
    pub path: PathBuf,
    /// The properties of `clean` that it lacks.
    pub lacks: Vec<String>,
    /// All that the checker found.
    pub findings: Value,
}

/// Judges files by `--require clean`, in their order; nothing, and a message, where the checker can't run.
pub fn judge_clean(files: &[PathBuf]) -> Option<Vec<Verdict>> {
    let checker = shared("tools/check_repaired.py")?;
    let python = python()?;
    let judge = |files: &[PathBuf]| judge_some(python, &checker, files);
    Some(files.chunks(FILES_A_RUN).flat_map(judge).collect())
}

fn judge_some(python: &str, checker: &Path, files: &[PathBuf]) -> Vec<Verdict> {
    let mut command = Command::new(python);
    command
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .arg(checker)
        .args(["--json", "--require", "clean"])
        .args(files);
    let output = command.output().expect("the interpreter runs");
    let text = String::from_utf8_lossy(&output.stdout);
    let lines: Vec<&str> = text.lines().collect();
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(lines.len(), files.len(), "the checker gave up: {complaint}");
    let verdict = |(path, line): (&PathBuf, &str)| {
        let findings: Value = serde_json::from_str(line).expect("the checker speaks JSON");
        let missing = findings["missing"].as_array().cloned().unwrap_or_default();
        let lacks = missing.iter().map(|name| name.as_str().expect("a name").to_owned()).collect();
        Verdict { path: path.clone(), lacks, findings }
    };
    files.iter().zip(lines).map(verdict).collect()
}
