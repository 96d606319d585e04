//! The command line: any arguments end in one of the documented statuses, with words that fit it and whole files.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::ArgMatches;
use meshmend_cli::{Console, Status, description};
use meshmend_io::Format;

use crate::room::{NAMES, Room};

/// The options and places of the command line that name a file to write.
const WRITTEN: [&str; 6] = ["output", "report", "plot", "matrix_market", "svg", "html"];
/// The largest numbers that some options are run with: larger ones cost time or memory, and show nothing.
const LARGEST: [(&str, u64); 8] = [
    ("threads", 4),
    ("resolution", 6),
    ("count", 6),
    ("genus", 6),
    ("cross_caps", 6),
    ("holes", 6),
    ("refine", 1),
    ("size", 200),
];

/// Arguments, one a line, run in a folder with a few small files.
pub fn arguments(data: &[u8]) {
    let split = |data: &[u8]| data.split(|byte| matches!(byte, b'\n' | 0)).map(<[u8]>::to_vec).collect();
    let words: Vec<Vec<u8>> = if data.is_empty() { Vec::new() } else { split(data) };
    let room = Room::new();
    let Some(words) = contained(words, &room) else { return };
    let request = Request::of(&words);
    if request.as_ref().is_some_and(Request::asks_much) {
        return;
    }
    let (mut out, mut errors) = (Vec::new(), Vec::new());
    let status = meshmend_cli::run(line(&words), &mut Console::of(&mut out, &mut errors));
    let [out, errors] = [out, errors].map(|bytes| String::from_utf8(bytes).expect("text is UTF-8"));
    assert_told(status, &errors);
    assert_files_whole(status, request.as_ref(), &room);
    match request {
        Some(request) if request.has("json") => assert_json_lines(&out),
        Some(_) => {}
        None => assert!(status == Status::Usage || status == Status::Done && !out.is_empty()),
    }
}

/// Done is done without a word of error; anything else says why.
fn assert_told(status: Status, errors: &str) {
    let is_complete = matches!(status, Status::Done | Status::Failing);
    assert_eq!(is_complete, errors.trim().is_empty(), "{status:?}, but errors are {errors:?}");
    assert!(is_complete || errors.ends_with('\n'), "{errors:?}");
}

/// What was named as an output is whole, or as it was; what was not named is as it was; nothing else is there.
fn assert_files_whole(status: Status, request: Option<&Request>, room: &Room) {
    room.assert_tidy();
    for (at, name) in NAMES.iter().enumerate() {
        let path = room.path(at);
        let names_it = |id: &&str| request.is_some_and(|request| request.paths(id).contains(&path));
        let role = WRITTEN.into_iter().find(|id| names_it(&id));
        let is_due = |id| status == Status::Done && !(id == "output" && request.is_some_and(Request::is_dry));
        assert!(path.exists() || !role.is_some_and(is_due), "{name} was not written");
        if room.is_unchanged(at) {
            continue;
        }
        let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
        match role {
            Some("report") => assert_json_lines(&String::from_utf8_lossy(&bytes)),
            Some(_) => assert_whole(name, &bytes, request.and_then(Request::format)),
            None => panic!("{name} was changed, and no output has that name"),
        }
    }
}

/// A picture or a page begins and ends as it must, a matrix has its entries, a mesh can be read.
fn assert_whole(name: &str, bytes: &[u8], format: Option<Format>) {
    let end = bytes.trim_ascii_end();
    if bytes.starts_with(b"\x89PNG") {
        return assert!(bytes.ends_with(b"IEND\xae\x42\x60\x82"), "{name} is cut off");
    }
    if bytes.starts_with(b"<!doctype html>") {
        return assert!(end.ends_with(b"</html>"), "{name} is cut off");
    }
    if bytes.starts_with(b"<") {
        return assert!(end.ends_with(b"</svg>"), "{name} is cut off");
    }
    if bytes.starts_with(b"%%MatrixMarket") {
        return assert_matrix_whole(name, &String::from_utf8_lossy(bytes));
    }
    let options = meshmend_io::ReadOptions::default().with_format(format);
    if let Err(error) = meshmend_io::read_bytes(bytes, name, &options) {
        panic!("{error} in\n{}", String::from_utf8_lossy(bytes));
    }
}

/// A file of the Matrix Market has a header of three lines, and as many entries as that says.
#[track_caller]
pub(crate) fn assert_matrix_whole(name: &str, text: &str) {
    let (lines, sizes) = (text.lines().count(), text.lines().nth(2).unwrap_or_default());
    assert!(
        sizes.ends_with(&format!(" {}", lines.saturating_sub(3))),
        "{name} is cut off: {sizes}, {lines} lines"
    );
}

#[track_caller]
fn assert_json_lines(text: &str) {
    assert!(text.is_empty() || text.ends_with('\n'), "{text:?}");
    for line in text.lines() {
        let value: Result<serde_json::Value, _> = serde_json::from_str(line);
        assert!(value.is_ok_and(|value| value.is_object()), "{line:?} is no JSON object");
    }
}

/// What the parser makes of the arguments of one command.
struct Request(ArgMatches);

impl Request {
    /// Nothing if they are no command line.
    fn of(words: &[Vec<u8>]) -> Option<Self> {
        let mut matches = description().try_get_matches_from(line(words)).ok()?;
        while let Some((_, inner)) = matches.remove_subcommand() {
            matches = inner;
        }
        Some(Request(matches))
    }

    fn has(&self, flag: &str) -> bool {
        self.0.try_get_one(flag).ok().flatten().copied().unwrap_or(false)
    }

    fn is_dry(&self) -> bool {
        self.has("dry_run")
    }

    fn format(&self) -> Option<Format> {
        self.0.try_get_one("format").ok().flatten().copied()
    }

    fn asks_much(&self) -> bool {
        LARGEST.iter().any(|&(id, largest)| self.numbers(id).iter().any(|&number| number > largest))
    }

    /// The whole numbers in what one argument says.
    fn numbers(&self, id: &str) -> Vec<u64> {
        let values = self.0.try_get_raw(id).ok().flatten().into_iter().flatten();
        let texts: Vec<String> = values.map(|value| value.to_string_lossy().into_owned()).collect();
        let words = texts.iter().flat_map(|text| text.split(|c: char| !c.is_ascii_digit()));
        words.filter(|word| !word.is_empty()).map(|word| word.parse().unwrap_or(u64::MAX)).collect()
    }

    /// The files that one argument names.
    fn paths(&self, id: &str) -> Vec<PathBuf> {
        let values = self.0.try_get_many::<PathBuf>(id).ok().flatten();
        values.into_iter().flatten().cloned().collect()
    }

    fn all_paths(&self) -> Vec<PathBuf> {
        self.0.ids().flat_map(|id| self.paths(id.as_str())).collect()
    }
}

/// The arguments with all that the parser takes for a file led to a file of the room; nothing if that can't be done.
fn contained(mut words: Vec<Vec<u8>>, room: &Room) -> Option<Vec<Vec<u8>>> {
    let outside = |words: &[Vec<u8>]| -> Vec<PathBuf> {
        let paths = Request::of(words).map_or(Vec::new(), |request| request.all_paths());
        paths.into_iter().filter(|path| !room.has(path)).collect()
    };
    for path in outside(&words) {
        let name = path.as_os_str().as_encoded_bytes();
        let known = NAMES.iter().position(|known| known.as_bytes() == name);
        // A name that is not known stands for some file, always the same.
        let at =
            known.unwrap_or_else(|| name.iter().map(|&byte| usize::from(byte)).sum::<usize>() % NAMES.len());
        for word in words.iter_mut().filter(|word| word.ends_with(name)) {
            word.truncate(word.len() - name.len());
            word.extend(room.path(at).as_os_str().as_encoded_bytes());
        }
    }
    outside(&words).is_empty().then_some(words)
}

/// The arguments as a program gets them.
fn line(words: &[Vec<u8>]) -> Vec<OsString> {
    std::iter::once("meshmend".into()).chain(words.iter().map(|word| argument(word))).collect()
}

#[cfg(unix)]
fn argument(word: &[u8]) -> OsString {
    std::os::unix::ffi::OsStringExt::from_vec(word.to_vec())
}

#[cfg(not(unix))]
fn argument(word: &[u8]) -> OsString {
    String::from_utf8_lossy(word).into_owned().into()
}
