//! Other programs that read glTF, over many files in one run: the validator of its makers, and a library in JavaScript.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;

/// What the validator says of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Validated {
    /// The codes of its errors, each with the place, sorted.
    pub errors: Vec<String>,
    /// How many triangles it has.
    pub triangles: Option<u64>,
}

/// What the validator says of each file; `None`, and a message, where it is not installed (`npm ci` in `tests/node`).
///
/// # Panics
/// If the validator fails.
pub fn validated(files: &[PathBuf]) -> Option<Vec<Validated>> {
    Some(lines("validate.js", files)?.iter().map(answer).collect())
}

/// What glTF-Transform reads in each file, as `inspect.js` prints it; `None`, and a message, where it is not installed.
///
/// # Panics
/// If the script fails.
pub fn inspected(files: &[PathBuf]) -> Option<Vec<Value>> {
    lines("inspect.js", files)
}

/// The line of JSON that a script prints for each file.
fn lines(script: &str, files: &[PathBuf]) -> Option<Vec<Value>> {
    let folder = installed()?;
    let mut answers = Vec::new();
    for files in files.chunks(200) {
        let output = Command::new("node").arg(folder.join(script)).args(files).output().expect("node runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let text = String::from_utf8(output.stdout).expect("scripts print UTF-8");
        answers.extend(text.lines().map(|line| serde_json::from_str::<Value>(line).expect("a line is JSON")));
    }
    assert_eq!(answers.len(), files.len());
    Some(answers)
}

fn answer(value: &Value) -> Validated {
    let issues = value["issues"].as_array().into_iter().flatten();
    let errors = issues.filter(|issue| issue["severity"] == 0);
    let mut errors: Vec<String> = errors
        .map(|issue| format!("{} at {}: {}", issue["code"], issue["pointer"], issue["message"]))
        .collect();
    errors.sort();
    Validated { errors, triangles: value["triangles"].as_u64() }
}

/// The folder of the scripts, if node and what they need are there.
fn installed() -> Option<PathBuf> {
    static FOUND: OnceLock<Option<PathBuf>> = OnceLock::new();
    let find = || {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("node");
        let has = |package: &str| folder.join("node_modules").join(package).is_dir();
        let runs = || Command::new("node").arg("--version").output().is_ok_and(|run| run.status.success());
        if has("gltf-validator") && has("@gltf-transform/core") && runs() {
            return Some(folder);
        }
        println!("skipped: the judges of glTF are not installed (npm ci in tests/node)");
        None
    };
    FOUND.get_or_init(find).clone()
}
