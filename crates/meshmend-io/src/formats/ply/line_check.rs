//! Whether each row of a text stands on its own line.
//!
//! Text PLY consists of words, wherever its lines end. But a row with a number too many or too few shifts all values
//! after it, and only the lines show that. So a file with other line breaks is accepted only if all values fit: each
//! element ends at the end of a line, or shares that line with whole elements only, and no value is left at the end
//! of the file.

use meshmend_core::counted;

use crate::formats::ply::header::{Element, Property};
use crate::input::source::Source;
use crate::text::{self, is_blank, is_line_end, one_or_many};
use crate::{ReadError, ReadErrorKind};

/// The rows so far, compared with the lines.
pub(super) struct LineCheck<'a> {
    source: &'a Source<'a>,
    first: Option<OddRow>,
    odd_rows: u64,
    /// Where the values of the current element begin.
    element_start: usize,
    /// Whether the last element ended in the middle of a line.
    is_within_line: bool,
}

/// A row that does not stand on its own line.
pub(super) struct OddRow {
    /// Where it begins.
    pub(super) at: usize,
    /// The values of its line, the values that it announces, and its element.
    reason: String,
    /// Whether it announces more values than its line has.
    is_short: bool,
}

impl<'a> LineCheck<'a> {
    pub(super) fn new(source: &'a Source<'a>) -> Self {
        LineCheck { source, first: None, odd_rows: 0, element_start: 0, is_within_line: false }
    }

    /// The first row that does not stand on its own line, and the number of such rows.
    pub(super) fn odd_rows(&self) -> Option<(usize, u64)> {
        self.first.as_ref().map(|first| (first.at, self.odd_rows))
    }

    pub(super) fn begin_element(&mut self, at: usize) {
        self.element_start = text::skip_space(self.source.bytes, at, self.source.bytes.len());
    }

    /// Checks the lines of a row that has been read.
    #[inline]
    pub(super) fn end_row(&mut self, element: &Element, row: u64, start: usize, end: usize) {
        let bytes = self.source.bytes;
        let line_end = text::line_end(bytes, start);
        let is_alone = end <= line_end && bytes[end..line_end].iter().all(|&b| is_blank(b));
        if !is_alone {
            self.keep(element, row, start);
        }
    }

    #[cold]
    fn keep(&mut self, element: &Element, row: u64, start: usize) {
        self.odd_rows += 1;
        if self.first.is_none() {
            self.first = Some(OddRow::of(self.source.bytes, element, row, start));
        }
    }

    /// An error if an element does not end where it may end.
    pub(super) fn end_element(&mut self, element: &Element, end: usize) -> Result<(), ReadError> {
        let Some(first) = &self.first else { return Ok(()) };
        let bytes = self.source.bytes;
        if self.element_start >= end {
            return Ok(());
        }
        let after = bytes[end..].iter().find(|&&b| !is_blank(b));
        let ends_within_line = after.is_some_and(|&b| !is_line_end(b));
        let is_of_one_line = !bytes[self.element_start..end].iter().any(|&b| is_line_end(b));
        if (self.is_within_line || ends_within_line) && !is_of_one_line {
            let line = text::line_number(bytes, end);
            let name = &element.name;
            let why = format!("read across lines, element `{name}` does not end with line {line}");
            return Err(first.error(self.source, Some(&why)));
        }
        self.is_within_line = ends_within_line;
        Ok(())
    }

    /// An error if values are left at the end of a file whose rows do not stand on their own lines.
    pub(super) fn end_file(&self, end: usize) -> Result<(), ReadError> {
        let Some(first) = &self.first else { return Ok(()) };
        match text::words(&self.source.bytes[end..]).count() {
            0 => Ok(()),
            left => {
                let left = one_or_many(left, "value is", "values are");
                let why = format!("read across lines, {left} left at the end of the file");
                Err(first.error(self.source, Some(&why)))
            }
        }
    }

    /// The error when the file ends instead of a row.
    #[cold]
    pub(super) fn missing(&self, element: &Element, row: u64) -> ReadError {
        let Element { name, count, .. } = element;
        let found = if row == 1 || *count == 1 { "is" } else { "are" };
        let rows = counted(count, "row");
        let reason = format!("the file ends early: {row} of {rows} of element `{name}` {found} there");
        match &self.first {
            Some(first) => first.error(self.source, Some(&format!("read across lines, {reason}"))),
            None => self.source.malformed(self.source.line(self.source.bytes.len()), reason),
        }
    }

    /// The error of a row that can't be read. If an earlier line, or its own, has a wrong number of values, that is
    /// the reason.
    #[cold]
    pub(super) fn explained(&self, element: &Element, row: u64, start: usize, error: ReadError) -> ReadError {
        let ReadErrorKind::Malformed(reason) = &error.kind else { return error };
        if let Some(first) = &self.first {
            let why = format!("read across lines, it fails at {}: {reason}", error.place);
            return first.error(self.source, Some(&why));
        }
        let this = OddRow::of(self.source.bytes, element, row, start);
        if this.is_short { this.error(self.source, None) } else { error }
    }
}

impl OddRow {
    fn of(bytes: &[u8], element: &Element, row: u64, at: usize) -> Self {
        let line = &bytes[at..text::line_end(bytes, at)];
        let found = text::words(line).count() as u64;
        let (announced, is_exact) = announced(line, &element.properties);
        let least = if is_exact { "" } else { "at least " };
        let Element { name, count, .. } = element;
        let (row, values) = (row + 1, counted(announced, "value"));
        let reason = format!(
            "row {row} of {count} of element `{name}` announces {least}{values}, its line has {found}"
        );
        OddRow { at, reason, is_short: found < announced }
    }

    fn error(&self, source: &Source<'_>, why: Option<&str>) -> ReadError {
        let why = why.map(|why| format!("; {why}")).unwrap_or_default();
        source.malformed(source.line(self.at), format!("{}{why}", self.reason))
    }
}

/// How many values a row announces that begins with a line, and whether the line has all the lengths of its lists.
fn announced(line: &[u8], properties: &[Property]) -> (u64, bool) {
    let (mut words, mut values, mut is_exact) = (text::words(line), 0_u64, true);
    for property in properties {
        values = values.saturating_add(1);
        let word = words.next();
        if property.length.is_none() {
            continue;
        }
        let length = word.and_then(text::real::<f64>).map(|(length, _)| length as u64);
        is_exact &= length.is_some();
        let length = length.unwrap_or(0);
        values = values.saturating_add(length);
        if let Some(last) = length.checked_sub(1) {
            words.nth(usize::try_from(last).unwrap_or(usize::MAX));
        }
    }
    (values, is_exact)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::ply::scalar::Scalar;

    fn property(length: Option<Scalar>) -> Property {
        Property { name: "p".to_owned(), length, item: Scalar::I32 }
    }

    #[test]
    fn lists_announce_their_length_and_what_is_in_them() {
        let (one, list) = (|| property(None), || property(Some(Scalar::U8)));
        for (line, properties, expected) in [
            ("0 0", vec![one(), one(), one()], (3, true)),
            ("3 0 1 2", vec![list()], (4, true)),
            ("3 0 1 2 9", vec![list(), one()], (5, true)),
            ("2 7 7 1 5", vec![list(), list()], (5, true)),
            ("2 7 7", vec![list(), list()], (4, false)),
            ("0 0", vec![list(), list()], (2, true)),
            ("x 1", vec![list()], (1, false)),
            ("-1 1", vec![list()], (1, true)),
            ("1e30 1", vec![list(), list()], (u64::MAX, false)),
        ] {
            assert_eq!(announced(line.as_bytes(), &properties), expected, "{line}");
        }
    }
}
