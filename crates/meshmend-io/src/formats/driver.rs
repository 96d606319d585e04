//! What reads and writes one format.

use std::io;
use std::path::Path;

use crate::input::source::{Parsed, Source};
use crate::input::streamed::{MeshSink, Rows};
use crate::{Document, Limits, Loss, Prepared, ReadError, WriteErrorKind};

/// What a format's reader found, or why it gave up.
pub(crate) type ReadResult = Result<Parsed, ReadError>;

/// Hands the rows of a file, of which only the start is in memory, to a sink.
type StreamRows =
    fn(&Source<'_>, &mut dyn io::Read, &Limits, &mut dyn MeshSink) -> Option<Result<Rows, ReadError>>;

/// The functions of a format.
pub(crate) struct Driver {
    /// Reads a file of which all bytes are in memory.
    pub(crate) read: fn(&Source<'_>, &Limits) -> ReadResult,
    /// Reads a file of which only the start is in memory; the rest is read as it is needed. Returns `None`, having
    /// read nothing, if the format needs the whole file.
    pub(crate) read_blocks: fn(&Source<'_>, &mut dyn io::Read, &Limits) -> Option<ReadResult>,
    /// Hands the rows of a file to a sink, and keeps none. Returns `None`, having read nothing, if that can't be done.
    pub(crate) stream: StreamRows,
    /// Looks for the other files that a file at this path names.
    pub(crate) look_beside: fn(Document, &Path) -> Document,
    /// Turns a mesh into one that the format can hold, and names what that loses. A mesh that fits stays as it is.
    pub(crate) prepare: fn(&mut Prepared) -> Result<(), WriteErrorKind>,
    /// Writes a mesh.
    pub(crate) encode: fn(&Prepared, &mut dyn io::Write) -> Result<(), WriteErrorKind>,
    /// Names what else the file won't carry.
    pub(crate) losses: fn(&Prepared) -> Vec<Loss>,
}

impl Driver {
    /// For formats that need the whole file in memory.
    pub(crate) fn needs_whole_file(_: &Source<'_>, _: &mut dyn io::Read, _: &Limits) -> Option<ReadResult> {
        None
    }

    /// For formats whose rows are not handed over one by one.
    pub(crate) fn streams_nothing(
        _: &Source<'_>,
        _: &mut dyn io::Read,
        _: &Limits,
        _: &mut dyn MeshSink,
    ) -> Option<Result<Rows, ReadError>> {
        None
    }

    /// For formats whose files name no others.
    pub(crate) fn names_no_files(document: Document, _: &Path) -> Document {
        document
    }
}
