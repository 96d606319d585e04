//! Why a file can't be read or written, and where.

use std::{fmt, io};

use serde::Serialize;
use thiserror::Error;

use crate::{Encoding, Format};

/// A place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of a text, counted from 1.
    Line(u64),
    /// A byte, counted from 0.
    Byte(u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::File => f.write_str("whole file"),
            Place::Line(line) => write!(f, "line {line}"),
            Place::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// Why a file can't be read. Shown as `file: place: reason`.
#[derive(Debug, Error)]
#[error("{file}: {}{kind}", shown(.place))]
pub struct ReadError {
    /// The file, as it was named.
    pub file: String,
    /// Where in it.
    pub place: Place,
    /// What is wrong.
    pub kind: ReadErrorKind,
}

/// What is wrong with a file, sorted by whose fault it is.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ReadErrorKind {
    /// Neither the name nor the content tells a format that is read here.
    #[error("the format is not known; known are {}", known_formats())]
    UnknownFormat,
    /// The system can't give the file's bytes.
    #[error("{0}")]
    Io(io::Error),
    /// The content breaks the rules of its format.
    #[error("{0}")]
    Malformed(String),
    /// The file holds more than the limits allow.
    #[error("{found} {what} are more than the limit of {limit}")]
    LimitExceeded {
        /// What there is too much of.
        what: &'static str,
        /// How much of it there is, or at least is.
        found: u64,
        /// How much is allowed.
        limit: u64,
    },
}

/// Why a file can't be written. Shown as `file: reason`.
#[derive(Debug, Error)]
#[error("{file}: {kind}")]
pub struct WriteError {
    /// The file, as it was named.
    pub file: String,
    /// What is wrong.
    pub kind: WriteErrorKind,
}

/// What is wrong with a wish to write.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum WriteErrorKind {
    /// The name does not tell a format that is written here.
    #[error("the format is not known; known are {}", known_formats())]
    UnknownFormat,
    /// The format has no such encoding.
    #[error("{format} has no encoding `{encoding}`")]
    NoSuchEncoding {
        /// The format.
        format: Format,
        /// The encoding that was asked for.
        encoding: Encoding,
    },
    /// The format's counts can't say how many there are.
    #[error("{found} {what} are more than {format} can hold")]
    TooMany {
        /// The format.
        format: Format,
        /// What there is too much of.
        what: &'static str,
        /// How much of it there is.
        found: u64,
    },
    /// The system can't take the bytes.
    #[error("{0}")]
    Io(#[from] io::Error),
}

fn shown(place: &Place) -> String {
    match place {
        Place::File => String::new(),
        place => format!("{place}: "),
    }
}

fn known_formats() -> String {
    let names: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
    names.join(", ")
}
