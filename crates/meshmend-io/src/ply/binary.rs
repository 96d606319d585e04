//! Binary values.

use meshmend_core::Values;

use crate::ply::data::{Data, FixedRows};
use crate::ply::header::Element;
use crate::ply::scalar::Scalar;
use crate::read::Source;
use crate::{Place, ReadError};

/// Binary values of either byte order.
pub(super) struct Binary<'a, const BIG: bool> {
    source: &'a Source<'a>,
    at: usize,
}

impl<'a, const BIG: bool> Binary<'a, BIG> {
    pub(super) fn new(source: &'a Source<'a>, at: usize) -> Self {
        Binary { source, at }
    }

    #[inline]
    fn take(&mut self, length: usize) -> Result<&'a [u8], ReadError> {
        match self.source.bytes[self.at..].get(..length) {
            Some(bytes) => {
                self.at += length;
                Ok(bytes)
            }
            None => Err(self.cut("a value")),
        }
    }

    #[cold]
    fn cut(&self, what: &str) -> ReadError {
        let left = self.source.bytes.len() - self.at;
        self.wrong(self.at, &format!("the file ends early: {left} bytes are left for {what}"))
    }
}

impl<const BIG: bool> Data for Binary<'_, BIG> {
    fn at(&self) -> usize {
        self.at
    }

    #[cold]
    fn wrong(&self, at: usize, reason: &str) -> ReadError {
        self.source.malformed(Place::Byte(at as u64), reason)
    }

    #[inline]
    fn check_room(&self, _: u64, bytes: u64, what: &str) -> Result<(), ReadError> {
        if bytes > (self.source.bytes.len() - self.at) as u64 { Err(self.cut(what)) } else { Ok(()) }
    }

    #[inline]
    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadError> {
        let bytes = self.take(scalar.size())?;
        Ok(number_at::<BIG>(bytes, scalar))
    }

    fn push(&mut self, scalar: Scalar, values: &mut Values) -> Result<(), ReadError> {
        let bytes = self.take(scalar.size())?;
        extend::<BIG>(values, bytes, bytes.len(), 0);
        Ok(())
    }

    #[inline]
    fn indices(
        &mut self,
        scalar: Scalar,
        count: usize,
        mut each: impl FnMut(i64, usize),
    ) -> Result<(), ReadError> {
        let (size, start) = (scalar.size(), self.at);
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
                        return Err(self.wrong(at, &format!("{value} where an index belongs")));
                    }
                    each(value as i64, at);
                }
            }
        }
        Ok(())
    }

    fn fixed_rows(&mut self, element: &Element) -> Result<Option<FixedRows<'_>>, ReadError> {
        if element.properties.iter().any(|property| property.length.is_some()) {
            return Ok(None);
        }
        let stride: usize = element.properties.iter().map(|property| property.item.size()).sum();
        let bytes = self.take((element.count as usize).saturating_mul(stride))?;
        Ok(Some(FixedRows { bytes, stride, is_big_endian: BIG }))
    }

    fn surplus(&self) -> (usize, usize) {
        (self.source.bytes.len() - self.at, self.at)
    }
}

impl FixedRows<'_> {
    /// Appends the values that begin at an offset of each row.
    pub(super) fn extend(&self, values: &mut Values, offset: usize) {
        match self.is_big_endian {
            true => extend::<true>(values, self.bytes, self.stride, offset),
            false => extend::<false>(values, self.bytes, self.stride, offset),
        }
    }

    /// Three numbers of each row, each with its type and offset.
    pub(super) fn points(&self, columns: [(Scalar, usize); 3]) -> Vec<[f64; 3]> {
        match self.is_big_endian {
            true => points::<true>(self.bytes, self.stride, columns),
            false => points::<false>(self.bytes, self.stride, columns),
        }
    }
}

fn points<const BIG: bool>(bytes: &[u8], stride: usize, columns: [(Scalar, usize); 3]) -> Vec<[f64; 3]> {
    let rows = bytes.chunks_exact(stride);
    let offsets = columns.map(|(_, offset)| offset);
    match columns.map(|(scalar, _)| scalar) {
        [Scalar::F32, Scalar::F32, Scalar::F32] => {
            let single = |row: &[u8], at: usize| f64::from(f32::from_le_bytes(array::<4, BIG>(&row[at..])));
            rows.map(|row| offsets.map(|at| single(row, at))).collect()
        }
        [Scalar::F64, Scalar::F64, Scalar::F64] => {
            let double = |row: &[u8], at: usize| f64::from_le_bytes(array::<8, BIG>(&row[at..]));
            rows.map(|row| offsets.map(|at| double(row, at))).collect()
        }
        _ => rows.map(|row| columns.map(|(scalar, at)| number_at::<BIG>(&row[at..], scalar))).collect(),
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

fn extend<const BIG: bool>(values: &mut Values, bytes: &[u8], stride: usize, offset: usize) {
    let rows = bytes.chunks_exact(stride).map(|row| &row[offset..]);
    match values {
        Values::I8(v) => v.extend(rows.map(|row| i8::from_le_bytes(array::<1, BIG>(row)))),
        Values::U8(v) => v.extend(rows.map(|row| row[0])),
        Values::I16(v) => v.extend(rows.map(|row| i16::from_le_bytes(array::<2, BIG>(row)))),
        Values::U16(v) => v.extend(rows.map(|row| u16::from_le_bytes(array::<2, BIG>(row)))),
        Values::I32(v) => v.extend(rows.map(|row| i32::from_le_bytes(array::<4, BIG>(row)))),
        Values::U32(v) => v.extend(rows.map(|row| u32::from_le_bytes(array::<4, BIG>(row)))),
        Values::F32(v) => v.extend(rows.map(|row| f32::from_le_bytes(array::<4, BIG>(row)))),
        Values::F64(v) => v.extend(rows.map(|row| f64::from_le_bytes(array::<8, BIG>(row)))),
        Values::Text(_) | Values::Lists { .. } => {}
    }
}
