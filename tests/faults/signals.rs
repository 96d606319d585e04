//! A run that is asked to end: it removes what it has begun, and ends as the signal says.

use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, ExitStatus, Stdio};

use meshmend_tests::program::binary;
use meshmend_tests::scratch::Scratch;

use super::{sheet, wait};

const SIGNALS: [(&str, i32); 3] = [("HUP", 1), ("INT", 2), ("TERM", 15)];

/// Whether this process was started so that it, and what it starts, ignores a signal, as `nohup` does with HUP.
fn is_ignored(number: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok())
        .is_some_and(|mask| mask >> (number - 1) & 1 == 1)
}

/// A folder with an input that takes a while, and an old output.
fn stage() -> Scratch {
    let folder = Scratch::new();
    fs::write(folder.path().join("sheet.obj"), sheet(300)).unwrap();
    fs::write(folder.path().join("out.ply"), "old").unwrap();
    folder
}

/// Runs until something has been begun beside the output, and sends a signal. The shell in between may first say that
/// signals are to be ignored.
fn signalled(folder: &Scratch, before: &str, signal: &str) -> ExitStatus {
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("{before} exec \"$0\" convert sheet.obj out.ply --encoding ascii")]);
    let mut child = shell.arg(binary()).current_dir(folder.path()).stdout(Stdio::null()).spawn().unwrap();
    while folder.file_names().len() == 2 && child.try_wait().unwrap().is_none() {
        std::thread::yield_now();
    }
    send(&child, signal);
    child.wait().unwrap()
}

fn send(child: &Child, signal: &str) {
    let arguments = ["-c", "kill -s \"$0\" \"$1\"", signal, &child.id().to_string()];
    wait(Command::new("sh").args(arguments));
}

#[test]
fn a_run_that_is_asked_to_end_leaves_nothing_and_ends_by_the_signal() {
    let folder = stage();
    for (signal, number) in SIGNALS {
        if is_ignored(number) {
            println!("skipped: {signal} is ignored by what started the tests");
            continue;
        }
        let mut ended = 0;
        for _ in 0..40 {
            fs::write(folder.path().join("out.ply"), "old").unwrap();
            let status = signalled(&folder, "", signal);
            assert_eq!(folder.file_names(), ["out.ply", "sheet.obj"], "{signal}: {status}");
            let is_old = fs::read(folder.path().join("out.ply")).unwrap() == b"old";
            match (status.signal(), status.success()) {
                (Some(found), _) => assert_eq!((found, is_old), (number, true), "{signal}"),
                // It had come to its end.
                (None, true) => assert!(!is_old, "{signal}"),
                (None, false) => panic!("{signal}: {status}"),
            }
            ended += usize::from(!status.success());
            if ended == 3 {
                break;
            }
        }
        assert!(ended > 0, "{signal} never came in time");
    }
}

#[test]
fn a_signal_that_is_to_be_ignored_is_ignored() {
    let folder = stage();
    for (signal, _) in SIGNALS {
        fs::write(folder.path().join("out.ply"), "old").unwrap();
        let status = signalled(&folder, &format!("trap '' {signal};"), signal);
        assert!(status.success(), "{signal}: {status}");
        assert_ne!(fs::read(folder.path().join("out.ply")).unwrap(), b"old", "{signal}");
    }
}
