//! Arrays under their names, as JSON has them.

use serde::ser::SerializeSeq;
use serde::{Serialize, Serializer};

/// An array under its name.
#[derive(Clone, Debug)]
pub(super) struct Array {
    pub(super) name: String,
    /// How many values there are in a row.
    pub(super) width: usize,
    pub(super) values: Values,
}

#[derive(Clone, Debug)]
pub(super) enum Values {
    Integers(Vec<i64>),
    Bytes(Vec<u8>),
    Words(&'static [&'static str]),
}

impl Serialize for Array {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.values {
            Values::Integers(values) if self.width > 1 => {
                let mut rows = serializer.serialize_seq(Some(values.len() / self.width))?;
                values.chunks_exact(self.width).try_for_each(|row| rows.serialize_element(row))?;
                rows.end()
            }
            Values::Integers(values) => values.serialize(serializer),
            Values::Bytes(values) => values.serialize(serializer),
            Values::Words(words) => words.serialize(serializer),
        }
    }
}
