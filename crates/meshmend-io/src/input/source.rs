//! What a format's reader takes and returns.

use std::io;

use meshmend_core::{Cancelled, PolygonMesh, Watch};

use crate::document::{Part, PartSource, PartStatus};
use crate::input::folder::Folder;
use crate::input::notes::Notes;
use crate::text::speculative_parse::Pace;
use crate::watched::READ;
use crate::{Place, ReadError, ReadErrorKind, Shell};

/// The bytes of a file, and its name for errors.
pub(crate) struct Source<'a> {
    /// All bytes, or those at the start if the reader takes the others block by block.
    pub(crate) bytes: &'a [u8],
    /// How many bytes the file has.
    pub(crate) length: usize,
    pub(crate) name: &'a str,
    /// How far ahead of its reader a text is parsed.
    pub(crate) pace: Pace,
    /// The folder of the file, if it was read from one.
    pub(crate) folder: Option<&'a Folder>,
    /// Whether it is told which vertices share a place, where that is cheap.
    pub(crate) shared_places: bool,
    /// Who watches the reading.
    pub(crate) watch: &'a Watch,
}

impl<'a> Source<'a> {
    /// A file of which only the start is in memory.
    pub(crate) fn head(bytes: &'a [u8], length: usize, name: &'a str, watch: &'a Watch) -> Self {
        Source { bytes, length, name, pace: Pace::NONE, folder: None, shared_places: false, watch }
    }
}

impl Source<'_> {
    pub(crate) fn malformed(&self, place: Place, reason: impl Into<String>) -> ReadError {
        ReadError { file: self.name.to_owned(), place, kind: ReadErrorKind::Malformed(reason.into()) }
    }

    /// An error if `found` is more than the limit.
    #[inline]
    pub(crate) fn limited(&self, what: &'static str, found: u64, limit: u64) -> Result<(), ReadError> {
        if found <= limit { Ok(()) } else { Err(self.exceeded(what, found, limit)) }
    }

    #[cold]
    fn exceeded(&self, what: &'static str, found: u64, limit: u64) -> ReadError {
        let kind = ReadErrorKind::LimitExceeded { what, found, limit };
        ReadError { file: self.name.to_owned(), place: Place::File, kind }
    }

    /// The error of a system that can't give bytes.
    #[cold]
    pub(crate) fn failed(&self, error: io::Error) -> ReadError {
        ReadError { file: self.name.to_owned(), place: Place::File, kind: error.into() }
    }

    /// Says that all before a byte has been read.
    ///
    /// # Errors
    /// If whoever watches wants no more.
    pub(crate) fn look(&self, at: usize) -> Result<(), ReadError> {
        self.watch.look(READ, at, self.length).map_err(|stopped| self.cancelled(stopped))
    }

    /// The error of reading that somebody stopped.
    #[cold]
    pub(crate) fn cancelled(&self, stopped: Cancelled) -> ReadError {
        ReadError { file: self.name.to_owned(), place: Place::File, kind: ReadErrorKind::Cancelled(stopped) }
    }

    /// The line of a byte.
    pub(crate) fn line(&self, at: usize) -> Place {
        Place::Line(crate::text::line_number(self.bytes, at))
    }
}

/// What a format's reader found.
pub(crate) struct Parsed {
    pub(crate) parts: Vec<Part>,
    pub(crate) notes: Notes,
    pub(crate) shell: Shell,
}

impl Parsed {
    /// What the reader of a format of one mesh found.
    pub(crate) fn whole(mesh: PolygonMesh, notes: Notes, shell: Shell) -> Self {
        let (source, status) = (PartSource::Whole, PartStatus::Editable);
        Parsed { parts: vec![Part { name: Vec::new(), source, mesh, status }], notes, shell }
    }
}
