//! Hostile and hard files, each with the outcome that it must have, judged from outside the process: status, message,
//! time, memory, what is left behind, and the result in the eyes of the independent checker.

use std::path::Path;
use std::process::Command;

use meshmend_tests::judge::python;
use meshmend_tests::program::{BAD_INPUT, REFUSED, binary};
use meshmend_tests::scratch::Scratch;
use meshmend_tests::shared::shared;

#[test]
fn every_hostile_file_ends_as_it_must() {
    run(None, &[]);
}

#[test]
fn results_in_the_other_formats_are_as_good() {
    for extension in ["ply", "obj"] {
        run(None, &["--ext", extension]);
    }
}

/// Takes a minute; set `MESHMEND_BIG` to run it.
#[test]
fn every_large_hostile_file_ends_as_it_must() {
    if std::env::var_os("MESHMEND_BIG").is_none() {
        println!("skipped: MESHMEND_BIG is not set");
        return;
    }
    let (Some(torture), Some(python)) = (shared("torture"), python()) else { return };
    let scratch = Scratch::new();
    let mut build = Command::new(python);
    build.env("PYTHONDONTWRITEBYTECODE", "1").arg(torture.join("build.py")).arg("--big").arg(scratch.path());
    assert!(build.status().unwrap().success());
    run(Some(scratch.path()), &["--seconds", "120"]);
}

/// Runs the whole set, with the large files of a folder if there is one.
fn run(big: Option<&Path>, options: &[&str]) {
    let (Some(torture), Some(tool)) = (shared("torture"), shared("tools/run_torture.py")) else { return };
    let Some(python) = python() else { return };
    let mut command = Command::new(python);
    command.env("PYTHONDONTWRITEBYTECODE", "1").arg(tool).arg("--set").arg(torture);
    command.args([
        "--ext",
        "off",
        "--twice",
        "--jobs",
        "2",
        "--error-status",
        &format!("{BAD_INPUT},{REFUSED}"),
    ]);
    command.args(options);
    if let Some(big) = big {
        command.arg("--big").arg(big);
    }
    command.arg("--").arg(binary()).args(["repair", "{in}", "-o", "{out}"]);
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    println!("{said}");
}
