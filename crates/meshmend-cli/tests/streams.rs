//! Standard input and output in place of files, and formats that are told or recognised.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod common;

use std::fs;
use std::io::Write;
use std::process::Stdio;

use common::{Folder, example, meshmend, piped, program};

/// A copy of an example that names no other file: a stream has no folder in which that could be missed.
fn alone(folder: &Folder, name: &str) -> (String, Vec<u8>) {
    const OTHER: &[u8] = b"mtllib paint.mtl\n";
    let mut content = fs::read(example(name)).unwrap();
    if let Some(at) = content.windows(OTHER.len()).position(|window| window == OTHER) {
        content.drain(at..at + OTHER.len());
    }
    let path = folder.at(name);
    fs::write(&path, &content).unwrap();
    (path, content)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[track_caller]
fn refused(arguments: &[&str], status: i32, reason: &str) {
    let run = piped(arguments, b"v 0 0 0\n");
    assert_eq!(run.status.code(), Some(status), "{}", text(&run.stderr));
    assert!(text(&run.stderr).contains(reason), "{}", text(&run.stderr));
    assert_eq!(run.stdout, b"");
}

#[test]
fn standard_input_is_checked_as_the_file_is() {
    let folder = Folder::new();
    for name in ["broken.obj", "pinched.ply", "soup.stl", "moebius.off"] {
        let (path, content) = alone(&folder, name);
        let of_file = meshmend(&["check", &path]);
        let of_stream = piped(&["check", "-"], &content);
        assert_eq!(of_stream.status.code(), Some(of_file.status), "{name}");
        assert_eq!(text(&of_stream.stdout), of_file.stdout.replace(&path, "standard input"), "{name}");
        assert_eq!(text(&of_stream.stderr), of_file.stderr);
        for command in [
            &["loops", "-"][..],
            &["incremental", "-"],
            &["matrix", "-"],
            &["kernels", "-"],
            &["check", "--json", "-"],
        ] {
            let run = piped(command, &content);
            assert!(text(&run.stdout).contains("standard input"), "{command:?}: {}", text(&run.stderr));
        }
    }
}

#[test]
fn a_repair_reads_and_writes_streams_and_nothing_but_the_mesh_goes_out() {
    let folder = Folder::new();
    for (name, format) in
        [("broken.obj", "obj"), ("pinched.ply", "ply"), ("soup.stl", "stl"), ("moebius.off", "off")]
    {
        let (path, content) = alone(&folder, name);
        let target = folder.at(&format!("mended.{format}"));
        let of_file = meshmend(&["repair", &path, "-o", &target]);
        for options in [&[][..], &["--to", format]] {
            let run = piped(&[&["repair", "-", "-o", "-"], options].concat(), &content);
            assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
            assert_eq!(run.stdout, fs::read(&target).unwrap(), "{name}");
            let report = of_file.stdout.replace(&target, "standard output").replace(&path, "standard input");
            assert_eq!(text(&run.stderr), report, "{name}");
        }
        let quiet = piped(&["repair", "-", "-o", "-", "--quiet"], &content);
        assert_eq!((quiet.stdout, text(&quiet.stderr).lines().count()), (fs::read(&target).unwrap(), 1));
    }
    // A dry run writes no mesh, so its report has standard output for itself.
    let dry =
        piped(&["repair", "-", "-o", "-", "--dry-run", "--json"], b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert!(serde_json::from_slice::<serde_json::Value>(&dry.stdout).is_ok(), "{}", text(&dry.stderr));
}

#[test]
fn every_command_that_writes_a_mesh_or_a_picture_writes_it_to_a_stream_too() {
    let folder = Folder::new();
    let obj = fs::read(example("broken.obj")).unwrap();
    let ply = piped(&["convert", "-", "-", "--to", "ply"], &obj);
    assert!(ply.stdout.starts_with(b"ply\nformat binary_little_endian"), "{}", text(&ply.stderr));
    assert!(text(&ply.stderr).contains("standard input → standard output"), "{}", text(&ply.stderr));
    let back = piped(&["convert", "-", &folder.at("back.obj")], &ply.stdout);
    assert!(text(&back.stdout).contains("standard input → ") && back.stderr.is_empty());
    let same = piped(&["convert", "-", "-"], b"OFF\n1 0 0\n1 2 3\n");
    assert_eq!(text(&same.stdout), "OFF\n1 0 0\n1 2 3\n");

    let torus = piped(&["make", "torus", "-o", "-", "--to", "off"], b"");
    assert!(torus.stdout.starts_with(b"OFF\n"), "{}", text(&torus.stderr));
    for (command, start) in [
        (&["cut", "-", "-o", "-"][..], &b"OFF\n"[..]),
        (&["cut", "-", "-o", "-", "--to", "obj"], b"v "),
        (&["render", "-", "-o", "-", "--to", "svg"], b"<svg"),
        (&["render", "-", "-o", "-", "--to", "png"], b"\x89PNG"),
        (&["incremental", "-", "--plot", "-"], b"<svg"),
        (&["matrix", "-", "--matrix-market", "-"], b"%%MatrixMarket"),
    ] {
        let run = piped(command, &torus.stdout);
        assert_eq!(run.status.code(), Some(0), "{command:?}: {}", text(&run.stderr));
        assert!(run.stdout.starts_with(start), "{command:?}");
        assert!(!run.stderr.is_empty(), "the report goes to the other stream");
    }
}

#[test]
fn what_can_not_share_a_stream_is_refused_with_the_reason() {
    let both = "--json prints to standard output, which carries what is written to `-`";
    refused(&["repair", "-", "-o", "-", "--json"], 2, both);
    refused(&["cut", "-", "-o", "-", "--json"], 2, both);
    refused(&["incremental", "-", "--plot", "-", "--json"], 2, both);
    refused(&["repair", "-", "-o", "x.obj", "--report", "-"], 2, "--report writes a file");
    refused(&["make", "torus", "-o", "-"], 2, "standard output: --to must tell the format");
    refused(&["render", "-", "-o", "-"], 2, "--to must tell the format");
    refused(
        &["convert", "-", "-", "--to", "obj", "--encoding", "binary"],
        2,
        "standard output: OBJ has no such encoding",
    );
    let twice = piped(&["check", "-", "-"], b"v 0 0 0\n");
    assert!(text(&twice.stderr).contains("standard input can be read only once"));
    assert_eq!(twice.status.code(), Some(2));
    let unknown = piped(&["check", "-"], b"hello");
    assert_eq!(unknown.status.code(), Some(3));
    let told = text(&unknown.stderr);
    assert!(told.starts_with("meshmend: standard input: the format is not known; known are OBJ, "), "{told}");
    assert!(told.ends_with("; --from tells it\n"), "{told}");
    // There, --from is where walks begin.
    let unknown = piped(&["matrix", "-"], b"hello");
    assert!(text(&unknown.stderr).ends_with("; --format tells it\n"), "{}", text(&unknown.stderr));
}

/// A stream is not a file: the folder may hold a file of that name, and both ends of a pipe may have the same name.
#[test]
fn a_file_that_is_called_like_a_stream_is_left_alone() {
    let folder = Folder::new();
    let obj = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let file = folder.with("-", "OFF\n1 0 0\n1 2 3\n");
    for command in [
        &["repair", "-", "-o", "-"][..],
        &["convert", "-", "-", "--from", "obj", "--to", "stl", "--encoding", "ascii"],
        &["cut", "-", "-o", "-"],
        &["render", "-", "-o", "-", "--to", "svg"],
        &["incremental", "-", "--plot", "-"],
    ] {
        let mut child = program()
            .args(command)
            .current_dir(folder.at("."))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(obj).unwrap();
        let run = child.wait_with_output().unwrap();
        assert_eq!(run.status.code(), Some(0), "{command:?}: {}", text(&run.stderr));
        assert!(!run.stdout.is_empty());
    }
    assert_eq!(fs::read_to_string(file).unwrap(), "OFF\n1 0 0\n1 2 3\n");
}

#[test]
fn what_depends_on_the_format_of_the_input_is_judged_when_it_is_known() {
    let soup = fs::read(example("soup.stl")).unwrap();
    let colors = piped(&["convert", "-", "-", "--stl-colors", "decode"], &soup);
    assert_eq!((colors.status.code(), &colors.stdout[..]), (Some(2), &b""[..]), "{}", text(&colors.stderr));
    assert!(text(&colors.stderr).contains("--stl-colors decode has no meaning for STL"));
    let folder = Folder::new();
    let report = folder.at("report.json");
    let obj = fs::read(example("broken.obj")).unwrap();
    let run = piped(&["repair", "-", "-o", "-", "--to", "stl", "--report", &report], &obj);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let target = folder.at("mended.stl");
    meshmend(&["repair", &example("broken.obj"), "-o", &target]).succeeds();
    assert_eq!(run.stdout, fs::read(&target).unwrap());
    let report: serde_json::Value = serde_json::from_slice(&fs::read(&report).unwrap()).unwrap();
    assert_eq!(report["output"], "standard output");
}

#[test]
fn a_told_format_goes_before_name_and_content() {
    let folder = Folder::new();
    let headless = folder.with("a.txt", "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    meshmend(&["check", &headless]).fails(3, "the format is not known");
    meshmend(&["check", "--from", "off", &headless]).fails(0, "");
    meshmend(&["kernels", "--from", "off", &headless]).succeeds();
    meshmend(&["kernels", "--from", "off"]).fails(2, "FILE");
    let obj = folder.with("a.ply", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let recognised = meshmend(&["check", &obj]);
    assert!(
        recognised.stdout.contains("the name ends in `ply`, but the content is OBJ"),
        "{}",
        recognised.stdout
    );
    let told = meshmend(&["check", "--from", "obj", &obj]);
    assert!(!told.stdout.contains("the name ends"), "{}", told.stdout);
    meshmend(&["check", "--from", "ply", &obj]).fails(3, "a PLY file begins with the line `ply`");
    let out = folder.at("b.obj");
    meshmend(&["convert", &obj, &out, "--to", "off"]).succeeds();
    assert!(fs::read(&out).unwrap().starts_with(b"OFF\n"));
    meshmend(&["convert", "--from", "fbx", &obj, &out]).fails(2, "the formats are obj, ply");
    let page = folder.with("c.stl", "<!DOCTYPE html><html></html>");
    meshmend(&["check", &page]).fails(3, "c.stl: looks like HTML");
}

/// As with `| head -1`: it is not an error when the reader has gone away.
#[test]
fn a_reader_that_goes_away_ends_the_output_without_a_word() {
    for arguments in [
        &["make", "torus", "-o", "-", "--to", "obj", "--resolution", "150"][..],
        &["make", "torus", "-o", "-", "--to", "ply", "--resolution", "150"],
    ] {
        let mut child =
            program().args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let run = child.wait_with_output().unwrap();
        assert_eq!(run.status.code(), Some(0));
        assert!(!text(&run.stderr).contains("meshmend: "), "{}", text(&run.stderr));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_behind_standard_output_is_told() {
    let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let run = program().args(["make", "torus", "-o", "-", "--to", "obj"]).stdout(full).output().unwrap();
    assert_eq!(run.status.code(), Some(4));
    assert!(text(&run.stderr).starts_with("meshmend: standard output: "), "{}", text(&run.stderr));
}
