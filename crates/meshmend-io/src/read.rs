//! Reading: find the format, check the size, hand the bytes to the reader of the format.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use crate::document::{Placing, TooMuchPlaced};
use crate::formats::drivers::driver;
use crate::formats::foreign;
use crate::input::folder::Folder;
use crate::input::notes::Notes;
use crate::input::source::{Parsed, Source};
use crate::input::streamed::{MeshSink, Rows, Streamed};
use crate::limits::STREAM_BYTES;
use crate::text::speculative_parse::Pace;
use crate::watched::WatchedRead;
use crate::{Document, Format, Limits, NoteKind, Place, ReadError, ReadErrorKind, ReadFile, ReadOptions};

/// Reads a mesh file. Its content decides on the format if it is unmistakable; else its name does.
///
/// The only other files that are opened are the material libraries that an OBJ file names within its own folder, to
/// see whether they and their images are there.
///
/// # Errors
/// If the system can't read the file, the format is unknown, the content is malformed, or a limit is exceeded.
///
/// *Cost*: time is linear in the size of the file. A text is held in memory while it is read; of binary values, one
/// block.
pub fn read(path: &Path, options: &ReadOptions) -> Result<ReadFile, ReadError> {
    whole(read_document(path, options)?, &path.display().to_string())
}

/// Reads a mesh file with all its parts (see [`read`]).
///
/// # Errors
/// As [`read`].
///
/// *Cost*: that of [`read`].
pub fn read_document(path: &Path, options: &ReadOptions) -> Result<Document, ReadError> {
    let (name, limits) = (path.display().to_string(), &options.limits);
    let failed = |kind| ReadError { file: name.clone(), place: Place::File, kind };
    let (file, announced) = open(path, limits).map_err(failed)?;
    let mut file = WatchedRead::new(file, &options.watch, announced);
    let mut bytes = Vec::with_capacity(HEAD.min(announced));
    file.by_ref().take(HEAD as u64).read_to_end(&mut bytes).map_err(|error| failed(error.into()))?;
    let folder = Folder::of(path);
    if bytes.len() == HEAD && announced > HEAD {
        let told = Told::of(options.format, path, &bytes, announced as u64).map_err(failed)?;
        let head = Source {
            folder: folder.as_ref(),
            shared_places: options.shared_places,
            ..Source::head(&bytes, announced, &name, &options.watch)
        };
        if let Some(parsed) = (driver(told.format).read_blocks)(&head, &mut file, &limits.within_a_mesh()) {
            return told.outcome(parsed);
        }
    }
    let bytes = take_in(bytes, file, announced, Most::of(announced, limits)).map_err(failed)?;
    let document = read_as(&bytes, Named { name: &name, path, folder: folder.as_ref() }, options)?;
    let mut document = (driver(document.format).look_beside)(document, path);
    document.shell = document.shell.in_folder(folder.map(Folder::into_path));
    Ok(document)
}

/// Reads a mesh from bytes. The name is used as in [`read`] to find the format, and in errors.
///
/// # Errors
/// As [`read`], except for those of the system.
pub fn read_bytes(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<ReadFile, ReadError> {
    whole(read_document_bytes(bytes, name, options)?, name)
}

/// Reads a document from bytes. The name is used as in [`read`] to find the format, and in errors. Files that it names
/// are not opened.
///
/// # Errors
/// As [`read_bytes`].
pub fn read_document_bytes(bytes: &[u8], name: &str, options: &ReadOptions) -> Result<Document, ReadError> {
    read_as(bytes, Named { name, path: Path::new(name), folder: None }, options)
}

/// Reads a mesh from a stream, such as standard input, to its end. The name is used as in [`read`] to find the
/// format, and in errors.
///
/// # Errors
/// As [`read`].
///
/// *Cost*: time and memory are linear in the bytes of the stream.
pub fn read_stream(from: impl Read, name: &str, options: &ReadOptions) -> Result<ReadFile, ReadError> {
    whole(read_document_stream(from, name, options)?, name)
}

/// Reads a document from a stream (see [`read_stream`] and [`read_document_bytes`]).
///
/// # Errors
/// As [`read`].
///
/// *Cost*: that of [`read_stream`].
pub fn read_document_stream(
    from: impl Read,
    name: &str,
    options: &ReadOptions,
) -> Result<Document, ReadError> {
    let failed = |kind| ReadError { file: name.to_owned(), place: Place::File, kind };
    let from = WatchedRead::new(from, &options.watch, 0);
    let bytes = take_in(Vec::new(), from, 0, Most::of(0, &options.limits)).map_err(failed)?;
    read_document_bytes(&bytes, name, options)
}

/// Hands the vertices and faces of a file to a sink, in the order in which they stand there. Nothing of them is kept, so the file may
/// be larger than memory: limits that are as wide as a mesh become as wide as numbers of 32 bits.
///
/// Binary PLY without triangle strips and binary STL can be read so.
///
/// # Errors
/// As [`read`]; [`NotInRows`](ReadErrorKind::NotInRows) for any other file, and `Cancelled` if the sink wants no more.
///
/// *Cost*: time is linear in the size of the file; memory is that of a block, and of the edges that are elements of their own.
pub fn stream(path: &Path, options: &ReadOptions, sink: &mut dyn MeshSink) -> Result<Streamed, ReadError> {
    let (name, limits) = (path.display().to_string(), &options.limits.within_a_stream());
    let failed = |kind| ReadError { file: name.clone(), place: Place::File, kind };
    let (mut file, length) = open(path, limits).map_err(failed)?;
    let mut bytes = Vec::with_capacity(HEAD.min(length));
    file.by_ref().take(HEAD as u64).read_to_end(&mut bytes).map_err(|error| failed(error.into()))?;
    let told = Told::of(options.format, path, &bytes, length as u64).map_err(failed)?;
    // What does not tell its size can't be read twice either.
    let head = Source::head(&bytes, length, &name, &options.watch);
    let rows = if length < bytes.len() {
        None
    } else {
        (driver(told.format).stream)(&head, &mut file, limits, sink)
    };
    let rows = rows.unwrap_or_else(|| Err(failed(ReadErrorKind::NotInRows)));
    let Rows { encoding, mut notes, loose_edges } = rows.map_err(|error| told.told_of(error))?;
    told.note(&mut notes);
    let (format, notes) = (told.format, notes.into_list());
    Ok(Streamed { format, variant: format.variant(encoding), notes, loose_edges })
}

/// How many bytes of a file are read before the reader of its format takes over.
const HEAD: usize = 1 << 16;

/// A document as one mesh.
fn whole(document: Document, name: &str) -> Result<ReadFile, ReadError> {
    let failed = |reason: TooMuchPlaced| ReadError {
        file: name.to_owned(),
        place: Place::File,
        kind: ReadErrorKind::Malformed(reason.to_string()),
    };
    document.into_mesh(Placing::Scene).map_err(failed)
}

/// What is known of bytes before they are read.
struct Named<'a> {
    /// What errors call them.
    name: &'a str,
    /// The path whose extension may tell the format.
    path: &'a Path,
    /// The folder in which the files that they name are looked for.
    folder: Option<&'a Folder>,
}

fn read_as(bytes: &[u8], named: Named<'_>, options: &ReadOptions) -> Result<Document, ReadError> {
    let (limits, Named { name, path, folder }) = (&options.limits, named);
    let pace = Pace::of(bytes.len());
    let (shared_places, watch) = (options.shared_places, &options.watch);
    let source = Source { bytes, length: bytes.len(), name, pace, folder, shared_places, watch };
    source.limited("bytes", bytes.len() as u64, limits.max_file_bytes)?;
    let told = Told::of(options.format, path, bytes, bytes.len() as u64);
    let told = told.map_err(|kind| ReadError { file: name.to_owned(), place: Place::File, kind })?;
    told.outcome((driver(told.format).read)(&source, &limits.within_a_mesh()))
}

fn document_of(parsed: Parsed, format: Format) -> Document {
    let Parsed { parts, notes, shell } = parsed;
    let variant = shell.encoding().map_or(format.name(), |encoding| format.variant(encoding));
    Document { parts, format, variant, notes: notes.into_list(), shell }
}

/// The format in which content is to be read.
struct Told {
    format: Format,
    /// The extension, if it stands for another format than that of the content.
    name_says: Option<String>,
}

impl Told {
    /// The format that the caller wants, or that of the content if it is unmistakable, or that of the name.
    fn of(wanted: Option<Format>, path: &Path, head: &[u8], length: u64) -> Result<Self, ReadErrorKind> {
        let plain = |format| Ok(Told { format, name_says: None });
        let by_name = Format::from_path(path);
        if let Some(format) = wanted {
            return plain(format);
        }
        if let Some(format) = by_name.filter(|format| format.is_surely(head, length)) {
            return plain(format);
        }
        if let Some(format) = Format::from_head(head, length) {
            let is_mesh = by_name.is_some() || path.extension().is_some_and(foreign::is_extension);
            let suffix = || path.extension().map(|suffix| suffix.to_string_lossy().into_owned());
            return Ok(Told { format, name_says: if is_mesh { suffix() } else { None } });
        }
        let looks_like = foreign::looks_like(head, length);
        match by_name {
            Some(format) if looks_like.is_none() || length == 0 => plain(format),
            // A package is a zip archive in whose head nothing else need show what it is.
            Some(Format::ThreeMf) if foreign::is_zip(head) => plain(Format::ThreeMf),
            _ => Err(ReadErrorKind::UnknownFormat { looks_like }),
        }
    }

    /// What a reader returns, with a remark if the name stands for another format.
    fn outcome(&self, parsed: Result<Parsed, ReadError>) -> Result<Document, ReadError> {
        match parsed {
            Ok(mut parsed) => {
                self.note(&mut parsed.notes);
                Ok(document_of(parsed, self.format))
            }
            Err(error) => Err(self.told_of(error)),
        }
    }

    /// What there is to say about a name that stands for another format.
    fn remark(&self) -> Option<String> {
        let suffix = self.name_says.as_ref()?;
        Some(format!("the name ends in `{suffix}`, but the content is {}", self.format))
    }

    fn note(&self, notes: &mut Notes) {
        if let Some(remark) = self.remark() {
            notes.add(NoteKind::WrongSuffix, &remark, || Place::File);
        }
    }

    /// The error of a reader with the remark, if the content is to blame.
    fn told_of(&self, error: ReadError) -> ReadError {
        match (error, self.remark()) {
            (ReadError { file, place, kind: ReadErrorKind::Malformed(reason) }, Some(remark)) => {
                ReadError { file, place, kind: ReadErrorKind::Malformed(format!("{reason} ({remark})")) }
            }
            (error, _) => error,
        }
    }
}

/// An open file, and the size that the system gives: 0 if the size is unknown.
fn open(path: &Path, limits: &Limits) -> Result<(File, usize), ReadErrorKind> {
    let file = File::open(path).map_err(ReadErrorKind::Io)?;
    let status = file.metadata().map_err(ReadErrorKind::Io)?;
    if status.is_dir() {
        return Err(ReadErrorKind::Io(io::Error::from(io::ErrorKind::IsADirectory)));
    }
    let (found, limit) = (status.len(), limits.max_file_bytes);
    if found > limit {
        return Err(ReadErrorKind::LimitExceeded { what: "bytes", found, limit });
    }
    Ok((file, usize::try_from(found).unwrap_or(usize::MAX)))
}

/// How many bytes a source may have, and what errors call them.
#[derive(Clone, Copy)]
struct Most {
    what: &'static str,
    limit: u64,
}

impl Most {
    /// The limit for a source whose size is announced. A size of 0 is that of a pipe or a device, which may be
    /// endless.
    fn of(announced: usize, limits: &Limits) -> Self {
        match announced {
            0 => Most { what: STREAM_BYTES, limit: limits.max_stream_bytes.min(limits.max_file_bytes) },
            _ => Most { what: "bytes", limit: limits.max_file_bytes },
        }
    }
}

/// Reads a source, of which some bytes have been read, to its end. Its announced size only makes room.
fn take_in(
    mut bytes: Vec<u8>,
    from: impl Read,
    announced: usize,
    Most { what, limit }: Most,
) -> Result<Vec<u8>, ReadErrorKind> {
    let too_large = |_| ReadErrorKind::Io(io::Error::from(io::ErrorKind::OutOfMemory));
    bytes.try_reserve_exact(announced.saturating_sub(bytes.len()).saturating_add(1)).map_err(too_large)?;
    let room = limit.saturating_sub(bytes.len() as u64).saturating_add(1);
    from.take(room).read_to_end(&mut bytes)?;
    let found = bytes.len() as u64;
    if found > limit { Err(ReadErrorKind::LimitExceeded { what, found, limit }) } else { Ok(bytes) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Gives a few bytes at a time; one call fails.
    struct Failing<'a> {
        rest: &'a [u8],
        calls: usize,
        failing: usize,
        error: io::ErrorKind,
    }

    impl Read for Failing<'_> {
        fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
            self.calls += 1;
            if self.calls == self.failing {
                return Err(self.error.into());
            }
            let most = into.len().min(3);
            self.rest.read(&mut into[..most])
        }
    }

    /// A limit on bytes.
    fn most(limit: u64) -> Most {
        Most { what: "bytes", limit }
    }

    /// A source without an end is read up to a limit of its own, and one that tells its size is not.
    #[test]
    fn what_does_not_tell_its_size_has_a_limit_of_its_own() {
        let limits = Limits { max_stream_bytes: 1000, ..Limits::default() };
        match take_in(Vec::new(), io::repeat(0), 0, Most::of(0, &limits)) {
            Err(error @ ReadErrorKind::LimitExceeded { found: 1001, limit: 1000, .. }) => {
                assert!(error.to_string().ends_with("(max_stream_bytes)"), "{error}");
            }
            other => panic!("{other:?}"),
        }
        assert_eq!(take_in(Vec::new(), &[7; 2000][..], 2000, Most::of(2000, &limits)).unwrap(), [7; 2000]);
        let narrow = Limits { max_file_bytes: 10, ..limits };
        assert!(take_in(Vec::new(), io::repeat(0), 0, Most::of(0, &narrow)).is_err());
    }

    #[test]
    fn whichever_read_fails_the_error_comes_back_and_interruptions_are_nothing() {
        let content = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        // One more call finds the end.
        for failing in 1..=content.len().div_ceil(3) + 1 {
            for announced in [0, content.len()] {
                let source = |error| Failing { rest: content, calls: 0, failing, error };
                match take_in(Vec::new(), source(io::ErrorKind::Other), announced, most(1000)) {
                    Err(ReadErrorKind::Io(error)) => assert_eq!(error.kind(), io::ErrorKind::Other),
                    other => panic!("call {failing}: {other:?}"),
                }
                let interrupted = source(io::ErrorKind::Interrupted);
                assert_eq!(take_in(Vec::new(), interrupted, announced, most(1000)).unwrap(), content);
            }
        }
    }

    #[test]
    fn a_limit_is_the_most_that_is_taken_whatever_is_announced() {
        let content: &[u8] = b"12345";
        for (announced, head) in (0..=6).flat_map(|announced| [(announced, 0), (announced, 3)]) {
            let taken = |limit| take_in(content[..head].to_vec(), &content[head..], announced, most(limit));
            assert_eq!(taken(5).unwrap(), content);
            match taken(4) {
                Err(ReadErrorKind::LimitExceeded { found: 5, limit: 4, .. }) => {}
                other => panic!("{announced} announced: {other:?}"),
            }
        }
    }

    #[test]
    fn what_is_announced_beyond_all_memory_is_an_error() {
        let taken = take_in(Vec::new(), io::empty(), usize::MAX, most(u64::MAX));
        assert!(matches!(taken, Err(ReadErrorKind::Io(error)) if error.kind() == io::ErrorKind::OutOfMemory));
    }
}
