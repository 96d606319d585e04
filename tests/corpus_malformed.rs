//! Every malformed file of the corpus ends in a clean error where it has to, and never in a panic.
//!
//! A file with the verdict `reject` has to be refused; one with `either` may be refused or read. A refusal names the
//! file and the place in it, leaves no output behind, and is one message.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use meshmend_io::{Place, ReadErrorKind, ReadOptions, read};
use meshmend_tests::corpus::{Entry, corpus};
use meshmend_tests::each::assert_each;
use meshmend_tests::program::{self, BAD_INPUT, REFUSED};
use meshmend_tests::scratch::Scratch;

fn malformed(entries: &[Entry], is_read_here: bool) -> Vec<&Entry> {
    let of_kind = |entry: &&Entry| entry.verdict().is_some() && entry.is_read_here() == is_read_here;
    entries.iter().filter(of_kind).collect()
}

#[test]
fn the_reader_refuses_what_it_has_to_and_says_where() {
    let Some(entries) = corpus() else { return };
    let files = malformed(&entries, true);
    assert!(files.len() > 80, "only {} files", files.len());
    assert_each(&files, |entry| {
        let result = read(&entry.path, &ReadOptions::default());
        let wrong = match (&result, entry.verdict()) {
            (Ok(_), Some("either")) => None,
            (Ok(_), _) => Some("was read".to_owned()),
            (Err(error), _) => match (&error.kind, &error.place) {
                (ReadErrorKind::Malformed(reason), Place::File) => Some(format!("has no place: {reason}")),
                (ReadErrorKind::Malformed(_), _) => None,
                // A text may be deeper than the limits allow.
                (ReadErrorKind::LimitExceeded { .. }, place) if *place != Place::File => None,
                // What surely is something else, such as UTF-16, is refused as that.
                (ReadErrorKind::UnknownFormat { looks_like: Some(_) }, _) => None,
                (other, _) => Some(format!("is refused for a reason of another kind: {other}")),
            },
        };
        wrong
            .map(|wrong| format!("{} {wrong} ({})", entry.name, entry.facts["malformed"]["why"]))
            .into_iter()
            .collect()
    });
}

#[test]
fn the_program_ends_with_one_message_and_no_output() {
    let Some(entries) = corpus() else { return };
    assert_each(&malformed(&entries, true), |entry| {
        let may_be_read = entry.verdict() == Some("either");
        complaints(&entry.path, may_be_read)
    });
}

#[test]
fn files_in_formats_that_are_not_read_are_bad_input() {
    let scratch = Scratch::new();
    let files = [
        ("car.fbx", "Kaydara FBX Binary  \0"),
        ("car.dae", "<?xml version=\"1.0\"?><COLLADA/>"),
        ("car.step", "ISO-10303-21;"),
        ("car.usdz", "PK\u{3}\u{4} car.usdc"),
        ("car.obj", "<!DOCTYPE html><title>404</title>"),
        ("car", "no format at all"),
    ];
    let files = files.map(|(name, content)| PathBuf::from(scratch.file(name, content)));
    assert_each(&files, |path| complaints(path, false));
}

/// What is wrong with how the program takes a file that it has to refuse, or may.
fn complaints(path: &Path, may_be_read: bool) -> Vec<String> {
    let scratch = Scratch::new();
    let target = scratch.path().join("out.off");
    let arguments: [&OsStr; 4] = ["repair".as_ref(), path.as_ref(), "-o".as_ref(), target.as_ref()];
    let output = program::run(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    let status = output.status.code();
    let mut wrong = Vec::new();
    let mut complain = |what: String| wrong.push(format!("{}: {what}", path.display()));
    if may_be_read && status == Some(0) {
        if scratch.file_names() != ["out.off"] {
            complain(format!("was read, and wrote {:?}", scratch.file_names()));
        }
        return wrong;
    }
    // What is read may have no face that a repair could leave.
    if status != Some(BAD_INPUT) && !(may_be_read && status == Some(REFUSED)) {
        complain(format!("status {status:?}: {said}"));
    }
    if said.trim().lines().count() != 1 || !output.stdout.is_empty() {
        complain(format!("not one message: {said:?} {:?}", String::from_utf8_lossy(&output.stdout)));
    }
    let file_name = path.file_name().unwrap().to_string_lossy();
    if !said.contains(&*file_name) || said.contains("panicked") {
        complain(format!("the message does not name the file: {said}"));
    }
    if !scratch.file_names().is_empty() {
        complain(format!("left {:?} behind", scratch.file_names()));
    }
    wrong
}
