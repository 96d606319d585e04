//! What is wrong with a package, and in which of its entries.

use std::fmt;

use meshmend_core::{Cancelled, printable};

use crate::input::source::Source;
use crate::{Place, ReadError, ReadErrorKind};

/// Why a package can't be read.
#[derive(Debug)]
pub(in crate::formats::threemf) struct Fault {
    place: Place,
    kind: ReadErrorKind,
}

impl Fault {
    /// Something is wrong with the archive at one of its bytes.
    pub(in crate::formats::threemf) fn at_byte(byte: u64, reason: impl Into<String>) -> Self {
        Fault { place: Place::Byte(byte), kind: ReadErrorKind::Malformed(reason.into()) }
    }

    /// Something is wrong with one entry.
    pub(in crate::formats::threemf) fn of_entry(name: &str, reason: impl Into<String>) -> Self {
        Fault { place: place_of(name), kind: ReadErrorKind::Malformed(reason.into()) }
    }

    /// Something is wrong with an object of a model.
    pub(in crate::formats::threemf) fn of_object(entry: &str, id: u32, reason: impl Into<String>) -> Self {
        let place = Place::Entry(printable(&format!("{entry}#{id}")));
        Fault { place, kind: ReadErrorKind::Malformed(reason.into()) }
    }

    /// Whoever watches wants no more.
    pub(in crate::formats::threemf) fn stopped(stopped: Cancelled) -> Self {
        Fault { place: Place::File, kind: ReadErrorKind::Cancelled(stopped) }
    }

    /// There is more of something than the limits allow.
    pub(in crate::formats::threemf) fn limit(
        entry: &str,
        what: &'static str,
        found: u64,
        limit: u64,
    ) -> Self {
        let place = place_of(entry);
        Fault { place, kind: ReadErrorKind::LimitExceeded { what, found, limit } }
    }

    /// The error of a file.
    pub(in crate::formats::threemf) fn in_file(self, source: &Source<'_>) -> ReadError {
        ReadError { file: source.name.to_owned(), place: self.place, kind: self.kind }
    }
}

/// The place of an entry: that of the file if the entry has no name.
fn place_of(entry: &str) -> Place {
    if entry.is_empty() { Place::File } else { Place::Entry(printable(entry)) }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.place, self.kind)
    }
}
