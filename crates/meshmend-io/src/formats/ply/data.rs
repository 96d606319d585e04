//! What is asked of values, be they text or binary.

use meshmend_core::Values;

use crate::ReadError;
use crate::formats::ply::header::Element;
use crate::formats::ply::scalar::Scalar;
use crate::formats::ply::usual_rows::ParsedRows;

/// Values one after the other, each of a type that the header tells.
pub(super) trait Data {
    /// Which byte comes next.
    fn at(&self) -> usize;

    /// How many bytes are left, if each type of values has a size.
    fn left(&self) -> Option<usize>;

    /// An error that says where in the file it is.
    fn wrong(&self, at: usize, reason: &str) -> ReadError;

    /// An error unless the bytes that are left can hold so many values, the least sizes being `bytes` in binary.
    fn check_room(&self, values: u64, bytes: u64, what: &str) -> Result<(), ReadError>;

    /// The next value as a double, which holds each type's values exactly.
    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadError>;

    /// Appends the next value to values of its type.
    fn push(&mut self, scalar: Scalar, values: &mut Values) -> Result<(), ReadError>;

    /// Gives the next `count` whole numbers with their places.
    fn indices(
        &mut self,
        scalar: Scalar,
        count: usize,
        each: impl FnMut(i64, usize),
    ) -> Result<(), ReadError>;

    /// Gives the rows of an element block by block, if each row has the same size in bytes; else says that it does not.
    fn fixed_rows(&mut self, element: &Element, each: impl FnMut(FixedRows<'_>)) -> Result<bool, ReadError>;

    /// Lets a reader read the rows of an element; plain ones may be parsed ahead of it.
    #[inline]
    fn each_row(
        &mut self,
        element: &Element,
        _plain: Option<ParsedRows>,
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

    /// Goes on to an element, all of whose rows come next.
    fn begin_element(&mut self, element: &Element) -> Result<(), ReadError>;

    /// An error if an element that has been read does not end where one may end.
    fn end_element(&mut self, _: &Element) -> Result<(), ReadError> {
        Ok(())
    }

    /// An error if the file does not end where it may end; else the first row that does not stand on a line of its own,
    /// where such rows are told from others, and how many there are.
    fn end_file(&self) -> Result<Option<(usize, u64)>, ReadError> {
        Ok(None)
    }

    /// How many bytes are left that are not blank, and where they begin.
    fn surplus(&self) -> (usize, usize);

    /// The length of a list that comes next, checked against what is left.
    #[inline(always)]
    fn length(&mut self, length: Scalar, item: Scalar) -> Result<usize, ReadError> {
        let at = self.at();
        let count = self.number(length)?;
        let whole = count as u64;
        if whole as f64 != count {
            return Err(self.wrong(at, &format!("{count} is no length of a list")));
        }
        let count = whole;
        self.check_room(count, count.saturating_mul(item.size() as u64), "a list")?;
        Ok(count as usize)
    }
}

/// What reads the rows of an element.
pub(super) trait RowReader: Send {
    /// Reads the next row.
    fn row(&mut self, data: &mut impl Data) -> Result<(), ReadError>;

    /// Takes the next rows, unless they are beyond a limit or never plain.
    fn take(&mut self, _: &ParsedRows) -> bool {
        false
    }
}

/// Some rows of one size in bytes.
pub(super) struct FixedRows<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) stride: usize,
    /// How many rows there are in all, these included.
    pub(super) in_all: usize,
    pub(super) is_big_endian: bool,
}
