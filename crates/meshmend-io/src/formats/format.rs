//! The registry of formats.

use std::fmt;
use std::io;
use std::path::Path;

use serde::Serialize;

use crate::read::{Parsed, Source};
use crate::{Limits, Loss, Prepared, ReadError, WriteErrorKind};

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

/// What a format's reader found, or why it gave up.
pub(crate) type ReadResult = Result<Parsed, ReadError>;

/// What a format's module gives to the registry.
pub(crate) struct Driver {
    pub(crate) name: &'static str,
    pub(crate) extensions: &'static [&'static str],
    /// What is written, the default first.
    pub(crate) encodings: &'static [Encoding],
    /// Whether faces may have more than three corners.
    pub(crate) holds_polygons: bool,
    /// Whether a file that starts like this, and has so many bytes in all, is surely of this format, whatever its name.
    pub(crate) sniff: fn(&[u8], u64) -> bool,
    pub(crate) read: fn(&Source<'_>, &Limits) -> ReadResult,
    /// Reads a source of which only the start is at hand and the rest comes as it is asked for; nothing, and nothing taken
    /// from the rest, where all has to be at hand.
    pub(crate) read_blocks: fn(&Source<'_>, &mut dyn io::Read, &Limits) -> Option<ReadResult>,
    /// Makes a mesh what the format can hold, and names what that loses; every other mesh stays as it is.
    pub(crate) prepare: fn(&mut Prepared) -> Result<(), WriteErrorKind>,
    pub(crate) encode: fn(&Prepared, &mut dyn io::Write) -> Result<(), WriteErrorKind>,
    /// What else the file won't carry.
    pub(crate) losses: fn(&Prepared) -> Vec<Loss>,
}

macro_rules! formats {
    ($($(#[$doc:meta])* $format:ident => $driver:path,)*) => {
        /// A file format that is read and written.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
        #[serde(rename_all = "kebab-case")]
        #[non_exhaustive]
        pub enum Format {
            $($(#[$doc])* $format,)*
        }

        impl Format {
            /// Every format.
            pub const ALL: &'static [Format] = &[$(Format::$format,)*];

            pub(crate) fn driver(self) -> &'static Driver {
                match self {
                    $(Format::$format => &$driver,)*
                }
            }
        }
    };
}

formats! {
    /// Wavefront OBJ.
    Obj => crate::formats::obj::DRIVER,
    /// Polygon file format, also called Stanford triangle format.
    Ply => crate::formats::ply::DRIVER,
    /// Stereolithography: triangles without indices.
    Stl => crate::formats::stl::DRIVER,
    /// Object file format of Geomview.
    Off => crate::formats::off::DRIVER,
}

impl Format {
    /// Its usual name, such as `OBJ`.
    pub fn name(self) -> &'static str {
        self.driver().name
    }

    /// The file name extensions that stand for it, in lower case and without the dot; the usual one first.
    pub fn extensions(self) -> &'static [&'static str] {
        self.driver().extensions
    }

    /// The encodings in which it is written, the default first.
    pub fn encodings(self) -> &'static [Encoding] {
        self.driver().encodings
    }

    /// Whether faces may have more than three corners; else the writer cuts them, which is a named loss.
    pub fn holds_polygons(self) -> bool {
        self.driver().holds_polygons
    }

    /// The format of an extension, in any case and without the dot.
    pub fn from_extension(extension: &str) -> Option<Format> {
        let stands_for =
            |format: &&Format| format.extensions().iter().any(|e| e.eq_ignore_ascii_case(extension));
        Format::ALL.iter().find(stands_for).copied()
    }

    /// The format of a file name's extension.
    pub fn from_path(path: &Path) -> Option<Format> {
        path.extension().and_then(|extension| extension.to_str()).and_then(Format::from_extension)
    }

    /// The format that content surely has, whatever the file is called.
    pub fn from_content(bytes: &[u8]) -> Option<Format> {
        Format::from_head(bytes, bytes.len() as u64)
    }

    /// The format that content surely has that starts so, and has so many bytes in all.
    pub(crate) fn from_head(head: &[u8], length: u64) -> Option<Format> {
        Format::ALL.iter().find(|format| (format.driver().sniff)(head, length)).copied()
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
