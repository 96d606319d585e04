//! What is taken from the pieces, and what is left to the reader.

mod alone;
mod random;
mod texts;

use super::*;

/// The usual rows are `x`. Any other line is unusual, and `skip` spans two lines.
#[derive(Default)]
struct Crosses(usize);

impl UsualRows for Crosses {
    fn none(&self) -> Self {
        Crosses(0)
    }

    fn clear(&mut self) {
        self.0 = 0;
    }

    fn add(&mut self, text: &[u8], at: usize) -> Option<usize> {
        let row = text[at..].starts_with(b"x\n");
        self.0 += usize::from(row);
        row.then_some(at + 2)
    }
}

#[derive(Default)]
struct Counting<'a> {
    text: &'a [u8],
    at: usize,
    /// Lines that it was given, and those that it has read itself.
    given: usize,
    read: Vec<&'a [u8]>,
}

impl SequentialReader<Crosses> for Counting<'_> {
    fn at(&self) -> usize {
        self.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        while self.at < end {
            let line_end = text::line_end(self.text, self.at);
            self.read.push(&self.text[self.at..line_end]);
            self.at = text::after_line_end(self.text, line_end);
            if self.read.last() == Some(&&b"skip"[..]) {
                self.at = text::after_line_end(self.text, text::line_end(self.text, self.at));
            }
        }
        Ok(())
    }

    fn take(&mut self, rows: &Crosses, end: usize) {
        self.given += rows.0;
        self.at = end;
    }

    fn is_done(&self) -> bool {
        false
    }

    fn look(&self) -> Result<(), ReadError> {
        Ok(())
    }
}

fn counted(text: &[u8], chunk: usize, chunks: usize) -> (usize, Vec<&[u8]>) {
    let mut reader = Counting { text, ..Counting::default() };
    read_speculatively(text, Pace { chunk, chunks }, &Crosses(0), &mut reader).unwrap();
    assert_eq!(reader.at, text.len());
    (reader.given, reader.read)
}

#[test]
fn a_reader_takes_the_usual_rows_and_reads_the_rest() {
    let text = b"x\nx\na\nx\nb\nc\nx\nx\n";
    for chunk in 1..20 {
        for chunks in 1..4 {
            assert_eq!(counted(text, chunk, chunks), (5, vec![&b"a"[..], b"b", b"c"]));
        }
    }
    assert_eq!(counted(b"", 1, 2), (0, vec![]));
}

#[test]
fn what_a_reader_has_passed_over_is_not_given_to_it() {
    let text = b"x\nskip\nx\nx\nx\n";
    for chunk in 1..20 {
        let (given, read) = counted(text, chunk, 2);
        // The rows of the piece in whose first row it would stand are read.
        assert_eq!(given + read.len(), 4, "{chunk}");
        assert_eq!(read[0], b"skip");
    }
}

#[test]
fn a_chunk_with_few_usual_rows_is_left_to_the_reader() {
    let few = b"x\na\n".repeat(1000);
    let (given, read) = counted(&few, 1 << 20, 1);
    assert_eq!(given + read.len(), 2000);
    assert!((10..30).contains(&given), "{given}");
    let often = [&b"x\n".repeat(1000)[..], b"a\n"].concat().repeat(100);
    assert_eq!(counted(&often, 1 << 20, 1).0, 100_000);
}

#[test]
fn small_texts_start_no_thread() {
    assert_eq!(Pace::of(1000).chunks, 1);
}
