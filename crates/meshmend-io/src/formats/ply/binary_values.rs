//! Binary values.

use std::io::{self, Read};

use meshmend_core::{Values, counted};

use crate::binary::block_reader::BlockReader;
use crate::formats::ply::data::{Data, FixedRows};
use crate::formats::ply::header::Element;
use crate::formats::ply::scalar::Scalar;
use crate::input::source::Source;
use crate::text::one_or_many;
use crate::{Place, ReadError};

/// Binary values of either byte order.
pub(super) struct BinaryValues<'a, const BIG: bool> {
    source: &'a Source<'a>,
    blocks: BlockReader<'a>,
}

impl<'a, const BIG: bool> BinaryValues<'a, BIG> {
    /// The values from a place on. Bytes that the source does not hold come from `rest`.
    pub(super) fn new(source: &'a Source<'a>, at: usize, rest: &'a mut dyn Read) -> Self {
        BinaryValues { source, blocks: BlockReader::new(source, at, rest) }
    }

    #[inline]
    fn take(&mut self, length: usize) -> Result<&[u8], ReadError> {
        let (source, at) = (self.source, self.blocks.at());
        self.blocks.take(length).map_err(|error| failed(source, at, length, error))
    }
}

/// The error when so many bytes at a place can't be read.
#[cold]
fn failed(source: &Source<'_>, at: usize, length: usize, error: io::Error) -> ReadError {
    if length > source.length - at { cut(source, at, "a value") } else { source.failed(error) }
}

#[cold]
fn cut(source: &Source<'_>, at: usize, what: &str) -> ReadError {
    let left = one_or_many(source.length - at, "byte is", "bytes are");
    let reason = format!("the file ends early: {left} left for {what}");
    source.malformed(Place::Byte(at as u64), reason)
}

impl<const BIG: bool> Data for BinaryValues<'_, BIG> {
    fn at(&self) -> usize {
        self.blocks.at()
    }

    #[cold]
    fn wrong(&self, at: usize, reason: &str) -> ReadError {
        self.source.malformed(Place::Byte(at as u64), reason)
    }

    fn left(&self) -> Option<usize> {
        Some(self.blocks.left())
    }

    #[inline]
    fn check_room(&self, _: u64, bytes: u64, what: &str) -> Result<(), ReadError> {
        if bytes > self.blocks.left() as u64 { Err(cut(self.source, self.at(), what)) } else { Ok(()) }
    }

    #[inline]
    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadError> {
        let bytes = self.take(scalar.size())?;
        Ok(number_at::<BIG>(bytes, scalar))
    }

    fn push(&mut self, scalar: Scalar, values: &mut Values) -> Result<(), ReadError> {
        let bytes = self.take(scalar.size())?;
        FixedRows { bytes, stride: bytes.len(), in_all: 1, is_big_endian: BIG }.extend(values, 0);
        Ok(())
    }

    #[inline]
    fn indices(
        &mut self,
        scalar: Scalar,
        count: usize,
        mut each: impl FnMut(i64, usize),
    ) -> Result<(), ReadError> {
        let (source, size, start) = (self.source, scalar.size(), self.at());
        let bytes = self.take(count.saturating_mul(size))?;
        let places = (start..).step_by(size);
        let rows = bytes.chunks_exact(size).zip(places);
        match scalar {
            Scalar::I8 => rows.for_each(|(b, at)| each(i64::from(i8::from_le_bytes(array::<1, BIG>(b))), at)),
            Scalar::U8 => rows.for_each(|(b, at)| each(i64::from(b[0]), at)),
            Scalar::I16 => {
                rows.for_each(|(b, at)| each(i64::from(i16::from_le_bytes(array::<2, BIG>(b))), at))
            }
            Scalar::U16 => {
                rows.for_each(|(b, at)| each(i64::from(u16::from_le_bytes(array::<2, BIG>(b))), at))
            }
            Scalar::I32 => {
                rows.for_each(|(b, at)| each(i64::from(i32::from_le_bytes(array::<4, BIG>(b))), at))
            }
            Scalar::U32 => {
                rows.for_each(|(b, at)| each(i64::from(u32::from_le_bytes(array::<4, BIG>(b))), at))
            }
            Scalar::F32 | Scalar::F64 => {
                for (bytes, at) in rows {
                    let value = number_at::<BIG>(bytes, scalar);
                    if value.fract() != 0.0 {
                        let reason = format!("{value} where an index belongs");
                        return Err(source.malformed(Place::Byte(at as u64), reason));
                    }
                    each(value as i64, at);
                }
            }
        }
        Ok(())
    }

    fn fixed_rows(
        &mut self,
        element: &Element,
        mut each: impl FnMut(FixedRows<'_>) -> Result<(), ReadError>,
    ) -> Result<bool, ReadError> {
        if element.properties.iter().any(|property| property.length.is_some()) {
            return Ok(false);
        }
        let stride: usize = element.properties.iter().map(|property| property.item.size()).sum();
        self.check_room(0, element.count.saturating_mul(stride as u64), "a value")?;
        let mut left = element.count as usize;
        while left > 0 && stride > 0 {
            let source = self.source;
            let bytes = self.blocks.take_rows(stride, left).map_err(|error| source.failed(error))?;
            left -= bytes.len() / stride;
            each(FixedRows { bytes, stride, in_all: element.count as usize, is_big_endian: BIG })?;
        }
        Ok(true)
    }

    /// An error if the rest of the file is too short for the rows.
    fn begin_element(&mut self, element: &Element) -> Result<(), ReadError> {
        let least: usize = element.properties.iter().map(|p| p.length.unwrap_or(p.item).size()).sum();
        let what = format!("{} of element `{}`", counted(element.count, "row"), element.name);
        self.check_room(0, element.count.saturating_mul(least as u64), &what)
    }

    fn surplus(&self) -> (usize, usize) {
        (self.blocks.left(), self.at())
    }
}

impl FixedRows<'_> {
    /// Appends the values that begin at an offset of each row.
    pub(super) fn extend(&self, values: &mut Values, offset: usize) {
        match self.is_big_endian {
            true => self.extend_from::<true>(values, offset),
            false => self.extend_from::<false>(values, offset),
        }
    }

    /// Appends three numbers of each row, each with its type and offset.
    pub(super) fn extend_points(&self, points: &mut Vec<[f64; 3]>, columns: [(Scalar, usize); 3]) {
        match self.is_big_endian {
            true => self.extend_points_from::<true>(points, columns),
            false => self.extend_points_from::<false>(points, columns),
        }
    }

    fn extend_from<const BIG: bool>(&self, values: &mut Values, at: usize) {
        match values {
            Values::I8(v) => self.append(v, |row| i8::from_le_bytes(array::<1, BIG>(&row[at..]))),
            Values::U8(v) => self.append(v, |row| row[at]),
            Values::I16(v) => self.append(v, |row| i16::from_le_bytes(array::<2, BIG>(&row[at..]))),
            Values::U16(v) => self.append(v, |row| u16::from_le_bytes(array::<2, BIG>(&row[at..]))),
            Values::I32(v) => self.append(v, |row| i32::from_le_bytes(array::<4, BIG>(&row[at..]))),
            Values::U32(v) => self.append(v, |row| u32::from_le_bytes(array::<4, BIG>(&row[at..]))),
            Values::F32(v) => self.append(v, |row| f32::from_le_bytes(array::<4, BIG>(&row[at..]))),
            Values::F64(v) => self.append(v, |row| f64::from_le_bytes(array::<8, BIG>(&row[at..]))),
            Values::Text(_) | Values::Lists { .. } => {}
        }
    }

    fn extend_points_from<const BIG: bool>(&self, points: &mut Vec<[f64; 3]>, columns: [(Scalar, usize); 3]) {
        let offsets = columns.map(|(_, offset)| offset);
        match columns.map(|(scalar, _)| scalar) {
            [Scalar::F32, Scalar::F32, Scalar::F32] => {
                let single = |bytes: &[u8]| f64::from(f32::from_le_bytes(array::<4, BIG>(bytes)));
                self.append(points, |row| offsets.map(|at| single(&row[at..])));
            }
            [Scalar::F64, Scalar::F64, Scalar::F64] => {
                let double = |bytes: &[u8]| f64::from_le_bytes(array::<8, BIG>(bytes));
                self.append(points, |row| offsets.map(|at| double(&row[at..])));
            }
            _ => self.append(points, |row| columns.map(|(scalar, at)| number_at::<BIG>(&row[at..], scalar))),
        }
    }

    /// Appends a value of each row. The first block makes room for all rows.
    fn append<T>(&self, values: &mut Vec<T>, of_row: impl Fn(&[u8]) -> T) {
        if values.is_empty() {
            values.reserve_exact(self.in_all);
        }
        values.extend(self.bytes.chunks_exact(self.stride).map(of_row));
    }
}

/// Some bytes at the start of a slice, the lowest first.
#[inline]
fn array<const N: usize, const BIG: bool>(bytes: &[u8]) -> [u8; N] {
    let mut array = [0; N];
    array.copy_from_slice(&bytes[..N]);
    if BIG {
        array.reverse();
    }
    array
}

#[inline]
fn number_at<const BIG: bool>(bytes: &[u8], scalar: Scalar) -> f64 {
    match scalar {
        Scalar::I8 => f64::from(i8::from_le_bytes(array::<1, BIG>(bytes))),
        Scalar::U8 => f64::from(bytes[0]),
        Scalar::I16 => f64::from(i16::from_le_bytes(array::<2, BIG>(bytes))),
        Scalar::U16 => f64::from(u16::from_le_bytes(array::<2, BIG>(bytes))),
        Scalar::I32 => f64::from(i32::from_le_bytes(array::<4, BIG>(bytes))),
        Scalar::U32 => f64::from(u32::from_le_bytes(array::<4, BIG>(bytes))),
        Scalar::F32 => f64::from(f32::from_le_bytes(array::<4, BIG>(bytes))),
        Scalar::F64 => f64::from_le_bytes(array::<8, BIG>(bytes)),
    }
}
