//! How files spell their numbers.

use std::fmt;

use serde::Serialize;

/// How a file spells its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Encoding {
    /// As text.
    Ascii,
    /// As binary numbers, the lowest byte first.
    LittleEndian,
    /// As binary numbers, the highest byte first.
    BigEndian,
}

impl Encoding {
    /// Every encoding.
    pub const ALL: &'static [Encoding] = &[Encoding::Ascii, Encoding::LittleEndian, Encoding::BigEndian];

    /// Its name: `ascii`, `little-endian` or `big-endian`.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::Ascii => "ascii",
            Encoding::LittleEndian => "little-endian",
            Encoding::BigEndian => "big-endian",
        }
    }
}

impl fmt::Display for Encoding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
