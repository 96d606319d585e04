//! The eight types of numbers.

use meshmend_core::Values;

/// A type of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// Every type with its two names, the old one first, and its size.
const TYPES: [(Scalar, &str, &str, usize); 8] = [
    (Scalar::I8, "char", "int8", 1),
    (Scalar::U8, "uchar", "uint8", 1),
    (Scalar::I16, "short", "int16", 2),
    (Scalar::U16, "ushort", "uint16", 2),
    (Scalar::I32, "int", "int32", 4),
    (Scalar::U32, "uint", "uint32", 4),
    (Scalar::F32, "float", "float32", 4),
    (Scalar::F64, "double", "float64", 8),
];

impl Scalar {
    pub(super) fn from_name(name: &[u8]) -> Option<Scalar> {
        let is_named = |(_, old, new, _): &&(Scalar, &str, &str, usize)| {
            name == old.as_bytes() || name == new.as_bytes()
        };
        TYPES.iter().find(is_named).map(|&(scalar, ..)| scalar)
    }

    pub(super) fn name(self) -> &'static str {
        TYPES[self as usize].1
    }

    pub(super) fn size(self) -> usize {
        TYPES[self as usize].3
    }

    pub(super) fn has_fractions(self) -> bool {
        matches!(self, Scalar::F32 | Scalar::F64)
    }

    /// The least and the greatest whole number of the type.
    pub(super) fn range(self) -> (i64, i64) {
        match self {
            Scalar::I8 => (i64::from(i8::MIN), i64::from(i8::MAX)),
            Scalar::U8 => (0, i64::from(u8::MAX)),
            Scalar::I16 => (i64::from(i16::MIN), i64::from(i16::MAX)),
            Scalar::U16 => (0, i64::from(u16::MAX)),
            Scalar::I32 => (i64::from(i32::MIN), i64::from(i32::MAX)),
            Scalar::U32 => (0, i64::from(u32::MAX)),
            Scalar::F32 | Scalar::F64 => (i64::MIN, i64::MAX),
        }
    }

    /// No values of the type.
    pub(super) fn empty(self) -> Values {
        match self {
            Scalar::I8 => Values::I8(Vec::new()),
            Scalar::U8 => Values::U8(Vec::new()),
            Scalar::I16 => Values::I16(Vec::new()),
            Scalar::U16 => Values::U16(Vec::new()),
            Scalar::I32 => Values::I32(Vec::new()),
            Scalar::U32 => Values::U32(Vec::new()),
            Scalar::F32 => Values::F32(Vec::new()),
            Scalar::F64 => Values::F64(Vec::new()),
        }
    }

    /// The type of some values, if they are numbers.
    pub(super) fn of(values: &Values) -> Option<Scalar> {
        Some(match values {
            Values::I8(_) => Scalar::I8,
            Values::U8(_) => Scalar::U8,
            Values::I16(_) => Scalar::I16,
            Values::U16(_) => Scalar::U16,
            Values::I32(_) => Scalar::I32,
            Values::U32(_) => Scalar::U32,
            Values::F32(_) => Scalar::F32,
            Values::F64(_) => Scalar::F64,
            Values::Text(_) | Values::Lists { .. } => return None,
        })
    }

    /// The smallest unsigned type that can count so far.
    pub(super) fn counting(most: usize) -> Scalar {
        match most {
            0..=0xff => Scalar::U8,
            0x100..=0xffff => Scalar::U16,
            _ => Scalar::U32,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_type_is_found_by_both_names_and_by_its_place() {
        for (scalar, old, new, size) in TYPES {
            assert_eq!(Scalar::from_name(old.as_bytes()), Some(scalar));
            assert_eq!(Scalar::from_name(new.as_bytes()), Some(scalar));
            assert_eq!((scalar.name(), scalar.size()), (old, size));
            assert_eq!(Scalar::of(&scalar.empty()), Some(scalar));
        }
        assert_eq!(Scalar::from_name(b"long"), None);
    }
}
