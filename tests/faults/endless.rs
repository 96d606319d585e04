//! Inputs without an end, and outputs that take nothing.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use meshmend_tests::program::{BAD_INPUT, binary};
use meshmend_tests::scratch::Scratch;

use super::{said, sheet, wait};

/// An address space in KiB in which the default limit for sources without a size is reached, and not much more.
const ROOM: &str = "6000000";

fn within(folder: &Path, arguments: &[&str]) -> Output {
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -v \"$0\" && exec \"$@\"", ROOM]);
    wait(shell.arg(binary()).args(arguments).current_dir(folder))
}

#[test]
fn a_device_without_an_end_is_read_up_to_a_limit_that_has_a_name() {
    let folder = Scratch::new();
    let output = within(folder.path(), &["check", "/dev/zero"]);
    assert_eq!(output.status.code(), Some(BAD_INPUT), "{}", said(&output));
    assert!(said(&output).contains("max_stream_bytes"), "{}", said(&output));
}

#[test]
fn a_pipe_without_an_end_is_read_up_to_that_limit_whatever_comes_from_it() {
    let folder = Scratch::new();
    let pipe = folder.path().join("endless.obj");
    assert!(wait(Command::new("mkfifo").arg(&pipe)).status.success());
    let mut source = Command::new("sh");
    source.args(["-c", "exec yes '# a comment that never ends, and so on and so on' > endless.obj"]);
    let mut source = source.current_dir(folder.path()).stderr(Stdio::null()).spawn().unwrap();
    let output = within(folder.path(), &["convert", "endless.obj", "out.ply"]);
    source.kill().ok();
    source.wait().unwrap();
    assert_eq!(output.status.code(), Some(BAD_INPUT), "{}", said(&output));
    assert!(said(&output).contains("max_stream_bytes"), "{}", said(&output));
    assert_eq!(folder.file_names(), ["endless.obj"]);
}

#[test]
fn a_pipe_with_an_end_is_a_file_like_any_other() {
    let folder = Scratch::new();
    fs::write(folder.path().join("sheet.obj"), sheet(60)).unwrap();
    let pipe = folder.path().join("pipe.obj");
    assert!(wait(Command::new("mkfifo").arg(&pipe)).status.success());
    let mut source = Command::new("sh");
    source.args(["-c", "cat sheet.obj > pipe.obj"]);
    let mut source = source.current_dir(folder.path()).spawn().unwrap();
    let output = within(folder.path(), &["convert", "pipe.obj", "from-pipe.ply"]);
    source.wait().unwrap();
    assert!(output.status.success(), "{}", said(&output));
    assert!(within(folder.path(), &["convert", "sheet.obj", "from-file.ply"]).status.success());
    let bytes = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert_eq!(bytes("from-pipe.ply"), bytes("from-file.ply"));
}

#[test]
fn a_shape_beyond_all_memory_is_refused_in_a_small_address_space() {
    let folder = Scratch::new();
    let shapes =
        [["tetrahedron", "--refine", "40"], ["torus", "--resolution", "22000"], ["cube", "--refine", "13"]];
    for shape in shapes {
        let output = within(folder.path(), &[&["make"][..], &shape, &["-o", "x.ply"]].concat());
        assert_eq!(output.status.code(), Some(2), "{shape:?}: {}", said(&output));
        assert!(said(&output).contains("so large"), "{shape:?}: {}", said(&output));
    }
    assert!(folder.file_names().is_empty());
}
