//! Where the names of solids end in a text: at the end of the line, or at a facet or an `endsolid` on that line.
//!
//! A name may have any words. So `facet` ends it only if the whole beginning of a facet follows, and `endsolid` only
//! if what comes after it can't belong to the same solid.

use std::ops::Range;

use crate::text::{self, is_blank, is_space};

/// Finds the ends of names. It remembers where the next facet of a line begins, so a line with many solids is
/// searched once.
pub(super) struct SolidNames<'a> {
    text: &'a [u8],
    /// The part of a line that was searched. It ends where `next` begins.
    searched: Range<usize>,
    next: Next,
}

/// What comes first after the words of a name.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Next {
    Facet,
    LineEnd,
}

impl<'a> SolidNames<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        // No name begins at the first byte.
        SolidNames { text, searched: 0..0, next: Next::LineEnd }
    }

    /// The end of the name that begins at a byte, after the word `solid`.
    pub(super) fn end(&mut self, at: usize) -> usize {
        let next = self.find_next(at);
        let end = self.searched.end;
        let Some(end_word) = self.find_word(at..end, b"endsolid") else { return end };
        let is_over = match next {
            Next::Facet => self.find_word(end_word..end, b"solid").is_some(),
            Next::LineEnd => !self.goes_on_after(end),
        };
        if is_over { end_word } else { end }
    }

    /// Where reading goes on after the name at a byte, after the word `endsolid`: at the next solid of the line if
    /// that has facets, else at the end of the line.
    pub(super) fn end_of_repeated(&mut self, at: usize, name: &[u8]) -> usize {
        let start = at + self.text[at..].iter().take_while(|&&b| is_blank(b)).count();
        let after =
            self.text[start..].strip_prefix(name).filter(|rest| rest.first().is_none_or(|&b| is_space(b)));
        let at = after.map_or(start, |rest| self.text.len() - rest.len());
        let has_facet = match self.find_next(at) {
            Next::Facet => true,
            Next::LineEnd => begins_facet_line(self.text, self.searched.end),
        };
        let end = self.searched.end;
        if has_facet { self.find_word(at..end, b"solid").unwrap_or(end) } else { end }
    }

    /// Finds the first facet in the rest of the line, or the end of the line.
    fn find_next(&mut self, at: usize) -> Next {
        if self.searched.start <= at && at <= self.searched.end {
            return self.next;
        }
        let end = text::line_end(self.text, at);
        let mut words = WordsOf { text: self.text, rest: at..end };
        let facet =
            words.find(|word| is(&self.text[word.clone()], b"facet") && begins_facet(self.text, word.end));
        self.searched = at..facet.as_ref().map_or(end, |word| word.start);
        self.next = if facet.is_some() { Next::Facet } else { Next::LineEnd };
        self.next
    }

    fn find_word(&self, range: Range<usize>, word: &[u8]) -> Option<usize> {
        let mut words = WordsOf { text: self.text, rest: range };
        words.find(|found| is(&self.text[found.clone()], word)).map(|found| found.start)
    }

    /// Whether the line after this end continues a solid.
    fn goes_on_after(&self, end: usize) -> bool {
        let next = text::skip_space(self.text, end, self.text.len());
        is(text::word(self.text, next), b"endsolid") || begins_facet_line(self.text, end)
    }
}

/// Whether a name contains the beginning of a facet.
pub(super) fn holds_facet(name: &[u8]) -> bool {
    let mut words = WordsOf { text: name, rest: 0..name.len() };
    words.any(|word| is(&name[word.clone()], b"facet") && begins_facet(name, word.end))
}

fn is(found: &[u8], word: &[u8]) -> bool {
    found.eq_ignore_ascii_case(word)
}

/// Whether the next word is `facet` and begins a facet.
fn begins_facet_line(text: &[u8], at: usize) -> bool {
    let start = text::skip_space(text, at, text.len());
    let word = text::word(text, start);
    is(word, b"facet") && begins_facet(text, start + word.len())
}

/// Whether the beginning of a facet follows the word `facet`: up to four words, `outer loop vertex` and a number.
fn begins_facet(text: &[u8], at: usize) -> bool {
    const MOST_WORDS: usize = 4;
    let mut words = text::words(&text[at..]);
    for _ in 0..=MOST_WORDS {
        match words.next() {
            Some(word) if is(word, b"outer") => {
                let mut follows = |expected: &[u8]| words.next().is_some_and(|word| is(word, expected));
                return follows(b"loop")
                    && follows(b"vertex")
                    && words.next().is_some_and(|word| text::real::<f64>(word).is_some());
            }
            Some(word) if !is(word, b"facet") && !is(word, b"solid") && !is(word, b"endsolid") => {}
            _ => return false,
        }
    }
    false
}

/// The places of the words in a part of a text.
struct WordsOf<'a> {
    text: &'a [u8],
    rest: Range<usize>,
}

impl Iterator for WordsOf<'_> {
    type Item = Range<usize>;

    fn next(&mut self) -> Option<Range<usize>> {
        let part = &self.text[self.rest.clone()];
        let start = self.rest.start + part.iter().position(|&b| !is_space(b))?;
        let length = text::word(&self.text[..self.rest.end], start).len();
        self.rest.start = start + length;
        Some(start..start + length)
    }
}
