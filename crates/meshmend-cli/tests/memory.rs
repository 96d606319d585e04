//! `check --memory`: the same report within a bound of memory, and nothing left on disk.

mod common;

use std::fs;
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use common::{Folder, example, meshmend, program};

/// A file made by the program.
fn made(folder: &Folder, name: &str, arguments: &[&str]) -> String {
    let path = folder.at(name);
    meshmend(&[&["make"], arguments, &["-o", &path]].concat()).succeeds();
    path
}

#[test]
fn reports_of_every_form_are_those_of_a_check_in_memory() {
    let folder = Folder::new();
    let band = made(&folder, "band.ply", &["moebius-band", "--triangles"]);
    let soup = made(&folder, "soup.stl", &["pinched-torus", "--triangles"]);
    let binary = folder.at("scan.ply");
    meshmend(&["convert", &example("scan.ply"), &binary, "--encoding", "big-endian"]).succeeds();
    for options in [
        &["--json"][..],
        &[],
        &["--table"],
        &["--sarif"],
        &["--json", "--weld", "exact", "--limit", "2"],
        &["--json", "--weld", "none", "--fail-on", "boundary-edge"],
    ] {
        let arguments = [&["check", &band, &soup, &binary], options].concat();
        let whole = meshmend(&arguments);
        let bounded = meshmend(&[&arguments[..], &["--memory", "256MiB"]].concat());
        assert_eq!((bounded.status, bounded.stderr), (whole.status, whole.stderr), "{options:?}");
        assert_eq!(bounded.stdout, whole.stdout, "{options:?}");
    }
}

#[test]
fn what_takes_a_mesh_in_memory_is_refused() {
    let folder = Folder::new();
    let soup = made(&folder, "soup.stl", &["torus", "--triangles"]);
    let check = |options: &[&str]| meshmend(&[&["check", &soup, "--memory", "1GiB"], options].concat());
    check(&["--geometry"]).fails(2, "cannot be used with");
    check(&["--kernel", "half-edge"]).fails(2, "cannot be used with");
    check(&["--witness", "shortest"]).fails(2, "cannot be used with");
    check(&["--by", "solid"]).fails(2, "cannot be used with");
    check(&["--fail-on", "crossing-faces"]).fails(2, "--memory: where faces lie");
    check(&["--weld", "0.1"]).fails(2, "--memory takes --weld none or exact");
    check(&["--spill", &folder.at("missing")]).fails(4, "missing: ");
    meshmend(&["check", "--memory", "1GiB", "-"]).fails(2, "standard input can be read once");
    meshmend(&["check", "--memory", "1GiB", &example("broken.obj")])
        .fails(3, "piece by piece: leave out --memory");
    meshmend(&["check", "--memory", "1MB", &soup]).fails(3, "more than the ");
    meshmend(&["check", "--spill", &folder.at(""), &soup]).fails(2, "--memory");
}

/// Killed at any moment, it leaves nothing behind: its files have no name.
#[test]
#[cfg(unix)]
fn a_kill_leaves_nothing_on_disk() {
    let folder = Folder::new();
    let soup = made(&folder, "soup.stl", &["torus", "--resolution", "200", "--triangles"]);
    let spill = folder.at("spill");
    fs::create_dir(&spill).unwrap();
    for milliseconds in [0, 5, 10, 20, 40, 80, 160, 320, 640, 100_000] {
        let mut command = program();
        command.args(["check", &soup, "--memory", "64MiB", "--spill", &spill]);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        for _ in 0..milliseconds {
            if child.try_wait().unwrap().is_some() {
                break;
            }
            sleep(Duration::from_millis(1));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        assert_eq!(fs::read_dir(&spill).unwrap().count(), 0, "after {milliseconds} ms");
    }
}

/// A disk that takes no more is an error with its folder, and nothing is left.
#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_an_error_and_leaves_nothing() {
    let folder = Folder::new();
    let soup = made(&folder, "soup.stl", &["torus", "--resolution", "100", "--triangles"]);
    let spill = folder.at("spill");
    fs::create_dir(&spill).unwrap();
    // No file may grow beyond so many blocks, and a file that does is an error in place of a signal.
    for blocks in ["0", "64", "1000"] {
        let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$@\"");
        let output = std::process::Command::new("sh")
            .args(["-c", &script, "sh", env!("CARGO_BIN_EXE_meshmend"), "check", "--memory", "40MiB"])
            .args(["--spill", &spill, &soup])
            .output()
            .unwrap();
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(4), "{blocks} blocks: {said}");
        assert!(said.contains(&format!("{spill}: File too large")), "{blocks} blocks: {said}");
        assert_eq!(fs::read_dir(&spill).unwrap().count(), 0);
    }
}
