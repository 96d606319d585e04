//! A line of text as almost all programs write it: words between blanks, and numbers of the usual spelling.
//!
//! Whatever is unusual is `None` here, be it wrong or only rare. The sequential reader of the format decides what it
//! is.

use crate::text::{self, Real, is_blank, is_line_end, is_space};

/// Walks over the words of a line.
pub(crate) struct UsualLine<'a> {
    text: &'a [u8],
    pub(crate) at: usize,
}

impl<'a> UsualLine<'a> {
    /// The first line with a word at or after a byte.
    #[inline]
    pub(crate) fn from(text: &'a [u8], at: usize) -> Self {
        UsualLine { text, at: text::skip_space(text, at, text.len()) }
    }

    /// Skips a word if it stands here, and returns whether it does.
    #[inline]
    pub(crate) fn accept(&mut self, word: &[u8]) -> bool {
        let rest = &self.text[self.at..];
        let is_here = rest.starts_with(word) && rest.get(word.len()).is_none_or(|&b| is_space(b));
        self.at += if is_here { word.len() } else { 0 };
        is_here
    }

    /// Skips the next word, which must be this one.
    #[inline]
    pub(crate) fn pass(&mut self, word: &[u8]) -> Option<()> {
        (self.has_more() && self.accept(word)).then_some(())
    }

    /// Skips and returns the next word, whatever it is.
    #[inline]
    pub(crate) fn pass_any(&mut self) -> Option<&'a [u8]> {
        let word = self.has_more().then(|| text::word(self.text, self.at))?;
        self.at += word.len();
        Some(word)
    }

    /// Skips a byte if it comes next, and returns whether it does.
    #[inline]
    pub(crate) fn accept_byte(&mut self, byte: u8) -> bool {
        let is_next = self.peek() == Some(byte);
        self.at += usize::from(is_next);
        is_next
    }

    /// Skips blanks, and returns whether the line has another word.
    #[inline]
    pub(crate) fn has_more(&mut self) -> bool {
        while self.peek().is_some_and(is_blank) {
            self.at += 1;
        }
        self.peek().is_some_and(|byte| !is_line_end(byte))
    }

    /// The next word as a floating-point number.
    #[inline]
    pub(crate) fn real<T: Real>(&mut self) -> Option<T> {
        if !self.has_more() {
            return None;
        }
        let (value, length) = text::real::<T>(&self.text[self.at..])?;
        self.at += length;
        self.word_ended().then_some(value)
    }

    /// The next three words as numbers.
    #[inline]
    pub(crate) fn point<T: Real>(&mut self) -> Option<[T; 3]> {
        Some([self.real()?, self.real()?, self.real()?])
    }

    /// The whole number of up to nine digits that begins here.
    #[inline]
    pub(crate) fn digits(&mut self) -> Option<u32> {
        let (start, mut value) = (self.at, 0_u32);
        while let Some(digit) = self.peek().map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
            value = value.wrapping_mul(10).wrapping_add(digit.into());
            self.at += 1;
        }
        (1..=9).contains(&(self.at - start)).then_some(value)
    }

    /// The next word as a whole number of up to nine digits.
    #[inline]
    pub(crate) fn whole(&mut self) -> Option<u32> {
        self.placed_whole().map(|(value, _)| value)
    }

    /// The next word as a whole number of up to nine digits, and where it begins.
    #[inline]
    pub(crate) fn placed_whole(&mut self) -> Option<(u32, usize)> {
        if !self.has_more() {
            return None;
        }
        let start = self.at;
        let value = self.digits()?;
        self.word_ended().then_some((value, start))
    }

    /// Whether the word ends here.
    #[inline]
    pub(crate) fn word_ended(&self) -> bool {
        self.peek().is_none_or(is_space)
    }

    /// Where the next line begins, if this one has no other word.
    #[inline]
    pub(crate) fn end(&mut self) -> Option<usize> {
        (!self.has_more()).then(|| text::after_line_end(self.text, self.at))
    }

    #[inline]
    fn peek(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }
}
