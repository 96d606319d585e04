//! Files that are read row by row, by somebody who may fail.

use std::path::Path;

use meshmend_core::{Cancelled, VertexId};
use meshmend_io::{Announced, MeshSink, ReadOptions, Streamed, stream};

use crate::error::ExternalError;

/// Takes the rows of a file.
pub(crate) trait Rows: Send {
    fn take_announced(&mut self, _: &Announced) -> Result<(), ExternalError> {
        Ok(())
    }

    fn take_vertices(&mut self, _: &[[f64; 3]]) -> Result<(), ExternalError> {
        Ok(())
    }

    fn take_face(&mut self, _: &[VertexId]) -> Result<(), ExternalError> {
        Ok(())
    }

    /// Whether all is known after the vertices that came, so that the rest of the file need not be read.
    fn has_all(&self) -> bool {
        false
    }
}

/// Hands the rows of a file to somebody. Returns what there is to say about the file, if it was read to its end.
pub(crate) fn read_rows(
    path: &Path,
    read: &ReadOptions,
    rows: &mut impl Rows,
) -> Result<Option<Streamed>, ExternalError> {
    let mut sink = Sink { rows, stopped: None, has_all: false };
    let streamed = stream(path, read, &mut sink);
    match sink.stopped {
        Some(error) => Err(error),
        None if sink.has_all => Ok(None),
        None => Ok(Some(streamed?)),
    }
}

/// Keeps the error for which it wants no more.
struct Sink<'r, R> {
    rows: &'r mut R,
    stopped: Option<ExternalError>,
    has_all: bool,
}

impl<R> Sink<'_, R> {
    #[cold]
    fn stop(&mut self, error: ExternalError) -> Cancelled {
        self.stopped = Some(error);
        Cancelled
    }
}

impl<R: Rows> MeshSink for Sink<'_, R> {
    fn begin(&mut self, announced: &Announced) -> Result<(), Cancelled> {
        self.rows.take_announced(announced).map_err(|error| self.stop(error))
    }

    fn vertices(&mut self, positions: &[[f64; 3]]) -> Result<(), Cancelled> {
        self.rows.take_vertices(positions).map_err(|error| self.stop(error))?;
        self.has_all = self.rows.has_all();
        if self.has_all { Err(Cancelled) } else { Ok(()) }
    }

    #[inline]
    fn face(&mut self, vertices: &[VertexId]) -> Result<(), Cancelled> {
        self.rows.take_face(vertices).map_err(|error| self.stop(error))
    }
}
