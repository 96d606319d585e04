//! Arrays in the page's data: base64 of little-endian numbers of four bytes.

use meshmend::formats::base64;
use serde::{Serialize, Serializer};

/// An array of numbers of four bytes each.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Packed {
    Floats(Vec<f32>),
    Numbers(Vec<u32>),
}

impl Packed {
    fn bytes(&self) -> Vec<u8> {
        match self {
            Packed::Floats(floats) => floats.iter().flat_map(|float| float.to_le_bytes()).collect(),
            Packed::Numbers(numbers) => numbers.iter().flat_map(|number| number.to_le_bytes()).collect(),
        }
    }
}

impl FromIterator<u32> for Packed {
    fn from_iter<I: IntoIterator<Item = u32>>(numbers: I) -> Self {
        Packed::Numbers(numbers.into_iter().collect())
    }
}

impl Serialize for Packed {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&base64(&self.bytes()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_little_endian() {
        let json = |packed: Packed| serde_json::to_string(&packed).unwrap();
        assert_eq!(json([1_u32, 0x0302_0100].into_iter().collect()), r#""AQAAAAABAgM=""#);
        assert_eq!(json(Packed::Floats(vec![1.0])), r#""AACAPw==""#);
    }
}
