//! What a format's reader gets and gives.

use std::io;

use meshmend_core::PolygonMesh;

use crate::input::notes::Notes;
use crate::text::speculative_parse::Pace;
use crate::{Place, ReadError, ReadErrorKind, Shell};

/// The bytes of a file with its name for errors.
pub(crate) struct Source<'a> {
    /// All of them, or those at the start where a reader takes the others block by block.
    pub(crate) bytes: &'a [u8],
    /// How many there are in all.
    pub(crate) length: usize,
    pub(crate) name: &'a str,
    /// How far ahead of a reader text is parsed.
    pub(crate) pace: Pace,
}

impl Source<'_> {
    pub(crate) fn malformed(&self, place: Place, reason: impl Into<String>) -> ReadError {
        ReadError { file: self.name.to_owned(), place, kind: ReadErrorKind::Malformed(reason.into()) }
    }

    /// An error unless `found` is within the limit.
    #[inline]
    pub(crate) fn limited(&self, what: &'static str, found: u64, limit: u64) -> Result<(), ReadError> {
        if found <= limit { Ok(()) } else { Err(self.exceeded(what, found, limit)) }
    }

    #[cold]
    fn exceeded(&self, what: &'static str, found: u64, limit: u64) -> ReadError {
        let kind = ReadErrorKind::LimitExceeded { what, found, limit };
        ReadError { file: self.name.to_owned(), place: Place::File, kind }
    }

    /// Why bytes that must be there can't be given.
    #[cold]
    pub(crate) fn failed(&self, error: io::Error) -> ReadError {
        ReadError { file: self.name.to_owned(), place: Place::File, kind: ReadErrorKind::Io(error) }
    }

    /// The line of a byte.
    pub(crate) fn line(&self, at: usize) -> Place {
        Place::Line(crate::text::line_number(self.bytes, at))
    }
}

/// What a format's reader found.
pub(crate) struct Parsed {
    pub(crate) mesh: PolygonMesh,
    pub(crate) notes: Notes,
    pub(crate) shell: Shell,
}
