//! Binary values, block by block: no more than a block of the source is held in memory.

use std::io::{self, Chain, Read};

use meshmend_core::Watch;

use crate::input::source::Source;
use crate::watched::READ;

/// How many bytes are read at a time. They fit the caches of the processor.
const BLOCK: usize = 1 << 18;

/// The bytes from a place of a source to its end.
pub(crate) struct BlockReader<'a> {
    from: Chain<&'a [u8], &'a mut dyn Read>,
    /// The bytes that have been read. Those before `next` have been taken.
    block: Vec<u8>,
    next: usize,
    /// Where in the source the block begins.
    start: usize,
    /// How long the source is.
    length: usize,
    watch: &'a Watch,
}

impl<'a> BlockReader<'a> {
    /// The bytes of a source from a place on; those that are not in memory come from `rest`.
    pub(crate) fn new(source: &Source<'a>, at: usize, rest: &'a mut dyn Read) -> Self {
        let from = source.bytes[at..].chain(rest);
        BlockReader {
            from,
            block: Vec::new(),
            next: 0,
            start: at,
            length: source.length,
            watch: source.watch,
        }
    }

    /// Where in the source the next byte is.
    #[inline]
    pub(crate) fn at(&self) -> usize {
        self.start + self.next
    }

    /// How many bytes are left.
    #[inline]
    pub(crate) fn left(&self) -> usize {
        self.length - self.at()
    }

    /// The next bytes, or an error if there are fewer or the source fails.
    #[inline]
    pub(crate) fn take(&mut self, length: usize) -> io::Result<&[u8]> {
        if self.block.len() - self.next < length {
            self.fill(length)?;
        }
        let bytes = &self.block[self.next..self.next + length];
        self.next += length;
        Ok(bytes)
    }

    /// The next rows of so many bytes each: as many as fit a block, and at most `most`.
    pub(crate) fn take_rows(&mut self, stride: usize, most: usize) -> io::Result<&[u8]> {
        let rows = (BLOCK / stride.max(1)).max(1).min(most);
        self.take(rows * stride)
    }

    /// Reads until so many bytes can be taken.
    #[cold]
    fn fill(&mut self, length: usize) -> io::Result<()> {
        if length > self.left() {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        self.watch.look(READ, self.at(), self.length).map_err(io::Error::other)?;
        self.block.drain(..self.next);
        (self.start, self.next) = (self.start + self.next, 0);
        let more = length.max(BLOCK).min(self.left()) - self.block.len();
        self.block.try_reserve_exact(more)?;
        match self.from.by_ref().take(more as u64).read_to_end(&mut self.block)? {
            found if found < more => Err(io::ErrorKind::UnexpectedEof.into()),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::speculative_parse::Pace;

    /// Gives a few bytes at a time, and fails at one call if that comes.
    struct Slow<'a> {
        rest: &'a [u8],
        calls: usize,
        failing: usize,
    }

    impl Read for Slow<'_> {
        fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
            self.calls += 1;
            if self.calls == self.failing {
                return Err(io::ErrorKind::Other.into());
            }
            let most = into.len().min(1000);
            self.rest.read(&mut into[..most])
        }
    }

    fn bytes(length: usize) -> Vec<u8> {
        (0..length).map(|at| (at * 7 % 251) as u8).collect()
    }

    fn source(head: &[u8], length: usize) -> Source<'_> {
        Source {
            bytes: head,
            length,
            name: "blocks",
            pace: Pace::NONE,
            folder: None,
            shared_places: false,
            watch: &Watch::NOBODY,
        }
    }

    #[test]
    fn bytes_come_in_order_however_many_are_taken() {
        let all = bytes(3 * BLOCK + 17);
        for (head, size) in
            [(100, 1), (5000, 999), (all.len(), 70_001), (64, BLOCK + 1), (200, all.len() - 30)]
        {
            let mut rest = Slow { rest: &all[head..], calls: 0, failing: 0 };
            let mut blocks = BlockReader::new(&source(&all[..head], all.len()), 30, &mut rest);
            let mut at = 30;
            while blocks.left() >= size {
                assert_eq!((blocks.at(), blocks.left()), (at, all.len() - at));
                assert!(blocks.take(size).unwrap() == &all[at..at + size], "{at}");
                at += size;
            }
            let left = blocks.left();
            assert_eq!(blocks.take(left + 1).unwrap_err().kind(), io::ErrorKind::UnexpectedEof);
            assert!(blocks.take(left).unwrap() == &all[at..], "what is left is still there");
        }
    }

    #[test]
    fn rows_come_in_blocks_and_none_beyond_the_last() {
        let all = bytes(2 * BLOCK);
        let mut rest = io::empty();
        let mut blocks = BlockReader::new(&source(&all, all.len()), 0, &mut rest);
        let mut rows = 0;
        while rows < 10_000 {
            let block = blocks.take_rows(50, 10_000 - rows).unwrap();
            assert!(block.len().is_multiple_of(50) && !block.is_empty() && block.len() <= BLOCK);
            assert!(block == &all[50 * rows..50 * rows + block.len()]);
            rows += block.len() / 50;
        }
        assert_eq!((rows, blocks.at()), (10_000, 500_000));
        assert_eq!(blocks.take_rows(1000, 3).unwrap().len(), 3000);
    }

    #[test]
    fn a_source_that_fails_or_ends_early_is_an_error() {
        let all = bytes(BLOCK);
        for failing in 1..=4 {
            let mut rest = Slow { rest: &all, calls: 0, failing };
            let mut blocks = BlockReader::new(&source(&all[..10], all.len() + 10), 0, &mut rest);
            assert_eq!(blocks.take(5000).unwrap_err().kind(), io::ErrorKind::Other);
        }
        let mut rest = &all[..];
        let mut blocks = BlockReader::new(&source(&[], 2 * BLOCK), 0, &mut rest);
        let ends_early = (0..4).find_map(|_| blocks.take(BLOCK / 2).err());
        assert_eq!(ends_early.unwrap().kind(), io::ErrorKind::UnexpectedEof);
    }
}
