//! Reading and writing that somebody watches: they are told how many bytes have passed, and may stop it.

use std::io::{self, Read, Write};

use meshmend_core::{Cancelled, Watch};

/// What reading is called to whoever watches.
pub(crate) const READ: &str = "read";
/// What writing is called to whoever watches.
const WRITE: &str = "write";

/// A source, at whose reads there is a look. To stop it is an error of the system that [`cancelled_by`] tells from others.
pub(crate) struct WatchedRead<'a, R> {
    from: R,
    watch: &'a Watch,
    done: usize,
    total: usize,
}

impl<'a, R> WatchedRead<'a, R> {
    /// A source of so many bytes; 0 if that is not known.
    pub(crate) fn new(from: R, watch: &'a Watch, total: usize) -> Self {
        WatchedRead { from, watch, done: 0, total }
    }
}

impl<R: Read> Read for WatchedRead<'_, R> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        /// What is read between two looks, however much room there is.
        const PIECE: usize = 1 << 22;
        self.watch.look(READ, self.done, self.total).map_err(io::Error::other)?;
        let most = into.len().min(PIECE);
        let found = self.from.read(&mut into[..most])?;
        self.done += found;
        Ok(found)
    }
}

/// A sink, at whose writes there is a look.
pub(crate) struct WatchedWrite<'a> {
    out: &'a mut dyn Write,
    watch: &'a Watch,
    done: usize,
}

impl<'a> WatchedWrite<'a> {
    pub(crate) fn new(out: &'a mut dyn Write, watch: &'a Watch) -> Self {
        WatchedWrite { out, watch, done: 0 }
    }
}

impl Write for WatchedWrite<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        /// The largest piece that is written between two looks.
        const PIECE: usize = 1 << 22;
        self.watch.look(WRITE, self.done, 0).map_err(io::Error::other)?;
        let written = self.out.write(&bytes[..bytes.len().min(PIECE)])?;
        self.done += written;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Whether an error of the system is that of a watch which stopped the work.
pub(crate) fn cancelled_by(error: &io::Error) -> Option<Cancelled> {
    error.get_ref().and_then(|cause| cause.downcast_ref::<Cancelled>()).copied()
}
