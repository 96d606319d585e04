//! Values, be they text or binary.

use meshmend_core::Values;

use crate::ReadError;
use crate::formats::ply::header::Element;
use crate::formats::ply::scalar::Scalar;
use crate::formats::ply::usual_rows::ParsedRows;

/// A sequence of values, each of a type that the header declares.
pub(super) trait Data {
    /// The place of the next byte.
    fn at(&self) -> usize;

    /// How many bytes are left, if values have a fixed size.
    fn left(&self) -> Option<usize>;

    /// An error at a place in the file.
    fn wrong(&self, at: usize, reason: &str) -> ReadError;

    /// An error if the rest of the file is too short for so many values, which take at least `bytes` in binary.
    fn check_room(&self, values: u64, bytes: u64, what: &str) -> Result<(), ReadError>;

    /// The next value as a double. Doubles hold the values of every type exactly.
    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadError>;

    /// Appends the next value to values of its type.
    fn push(&mut self, scalar: Scalar, values: &mut Values) -> Result<(), ReadError>;

    /// Hands out the next `count` whole numbers with their places.
    fn indices(
        &mut self,
        scalar: Scalar,
        count: usize,
        each: impl FnMut(i64, usize),
    ) -> Result<(), ReadError>;

    /// Hands out the rows of an element, block by block, if all rows have the same size in bytes. Returns whether
    /// they have.
    fn fixed_rows(
        &mut self,
        element: &Element,
        each: impl FnMut(FixedRows<'_>) -> Result<(), ReadError>,
    ) -> Result<bool, ReadError>;

    /// Lets a reader read the rows of an element. Usual rows may be parsed ahead of it.
    #[inline]
    fn each_row(
        &mut self,
        element: &Element,
        _usual: Option<ParsedRows>,
        reader: &mut impl RowReader,
    ) -> Result<(), ReadError>
    where
        Self: Sized,
    {
        for _ in 0..element.count {
            reader.row(self)?;
        }
        Ok(())
    }

    /// Begins an element, whose rows come next.
    fn begin_element(&mut self, element: &Element) -> Result<(), ReadError>;

    /// An error if an element does not end where an element may end.
    fn end_element(&mut self, _: &Element) -> Result<(), ReadError> {
        Ok(())
    }

    /// An error if the file does not end where it may end. In a text, returns the first row that does not stand on a
    /// line of its own, if there is one, and the number of such rows.
    fn end_file(&self) -> Result<Option<(usize, u64)>, ReadError> {
        Ok(None)
    }

    /// How many bytes are left that are not blank, and where they begin.
    fn surplus(&self) -> (usize, usize);

    /// The length of the next list, checked against the rest of the file.
    #[inline(always)]
    fn length(&mut self, length: Scalar, item: Scalar) -> Result<usize, ReadError> {
        let at = self.at();
        let count = self.number(length)?;
        let whole = count as u64;
        if whole as f64 != count {
            return Err(self.wrong(at, &format!("{count} is not the length of a list")));
        }
        let count = whole;
        self.check_room(count, count.saturating_mul(item.size() as u64), "a list")?;
        Ok(count as usize)
    }
}

/// Reads the rows of an element.
pub(super) trait RowReader: Send {
    /// Reads the next row.
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError>;

    /// Takes the next rows, unless they exceed a limit, and returns whether it does.
    fn take(&mut self, _: &ParsedRows) -> bool {
        false
    }
}

/// Some rows of one size in bytes.
pub(super) struct FixedRows<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) stride: usize,
    /// How many rows the element has.
    pub(super) in_all: usize,
    pub(super) is_big_endian: bool,
}
