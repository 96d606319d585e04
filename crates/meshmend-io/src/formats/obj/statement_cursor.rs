//! A place in an OBJ file, and the items of a statement.

use std::borrow::Cow;

use crate::ReadError;
use crate::input::source::Source;
use crate::text::{self, is_blank, is_line_end};

/// Walks over the bytes of a file.
pub(super) struct Cursor<'a> {
    source: &'a Source<'a>,
    pub(super) bytes: &'a [u8],
    pub(super) at: usize,
}

/// How many numbers of a statement can have a meaning.
pub(super) const COLUMNS: usize = 8;

impl<'a> Cursor<'a> {
    /// The start of a file, after its byte order mark.
    pub(super) fn new(source: &'a Source<'a>) -> Self {
        let at = text::text_start(source.bytes);
        Cursor { source, bytes: source.bytes, at }
    }

    /// Reads the rest of a statement as numbers. Returns how many there are, and keeps as many as fit.
    #[inline]
    pub(super) fn numbers(&mut self, kept: &mut [f64; COLUMNS]) -> Result<usize, ReadError> {
        let mut count = 0;
        while self.more_items() {
            let Some((value, length)) = text::real::<f64>(&self.bytes[self.at..]) else {
                return Err(self.not_a_number());
            };
            self.at += length;
            if !self.item_ended() {
                self.at -= length;
                return Err(self.not_a_number());
            }
            if let Some(slot) = kept.get_mut(count) {
                *slot = value;
            }
            count += 1;
        }
        Ok(count)
    }

    pub(super) fn not_a_number(&self) -> ReadError {
        let found = text::shown(text::word(self.bytes, self.at));
        self.wrong(self.at, &format!("`{found}` where a number belongs"))
    }

    pub(super) fn is_index(&self) -> bool {
        self.peek().is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'-' | b'+'))
    }

    #[inline]
    pub(super) fn index(&mut self, what: &str) -> Result<i64, ReadError> {
        match text::integer(&self.bytes[self.at..]) {
            Some((value, length)) => {
                self.at += length;
                Ok(value)
            }
            None => {
                let found = text::shown(text::word(self.bytes, self.at));
                Err(self.wrong(self.at, &format!("`{found}` where {what} belongs")))
            }
        }
    }

    #[inline]
    pub(super) fn item_ended(&self) -> bool {
        self.peek().is_none_or(|byte| is_blank(byte) || is_line_end(byte) || matches!(byte, b'#' | b'\\'))
    }

    #[inline]
    pub(super) fn end_item(&self, what: &str) -> Result<(), ReadError> {
        if self.item_ended() {
            return Ok(());
        }
        let found = text::shown(text::word(self.bytes, self.at));
        Err(self.wrong(self.at, &format!("`{found}` after {what}")))
    }

    /// Skips to the next item of the statement, and returns whether there is one.
    #[inline]
    pub(super) fn more_items(&mut self) -> bool {
        self.skip_blanks();
        self.peek().is_some_and(|byte| !is_line_end(byte) && byte != b'#')
    }

    #[inline]
    pub(super) fn skip_blanks(&mut self) {
        while let Some(byte) = self.peek() {
            if is_blank(byte) {
                self.at += 1;
            } else if byte == b'\\' && self.bytes.get(self.at + 1).is_none_or(|&next| is_line_end(next)) {
                self.at = text::after_line_end(self.bytes, self.at + 1);
            } else {
                return;
            }
        }
    }

    /// The rest of a statement as a name, without blanks at its ends. A comment is not read.
    pub(super) fn rest(&mut self) -> Result<Cow<'a, [u8]>, ReadError> {
        let start = self.at;
        let mut end = text::line_end(self.bytes, start);
        let mut continued: Option<Vec<u8>> = None;
        let mut piece = &self.bytes[start..end];
        while let Some(before) = piece.strip_suffix(b"\\") {
            continued.get_or_insert_default().extend([before, b" "].concat());
            let next = text::after_line_end(self.bytes, end);
            end = text::line_end(self.bytes, next);
            piece = &self.bytes[next..end];
        }
        self.at = end;
        if self.bytes[start..end].contains(&0) {
            return Err(self.wrong(start, "a NUL byte in a statement"));
        }
        Ok(match continued {
            None => {
                self.at = start + comment_start(piece);
                Cow::Borrowed(name_of(piece))
            }
            Some(mut whole) => {
                whole.extend(piece);
                Cow::Owned(name_of(&whole).to_vec())
            }
        })
    }

    #[inline]
    pub(super) fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    #[cold]
    pub(super) fn wrong(&self, at: usize, reason: &str) -> ReadError {
        self.source.malformed(self.source.line(at), reason)
    }
}

/// A name without blanks at its ends, and without a comment.
fn name_of(bytes: &[u8]) -> &[u8] {
    text::trimmed(&bytes[..comment_start(bytes)])
}

/// Where a comment begins, or the end if there is none. It begins with a `#` at the start or after a blank.
fn comment_start(bytes: &[u8]) -> usize {
    let begins_comment = |at: usize| bytes[at] == b'#' && (at == 0 || is_blank(bytes[at - 1]));
    (0..bytes.len()).find(|&at| begins_comment(at)).unwrap_or(bytes.len())
}
