//! A ladder of address spaces: what a file declares is never asked of the memory.

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, ExitStatus, Output};

use meshmend_tests::program::{BAD_INPUT, binary};
use meshmend_tests::scratch::Scratch;

use super::{PANIC, said, sheet, wait};

/// Address spaces in MiB, beside the program itself. Between 64 and 68 the allocator's own reserve just fits, and leaves too little
/// for anything else whatever a file says; so no rung is there.
const LADDER: [u64; 9] = [32, 48, 96, 160, 224, 352, 480, 736, 992];

/// How large the program is, in MiB.
fn own_size() -> u64 {
    fs::metadata(binary()).unwrap().len().div_ceil(1 << 20)
}

/// Runs the binary with so many MiB of address space.
fn within(mebibytes: u64, folder: &Path, arguments: &[&str]) -> Output {
    let mut shell = Command::new("sh");
    shell.args(["-c", "ulimit -v \"$0\" && exec \"$@\"", &(mebibytes << 10).to_string()]);
    wait(shell.arg(binary()).args(arguments).current_dir(folder))
}

fn outcome(status: ExitStatus) -> String {
    match (status.code(), status.signal()) {
        (Some(code), _) => format!("status {code}"),
        (_, signal) => format!("signal {signal:?}"),
    }
}

/// Small files that declare, or refer to, far more than they hold.
fn hostile_files() -> Vec<(&'static str, Vec<u8>)> {
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let ply = |form: &str, vertices: u64, faces: u64, length: &str| {
        format!(
            "ply\nformat {form} 1.0\nelement vertex {vertices}\n{xyz}element face {faces}\n\
             property list {length} int vertex_indices\nend_header\n"
        )
    };
    let little = "binary_little_endian";
    let row = [ply(little, 1, 1, "uint").as_bytes(), &[0; 12], &u32::MAX.to_le_bytes(), &[0; 64]].concat();
    let stl = [&[b' '; 80][..], &u32::MAX.to_le_bytes(), &[0; 100]].concat();
    let nothing = format!(
        "ply\nformat {little} 1.0\nelement void 18446744073709551614\nelement vertex 3\n{xyz}end_header\n"
    );
    vec![
        ("vertices-plain.ply", ply("ascii", 2_000_000_000, 0, "uchar").into_bytes()),
        ("vertices.ply", ply(little, 2_000_000_000, 0, "uchar").into_bytes()),
        ("vertices-big.ply", ply("binary_big_endian", 2_147_483_647, 1, "uchar").into_bytes()),
        ("more-vertices.ply", ply(little, u64::MAX - 1, 0, "uchar").into_bytes()),
        ("faces.ply", ply(little, 0, 2_000_000_000, "uchar").into_bytes()),
        ("faces-plain.ply", ply("ascii", 0, 2_000_000_000, "uchar").into_bytes()),
        ("face.ply", row),
        ("face-plain.ply", [ply("ascii", 1, 1, "uint").as_bytes(), b"0 0 0\n4294967295 0 0 0\n"].concat()),
        ("nothing.ply", nothing.into_bytes()),
        ("facets.stl", stl),
        ("vertices.off", b"OFF\n2000000000 1 0\n0 0 0\n".to_vec()),
        ("faces.off", b"OFF\n1 2000000000 0\n0 0 0\n".to_vec()),
        ("face.off", b"OFF\n1 1 0\n0 0 0\n2000000000 0 0 0\n".to_vec()),
        ("index.obj", b"v 0 0 0\nf 1 2147483646 2147483647\n".to_vec()),
    ]
}

#[test]
fn declared_counts_are_an_error_in_any_address_space() {
    let folder = Scratch::new();
    let mut files: Vec<&str> = Vec::new();
    for (name, bytes) in hostile_files() {
        fs::write(folder.path().join(name), bytes).unwrap();
        files.push(name);
    }
    // The length of a file is such a count as well: this one is all hole.
    let hole = fs::File::create(folder.path().join("hole.stl")).unwrap();
    if hole.set_len(12 << 30).is_ok() {
        files.push("hole.stl");
    }
    let mut wrong = Vec::new();
    for (mebibytes, file) in LADDER.iter().flat_map(|&rung| files.iter().map(move |&file| (rung, file))) {
        let output = within(mebibytes + own_size(), folder.path(), &["convert", file, "out.off"]);
        let is_clean = output.status.code() == Some(BAD_INPUT) && said(&output).contains(file);
        if !is_clean || folder.path().join("out.off").exists() {
            wrong.push(format!("{mebibytes} MiB, {file}: {}: {}", outcome(output.status), said(&output)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    println!("{} files on {} rungs", files.len(), LADDER.len());
}

/// Memory that an honest file needs and the system does not have ends the process, as the language has it: `status 3`
/// where the file itself does not fit, a signal where what is made of it does not. The output is whole even then.
#[test]
fn an_honest_file_in_a_small_address_space_gives_the_whole_output_or_none() {
    const RUNGS: [u64; 9] = [8, 16, 24, 32, 48, 64, 128, 256, 1024];
    let folder = Scratch::new();
    fs::write(folder.path().join("sheet.obj"), sheet(300)).unwrap();
    let output = folder.path().join("out.ply");
    let arguments = ["repair", "sheet.obj", "-o", "out.ply"];
    let free = wait(Command::new(binary()).args(arguments).current_dir(folder.path()));
    assert!(free.status.success(), "{}", said(&free));
    let expected = fs::read(&output).unwrap();
    let mut successes = Vec::new();
    for mebibytes in RUNGS {
        fs::write(&output, "old").unwrap();
        let ended = within(mebibytes, folder.path(), &arguments);
        println!("{mebibytes} MiB: {}", outcome(ended.status));
        let found = fs::read(&output).unwrap();
        assert_eq!(found == expected, ended.status.success(), "{mebibytes} MiB: {}", said(&ended));
        assert!(found == expected || found == b"old", "{mebibytes} MiB");
        assert_ne!(ended.status.code(), Some(PANIC), "{mebibytes} MiB: {}", said(&ended));
        successes.push(ended.status.success());
    }
    assert_eq!(successes.first(), Some(&false), "the limit is not kept");
    assert_eq!(successes.last(), Some(&true), "the most is not enough");
}

/// Threads are asked for by their stacks; with stacks of this size none can be started.
#[test]
fn where_no_thread_can_be_started_the_output_is_the_same() {
    let folder = Scratch::new();
    fs::write(folder.path().join("small.obj"), sheet(3)).unwrap();
    fs::write(folder.path().join("large.obj"), sheet(300)).unwrap();
    for input in ["small.obj", "large.obj"] {
        let [with, without] = ["with.ply", "without.ply"];
        let repair = |output: &str, stack: &str| {
            let mut command = Command::new(binary());
            command.args(["repair", input, "-o", output, "--json"]);
            wait(command.env("RUST_MIN_STACK", stack).current_dir(folder.path()))
        };
        let ended = repair(with, "4194304");
        assert!(ended.status.success(), "{}", said(&ended));
        let ended = repair(without, "1000000000000000");
        assert!(ended.status.success(), "{}", said(&ended));
        let bytes = |output: &str| fs::read(folder.path().join(output)).unwrap();
        assert_eq!(bytes(with), bytes(without), "{input}");
    }
}
