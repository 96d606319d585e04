//! Reading ahead: what is plain in a text is parsed before its reader comes to it, on as many threads as there are.
//!
//! ```text
//! text     |v v v v v v # c v v|v v v g x f f f|f f -2 f f f f|          chunks, each to the end of a row
//! pieces   [v v v v v]     [v v|v v v]   [f f f|f f]   [f f f f]          parsed on any thread
//! reader                # c             g x         -2                    reads what is between, and takes the pieces
//! ```
//!
//! A format says what is plain in it as [`UsualRows`]: a small parser that knows nothing of what came before and takes in
//! only what everybody writes. Everything else, and every error, is the reader's, which would read the whole text
//! alike without any of this. The reader goes from piece to piece in the order of the text and takes one only if it
//! stands at its first byte and may have all of it; else it reads the same bytes itself. So it does not matter where
//! chunks begin, how many threads there are, or whether a piece is right to begin where it does.
//!
//! The pieces of one wave of chunks are taken while the next wave is parsed: memory is that of two waves. What is
//! parsed in vain is at most the text itself, and a chunk that is hardly plain is soon left to the reader.

use std::ops::Range;

use rayon::prelude::*;

use crate::ReadError;
use crate::text;

/// Rows of a text in the usual layout of a format. What a row says does not depend on what stands before it.
pub(crate) trait UsualRows: Send + Sync {
    /// No rows, but of the same kind.
    fn none(&self) -> Self;

    /// Forgets all rows, and keeps the memory for others.
    fn clear(&mut self);

    /// Adds the row that begins at a byte, after blanks or empty lines, and says where it ends: after a line end, or
    /// with the text. Adds nothing when it is not plain.
    fn add(&mut self, text: &[u8], at: usize) -> Option<usize>;

    /// Where the row after the one at this byte begins, or may begin.
    fn next_row(text: &[u8], at: usize) -> usize {
        text::after_line_end(text, text::line_end(text, at))
    }
}

/// Reads a text by itself, and may be given rows of it.
pub(crate) trait SequentialReader<R>: Send {
    /// The byte that it comes to next.
    fn at(&self) -> usize;

    /// Reads on by itself until it is done, or what comes next does not begin before this byte. At the end of the text
    /// something that is still missing is an error.
    fn read_to(&mut self, end: usize) -> Result<(), ReadError>;

    /// Takes the rows that come next and goes to their end; stays where it is if it must read them itself.
    fn take(&mut self, rows: &R, end: usize);

    /// Whether it has all that it came for, though the text may go on.
    fn is_done(&self) -> bool;
}

/// How far ahead a text is parsed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// The bytes of a chunk, at least.
    pub(crate) chunk: usize,
    /// The chunks of a wave.
    pub(crate) chunks: usize,
}

impl Pace {
    /// The reader reads all by itself.
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

/// Lets a reader read on until it is done or the text ends, parsing plain rows ahead of it.
///
/// *Cost*: linear; memory for the rows of two waves.
pub(crate) fn read_speculatively<R: UsualRows>(
    text: &[u8],
    pace: Pace,
    rows: &R,
    reader: &mut impl SequentialReader<R>,
) -> Result<(), ReadError> {
    if pace.chunks == 0 {
        return reader.read_to(text.len());
    }
    let (mut wave, mut next) = (Wave::default(), Wave::default());
    wave.parse(text, reader.at(), pace, rows);
    while wave.end < text.len() && !reader.is_done() {
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

/// Chunks that are parsed at a time.
struct Wave<R> {
    end: usize,
    chunks: Vec<Chunk<R>>,
}

/// Some bytes of a text, and what is plain in them.
struct Chunk<R> {
    text: Range<usize>,
    pieces: Vec<Piece<R>>,
}

/// UsualRows without anything between them.
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
    /// Collects what is plain, unless that is hardly anything: what is not takes more than its share of a reader's
    /// time, and pieces of a row or two take more than the rows.
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

    /// Forgets all pieces, and gives the memory of the first one for another.
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
