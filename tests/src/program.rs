//! The `meshmend` binary.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The exit status for a file that can't be read.
pub const BAD_INPUT: i32 = 3;

/// The exit status of what a policy refuses, such as a repair that would leave no face.
pub const REFUSED: i32 = 5;

/// The binary: what `MESHMEND_BIN` names, or a fresh build in the profile of the tests.
///
/// # Panics
/// When it can't be built.
pub fn binary() -> &'static Path {
    static BINARY: OnceLock<PathBuf> = OnceLock::new();
    BINARY.get_or_init(|| match std::env::var_os("MESHMEND_BIN") {
        Some(path) => path.into(),
        None => built(),
    })
}

/// Runs the binary to its end.
///
/// # Panics
/// When it can't be started.
pub fn run(arguments: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Output {
    Command::new(binary()).args(arguments).output().expect("the binary starts")
}

/// Builds the binary into the folder that this test was built into.
fn built() -> PathBuf {
    let test = std::env::current_exe().expect("a test knows where it is");
    let profile = test.parent().and_then(Path::parent).expect("tests lie in deps, beside the binaries");
    let target = profile.parent().expect("profiles lie in the target folder");
    let mut build = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    build.args(["build", "--quiet", "--package", "meshmend-cli", "--target-dir"]).arg(target);
    if profile.ends_with("release") {
        build.arg("--release");
    }
    let output = build.current_dir(env!("CARGO_MANIFEST_DIR")).output().expect("cargo runs");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "meshmend-cli does not build: {complaint}");
    profile.join(format!("meshmend{}", std::env::consts::EXE_SUFFIX))
}
