//! Values as text: words between blanks, wherever the lines end ([`LineCheck`] judges those). Usual rows are parsed
//! ahead.

use meshmend_core::Values;

use crate::ReadError;
use crate::formats::ply::data::{Data, FixedRows, RowReader};
use crate::formats::ply::header::Element;
use crate::formats::ply::line_check::LineCheck;
use crate::formats::ply::scalar::Scalar;
use crate::formats::ply::usual_rows::ParsedRows;
use crate::input::source::Source;
use crate::text::speculative_parse::{SequentialReader, read_alone, read_speculatively};
use crate::text::{self, is_space, one_or_many};

pub(super) struct TextValues<'a> {
    source: &'a Source<'a>,
    at: usize,
    lines: LineCheck<'a>,
}

impl<'a> TextValues<'a> {
    pub(super) fn new(source: &'a Source<'a>, at: usize) -> Self {
        TextValues { source, at, lines: LineCheck::new(source) }
    }

    /// The bytes from the next word on.
    #[inline]
    fn next(&mut self) -> Result<&'a [u8], ReadError> {
        let bytes = &self.source.bytes[self.at..];
        match bytes.iter().position(|&b| !is_space(b)) {
            Some(blanks) => {
                self.at += blanks;
                Ok(&bytes[blanks..])
            }
            None => Err(self.wrong(self.source.bytes.len(), "the file ends early: a value is missing")),
        }
    }

    /// Skips a value if a blank or the end follows it.
    #[inline]
    fn passed<T>(&mut self, bytes: &[u8], value: Option<(T, usize)>) -> Option<T> {
        let (value, length) = value?;
        bytes.get(length).is_none_or(|&b| is_space(b)).then(|| {
            self.at += length;
            value
        })
    }

    #[inline]
    fn real<T: text::Real>(&mut self) -> Result<T, ReadError> {
        let bytes = self.next()?;
        self.passed(bytes, text::real::<T>(bytes)).ok_or_else(|| self.not("a number"))
    }

    /// A whole number within the range of its type.
    #[inline]
    fn whole(&mut self, scalar: Scalar) -> Result<i64, ReadError> {
        let (least, greatest) = scalar.range();
        match self.short() {
            Some((value, length)) if (least..=greatest).contains(&value) => {
                self.at += length;
                Ok(value)
            }
            _ => self.any_whole(scalar),
        }
    }

    /// A whole number in the usual spelling, and its length: up to nine digits between two blanks, the first of which
    /// may be missing.
    #[inline]
    fn short(&self) -> Option<(i64, usize)> {
        let bytes = &self.source.bytes[self.at..];
        let blank = usize::from(bytes.first().is_some_and(|&b| is_space(b)));
        let (mut length, mut value) = (blank, 0_u32);
        while let Some(digit) = bytes.get(length).map(|b| b.wrapping_sub(b'0')).filter(|&digit| digit < 10) {
            value = value.wrapping_mul(10).wrapping_add(digit.into());
            length += 1;
        }
        let is_short = (blank + 1..=blank + 9).contains(&length);
        (is_short && bytes.get(length).is_some_and(|&b| is_space(b))).then_some((value.into(), length))
    }

    #[cold]
    fn any_whole(&mut self, scalar: Scalar) -> Result<i64, ReadError> {
        let bytes = self.next()?;
        let value = match self.passed(bytes, text::integer(bytes)) {
            Some(value) => value,
            None => self.whole_with_point(bytes)?,
        };
        let (least, greatest) = scalar.range();
        if (least..=greatest).contains(&value) {
            return Ok(value);
        }
        Err(self.wrong(self.at, &format!("{value} is not a number of type `{}`", scalar.name())))
    }

    /// A whole number that is spelled with a point, such as `255.0`.
    #[cold]
    fn whole_with_point(&mut self, bytes: &[u8]) -> Result<i64, ReadError> {
        let whole = text::real::<f64>(bytes).filter(|(value, _)| value.fract() == 0.0);
        self.passed(bytes, whole).map(|value| value as i64).ok_or_else(|| self.not("a whole number"))
    }

    #[cold]
    fn not(&self, what: &str) -> ReadError {
        let found = text::shown(text::word(self.source.bytes, self.at));
        self.wrong(self.at, &format!("`{found}` where {what} belongs"))
    }
}

impl Data for TextValues<'_> {
    fn at(&self) -> usize {
        self.at
    }

    fn left(&self) -> Option<usize> {
        None
    }

    #[cold]
    fn wrong(&self, at: usize, reason: &str) -> ReadError {
        self.source.malformed(self.source.line(at), reason)
    }

    fn check_room(&self, values: u64, _: u64, what: &str) -> Result<(), ReadError> {
        // A value takes at least a byte and a blank.
        let left = self.source.bytes.len() - self.at;
        if values <= left as u64 / 2 + 1 {
            return Ok(());
        }
        let left = one_or_many(left, "byte is", "bytes are");
        Err(self.wrong(self.at, &format!("the file ends early: {left} left for {what}")))
    }

    #[inline]
    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadError> {
        match scalar {
            Scalar::F32 => self.real::<f32>().map(f64::from),
            Scalar::F64 => self.real::<f64>(),
            _ => self.whole(scalar).map(|value| value as f64),
        }
    }

    fn push(&mut self, scalar: Scalar, values: &mut Values) -> Result<(), ReadError> {
        match values {
            Values::F32(v) => v.push(self.real()?),
            Values::F64(v) => v.push(self.real()?),
            Values::I8(v) => v.push(self.whole(scalar)? as i8),
            Values::U8(v) => v.push(self.whole(scalar)? as u8),
            Values::I16(v) => v.push(self.whole(scalar)? as i16),
            Values::U16(v) => v.push(self.whole(scalar)? as u16),
            Values::I32(v) => v.push(self.whole(scalar)? as i32),
            Values::U32(v) => v.push(self.whole(scalar)? as u32),
            Values::Text(_) | Values::Lists { .. } => {}
        }
        Ok(())
    }

    #[inline]
    fn indices(
        &mut self,
        scalar: Scalar,
        count: usize,
        mut each: impl FnMut(i64, usize),
    ) -> Result<(), ReadError> {
        for _ in 0..count {
            let index = self.whole(scalar)?;
            each(index, self.at - 1);
        }
        Ok(())
    }

    fn fixed_rows(
        &mut self,
        _: &Element,
        _: impl FnMut(FixedRows<'_>) -> Result<(), ReadError>,
    ) -> Result<bool, ReadError> {
        Ok(false)
    }

    fn each_row(
        &mut self,
        element: &Element,
        usual: Option<ParsedRows>,
        reader: &mut impl RowReader,
    ) -> Result<(), ReadError> {
        let source = self.source;
        let mut rows = RowsLeft { next: self.at, data: self, reader, element, left: element.count };
        match usual {
            Some(table) => read_speculatively(source.bytes, source.pace, &table, &mut rows),
            None => read_alone(source.bytes, &mut rows),
        }
    }

    /// Missing rows are found at the end of the file, where their number is known.
    fn begin_element(&mut self, _: &Element) -> Result<(), ReadError> {
        self.lines.begin_element(self.at);
        Ok(())
    }

    fn end_element(&mut self, element: &Element) -> Result<(), ReadError> {
        self.lines.end_element(element, self.at)
    }

    fn end_file(&self) -> Result<Option<(usize, u64)>, ReadError> {
        self.lines.end_file(self.at)?;
        Ok(self.lines.odd_rows())
    }

    fn surplus(&self) -> (usize, usize) {
        let bytes = &self.source.bytes[self.at..];
        let start = bytes.len() - text::trimmed_start(bytes).len();
        (text::trimmed(bytes).len(), self.at + start)
    }
}

/// The rows of an element that are still to be read.
struct RowsLeft<'r, 'a, R> {
    /// Where the next row may begin. The values stay at the end of the last row, as that is the place of errors.
    next: usize,
    data: &'r mut TextValues<'a>,
    reader: &'r mut R,
    element: &'r Element,
    left: u64,
}

impl<R: RowReader> RowsLeft<'_, '_, R> {
    /// Reads the row that begins at the next byte.
    #[inline]
    fn row(&mut self) -> Result<(), ReadError> {
        let (row, start) = (self.element.count - self.left, self.next);
        if start == self.data.source.bytes.len() {
            return Err(self.data.lines.missing(self.element, row));
        }
        match self.reader.row(self.data) {
            Ok(()) => self.data.lines.end_row(self.element, row, start, self.data.at),
            Err(error) => return Err(self.data.lines.explained(self.element, row, start, error)),
        }
        self.left -= 1;
        Ok(())
    }
}

impl<R: RowReader> SequentialReader<ParsedRows> for RowsLeft<'_, '_, R> {
    fn at(&self) -> usize {
        self.next
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        let bytes = self.data.source.bytes;
        while self.left > 0 {
            self.next = text::skip_space(bytes, self.data.at, end);
            if (end..bytes.len()).contains(&self.next) {
                break;
            }
            self.row()?;
        }
        Ok(())
    }

    fn take(&mut self, rows: &ParsedRows, end: usize) {
        if rows.rows as u64 <= self.left && self.reader.take(rows) {
            self.left -= rows.rows as u64;
            let spaces = self.data.source.bytes[..end].iter().rev().take_while(|&&b| is_space(b)).count();
            (self.data.at, self.next) = (end - spaces, end);
        }
    }

    fn is_done(&self) -> bool {
        self.left == 0
    }

    fn look(&self) -> Result<(), ReadError> {
        self.data.source.look(self.next)
    }
}
