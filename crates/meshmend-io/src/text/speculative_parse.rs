//! Speculative parsing: the usual rows of a text are parsed on all threads before its sequential reader arrives.
//!
//! ```text
//! text     |v v v v v v # c v v|v v v g x f f f|f f -2 f f f f|          chunks, each to the end of a row
//! pieces   [v v v v v]     [v v|v v v]   [f f f|f f]   [f f f f]          parsed on any thread
//! reader                # c             g x         -2                    takes the pieces, and reads what lies between
//! ```
//!
//! A format defines its [`UsualRows`]: a small parser without any state that accepts only what almost all programs
//! write. Everything else, and every error, is left to the sequential reader, which could read the whole text alone
//! with the same result. The reader goes from piece to piece in the order of the text. It takes a piece only if it
//! stands at the first byte of the piece and the limits allow all of it; else it reads these bytes itself. So the
//! result does not depend on where chunks begin, on the number of threads, or on whether a piece begins in the middle
//! of something.
//!
//! The pieces of one wave of chunks are taken while the next wave is parsed, so memory is that of two waves. At most
//! the text itself is parsed in vain. A chunk with few usual rows is soon left to the reader.

use std::ops::Range;

use rayon::prelude::*;

use crate::ReadError;
use crate::text;

/// Rows of a text in the usual layout of a format. What a row says does not depend on what stands before it.
pub(crate) trait UsualRows: Send + Sync {
    /// An empty collection of the same kind of rows.
    fn none(&self) -> Self;

    /// Forgets all rows, but keeps their memory.
    fn clear(&mut self);

    /// Adds the row that begins at a byte, after blanks or empty lines, and returns where it ends: after a line end,
    /// or at the end of the text. Returns `None`, having added nothing, if the row is unusual.
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize>;

    /// Where the row after the one at this byte may begin.
    fn next_row(text: &[u8], at: usize) -> usize {
        text::after_line_end(text, text::line_end(text, at))
    }
}

/// Reads a text row by row, but can take rows that are parsed already.
pub(crate) trait SequentialReader<R>: Send {
    /// The byte that it reads next.
    fn at(&self) -> usize;

    /// Reads on by itself until it is done, or until the next row begins at or after this byte. If something is still
    /// missing at the end of the text, that is an error.
    fn read_to(&mut self, end: usize) -> Result<(), ReadError>;

    /// Takes the next rows and moves to their end. Stays where it is if it must read them itself.
    fn take(&mut self, rows: &R, end: usize);

    /// Whether it has read all that it needs. The text may go on.
    fn is_done(&self) -> bool;

    /// Says to whoever watches how far it is; an error if it is not to go on. It is called between two waves.
    fn look(&self) -> Result<(), ReadError>;
}

/// How far ahead a text is parsed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// The least size of a chunk in bytes.
    pub(crate) chunk: usize,
    /// How many chunks a wave has.
    pub(crate) chunks: usize,
}

impl Pace {
    /// The reader reads everything by itself.
    pub(crate) const NONE: Pace = Pace { chunk: 0, chunks: 0 };

    /// The pace for a text of so many bytes. Small ones start no thread.
    pub(crate) fn of(length: usize) -> Self {
        const CHUNK: usize = 1 << 17;
        const LARGE: usize = 1 << 20;
        const CHUNKS_A_THREAD: usize = 4;
        const MOST_CHUNKS: usize = 64;
        let threads = if length < LARGE { 1 } else { rayon::current_num_threads() };
        let chunks = if threads == 1 { 1 } else { (CHUNKS_A_THREAD * threads).min(MOST_CHUNKS) };
        Pace { chunk: CHUNK, chunks }
    }
}

/// Reads a text until the reader is done or the text ends, while usual rows are parsed ahead of it.
///
/// *Cost*: time is linear; memory holds the rows of two waves.
pub(crate) fn read_speculatively<R: UsualRows>(
    text: &[u8],
    pace: Pace,
    rows: &R,
    reader: &mut impl SequentialReader<R>,
) -> Result<(), ReadError> {
    if pace.chunks == 0 {
        return read_alone(text, reader);
    }
    reader.look()?;
    let (mut wave, mut next) = (Wave::default(), Wave::default());
    wave.parse(text, reader.at(), pace, rows);
    while wave.end < text.len() && !reader.is_done() {
        reader.look()?;
        if pace.chunks == 1 {
            wave.hand_over(reader)?;
            wave.parse(text, wave.end, pace, rows);
        } else {
            let parse_next = || next.parse(text, wave.end, pace, rows);
            let (handed_over, ()) = rayon::join(|| wave.hand_over(reader), parse_next);
            handed_over?;
            std::mem::swap(&mut wave, &mut next);
        }
    }
    wave.hand_over(reader)
}

/// Reads a text until the reader is done or the text ends, without anything parsed ahead of it.
pub(crate) fn read_alone<R>(text: &[u8], reader: &mut impl SequentialReader<R>) -> Result<(), ReadError> {
    /// How many bytes are read between two looks.
    const PIECE: usize = 1 << 18;
    while !reader.is_done() && text.len() - reader.at() > PIECE {
        reader.look()?;
        reader.read_to(reader.at() + PIECE)?;
    }
    reader.look()?;
    reader.read_to(text.len())
}

/// The chunks that are parsed at one time.
struct Wave<R> {
    end: usize,
    chunks: Vec<Chunk<R>>,
}

/// Some bytes of a text, and the usual rows in them.
struct Chunk<R> {
    text: Range<usize>,
    pieces: Vec<Piece<R>>,
}

/// Adjacent rows.
struct Piece<R> {
    text: Range<usize>,
    rows: R,
}

impl<R> Default for Wave<R> {
    fn default() -> Self {
        Wave { end: 0, chunks: Vec::new() }
    }
}

impl<R: UsualRows> Wave<R> {
    /// Parses the chunks from a byte on.
    fn parse(&mut self, text: &[u8], start: usize, pace: Pace, rows: &R) {
        self.chunks.resize_with(pace.chunks, || Chunk { text: 0..0, pieces: Vec::new() });
        self.end = start;
        for chunk in &mut self.chunks {
            let least = self.end.saturating_add(pace.chunk);
            let end = if least < text.len() { R::next_row(text, least) } else { text.len() };
            chunk.text = self.end..end;
            self.end = end;
        }
        match self.chunks.as_mut_slice() {
            [chunk] => chunk.parse(text, rows),
            chunks => chunks.par_iter_mut().with_max_len(1).for_each(|chunk| chunk.parse(text, rows)),
        }
    }

    /// Brings a reader to the end of the wave.
    fn hand_over(&self, reader: &mut impl SequentialReader<R>) -> Result<(), ReadError> {
        for piece in self.chunks.iter().flat_map(|chunk| &chunk.pieces) {
            reader.read_to(piece.text.start)?;
            if reader.at() == piece.text.start {
                reader.take(&piece.rows, piece.text.end);
            }
        }
        reader.read_to(self.end)
    }
}

impl<R: UsualRows> Chunk<R> {
    /// Collects the usual rows. It stops early if there are few: unusual rows cost more time here than in the reader,
    /// and pieces of one or two rows cost more than the rows themselves.
    fn parse(&mut self, text: &[u8], rows: &R) {
        const LEAST_PIECE: usize = 1 << 10;
        const SPARE_GAPS: usize = 16;
        let text = &text[..self.text.end];
        let (mut at, mut gaps) = (self.text.start, 0);
        let mut rows = self.take_memory().unwrap_or_else(|| rows.none());
        while at < text.len() && gaps * LEAST_PIECE <= at - self.text.start + SPARE_GAPS * LEAST_PIECE {
            let start = at;
            while let Some(end) = rows.add(text, at) {
                at = end;
            }
            if at > start {
                let next = rows.none();
                self.pieces.push(Piece { text: start..at, rows: std::mem::replace(&mut rows, next) });
            }
            if at < text.len() {
                at = R::next_row(text, at);
                gaps += 1;
            }
        }
    }

    /// Forgets all pieces, and returns the memory of the first.
    fn take_memory(&mut self) -> Option<R> {
        let first = self.pieces.drain(..).next();
        first.map(|mut piece| {
            piece.rows.clear();
            piece.rows
        })
    }
}

#[cfg(test)]
mod tests;
