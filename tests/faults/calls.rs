//! The calls that a run makes to the system, seen and spoilt by strace: which files it touches, and what becomes of
//! the output when one of them fails.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use meshmend_tests::program::{BAD_INPUT, binary};
use meshmend_tests::scratch::Scratch;

use super::{said, sheet, wait};

/// Whether calls can be traced here; says so where not.
fn can_trace() -> bool {
    let can = Command::new("strace").args(["-o", "/dev/null", "true"]).output();
    let can = can.is_ok_and(|output| output.status.success());
    if !can {
        println!("skipped: strace is not there, or may not trace");
    }
    can
}

/// Two folders and a log: `in` with the input, what it names and what it does not; `out` with an old output.
struct Stage {
    folder: Scratch,
}

const OUTPUT: &str = "out/mesh.ply";
const CONVERT: [&str; 3] = ["convert", "in/sheet.obj", OUTPUT];

/// The exit status for an output that can't be written.
const UNWRITABLE: i32 = 4;

impl Stage {
    fn new() -> Self {
        let folder = Scratch::new();
        let stage = Stage { folder };
        for name in ["in", "out", "other"] {
            fs::create_dir(stage.path(name)).unwrap();
        }
        let foreign = stage.path("other/foreign.mtl");
        let names = format!("mtllib other.mtl ../other/foreign.mtl {}\ncall other.obj\n", foreign.display());
        fs::write(stage.path("in/sheet.obj"), names + &sheet(70)).unwrap();
        for name in ["in/sheet.mtl", "in/other.mtl", "in/other.obj", "other/foreign.mtl"] {
            fs::write(stage.path(name), "newmtl paint0\nmap_Kd texture.png\n").unwrap();
        }
        stage.reset();
        stage
    }

    fn reset(&self) {
        fs::write(self.path(OUTPUT), "old").unwrap();
    }

    /// Runs the binary; what it wrote.
    fn undisturbed(&self) -> Vec<u8> {
        let output = wait(Command::new(binary()).args(CONVERT).current_dir(self.folder.path()));
        assert!(output.status.success(), "{}", said(&output));
        fs::read(self.path(OUTPUT)).unwrap()
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Runs the binary under strace; what it said, and the trace.
    fn traced(&self, strace: &[&str], arguments: &[&str]) -> (Output, String) {
        let log = self.path("log");
        let mut command = Command::new("strace");
        command.args(["-f", "-qq", "-s", "4096"]).args(strace).arg("-o").arg(&log);
        command.arg(binary()).args(arguments).current_dir(self.folder.path());
        // The test runner's own libraries are no business of the program.
        command.env_remove("LD_LIBRARY_PATH");
        let output = wait(&mut command);
        (output, fs::read_to_string(&log).unwrap())
    }

    fn names_beside_the_output(&self) -> Vec<String> {
        let entries = fs::read_dir(self.path("out")).unwrap();
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
    }
}

/// Calls that open, make, move or remove something, reach out, or start another program. Not every system has each.
const TOUCHING: &str = "trace=?open,openat,?openat2,?creat,?rename,?renameat,?renameat2,?unlink,unlinkat,?mkdir,\
                        mkdirat,?link,linkat,?symlink,symlinkat,truncate,?chmod,fchmodat,socket,connect,execve";

/// Where the system keeps its own.
const SYSTEM: [&str; 7] = ["/lib", "/lib64", "/usr", "/etc", "/proc", "/sys", "/dev"];

/// The texts between quotation marks.
fn quoted(line: &str) -> impl Iterator<Item = &str> {
    line.split('"').skip(1).step_by(2)
}

#[test]
fn nothing_is_touched_but_the_input_and_the_folder_of_the_output() {
    if !can_trace() {
        return;
    }
    let stage = Stage::new();
    for arguments in [&CONVERT[..], &["repair", "in/sheet.obj", "-o", OUTPUT], &["check", "in/sheet.obj"]] {
        let (output, log) = stage.traced(&["-e", TOUCHING], arguments);
        assert!(output.status.code().is_some_and(|code| code <= 1), "{arguments:?}: {}", said(&output));
        let writes = arguments.contains(&OUTPUT);
        let is_fine = |path: &Path| {
            SYSTEM.iter().any(|folder| path.starts_with(folder))
                || path == stage.path("in/sheet.obj")
                || path == stage.path("in/sheet.mtl")
                // A library that the input names within its folder.
                || path == stage.path("in/other.mtl")
                || (writes && path.starts_with(stage.path("out")))
        };
        let (mut count, mut input_is_opened) = (0, false);
        for line in log.lines().filter(|line| !line.contains("+++") && !line.contains("---")) {
            assert!(!line.contains("socket(") && !line.contains("connect("), "{line}");
            if line.contains("execve(") {
                assert!(line.contains(&binary().display().to_string()), "{line}");
                continue;
            }
            for path in quoted(line).map(|path| stage.path(path)) {
                assert!(is_fine(&path), "{arguments:?}: {line}");
                input_is_opened |= path == stage.path("in/sheet.obj");
                count += 1;
            }
        }
        assert!(input_is_opened, "the trace shows nothing:\n{log}");
        println!("{arguments:?}: {count} paths");
    }
}

/// Calls of the system, and how each may fail.
const FAILING: [(&str, &[&str]); 8] = [
    ("openat", &["EIO", "EMFILE"]),
    ("read", &["EIO", "EINTR"]),
    ("write", &["ENOSPC", "EIO", "EINTR"]),
    ("fsync", &["EIO", "ENOSPC", "EINTR"]),
    ("/^rename", &["EIO", "ENOSPC"]),
    ("/^f?chmod", &["EPERM", "EIO"]),
    ("/statx?$", &["EIO"]),
    ("getdents64", &["EIO"]),
];

#[test]
fn whichever_call_of_the_system_fails_the_output_is_the_old_or_the_new_one() {
    if !can_trace() {
        return;
    }
    let stage = Stage::new();
    let new = stage.undisturbed();
    for (call, error) in
        FAILING.iter().flat_map(|&(call, errors)| errors.iter().map(move |&error| (call, error)))
    {
        let (mut count, mut successes) = (0, 0);
        loop {
            stage.reset();
            let spoilt = format!("inject={call}:error={error}:when={}", count + 1);
            let (output, log) = stage.traced(&["-e", &spoilt], &CONVERT);
            if !log.contains("(INJECTED)") {
                break;
            }
            count += 1;
            let case = format!("{spoilt}: {:?}, {}", output.status, said(&output));
            // What fails before the program begins, the loader reports.
            assert!(matches!(output.status.code(), Some(0 | BAD_INPUT | UNWRITABLE | 127)), "{case}");
            let found = fs::read(stage.path(OUTPUT)).unwrap();
            assert!(found == new || found == b"old", "{case}");
            assert!(!output.status.success() || found == new, "{case}");
            assert_eq!(stage.names_beside_the_output(), ["mesh.ply"], "{case}");
            successes += usize::from(output.status.success());
        }
        assert!(count > 0, "{call}: never called");
        println!("{call} fails with {error}: {count} places, {successes} of them harmless");
    }
}

#[test]
fn whichever_call_of_the_system_is_the_last_the_output_is_the_old_or_the_new_one() {
    if !can_trace() {
        return;
    }
    let stage = Stage::new();
    let new = stage.undisturbed();
    for call in ["openat", "write", "/^f?chmod", "fsync", "/^rename", "/^unlink", "close", "exit_group"] {
        let (mut count, mut debris) = (0, 0);
        loop {
            stage.reset();
            let last = format!("inject={call}:signal=SIGKILL:when={}", count + 1);
            let (output, _) = stage.traced(&["-e", &last], &CONVERT);
            if output.status.success() {
                break;
            }
            count += 1;
            let found = fs::read(stage.path(OUTPUT)).unwrap();
            assert!(found == new || found == b"old", "{last}");
            if stage.names_beside_the_output() != ["mesh.ply"] {
                debris += 1;
                assert_eq!(stage.undisturbed(), new, "{last}");
                assert_eq!(stage.names_beside_the_output(), ["mesh.ply"], "{last}: debris stays");
            }
        }
        assert!(count > 0, "{call}: never called");
        println!("killed at {call}: {count} places, debris at {debris} of them, cleared by the next run");
    }
}
