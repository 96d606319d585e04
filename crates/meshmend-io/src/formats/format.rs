//! The formats as values: their names, extensions and encodings.

use std::fmt;
use std::path::Path;

use serde::Serialize;

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};

macro_rules! variants {
    ($($(#[doc = $doc:literal])* $(#[cfg($only:meta)])? $format:ident => $folder:ident,)*) => {
        /// A file format that is read and written.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
        #[serde(rename_all = "kebab-case")]
        #[non_exhaustive]
        pub enum Format {
            $($(#[doc = $doc])* $(#[cfg($only)])? $format,)*
        }

        impl Format {
            /// Every format.
            pub const ALL: &'static [Format] = &[$($(#[cfg($only)])? Format::$format,)*];

            fn facts(self) -> &'static Facts {
                match self {
                    $($(#[cfg($only)])? Format::$format => &crate::formats::$folder::facts::FACTS,)*
                }
            }
        }
    };
}

with_formats!(variants);

impl Format {
    /// Its usual name, such as `OBJ`.
    pub fn name(self) -> &'static str {
        self.facts().name
    }

    /// Its file name extensions, in lower case and without the dot; the usual one first.
    pub fn extensions(self) -> &'static [&'static str] {
        self.facts().extensions
    }

    /// The encodings in which it is written, the default first.
    pub fn encodings(self) -> &'static [Encoding] {
        self.facts().encodings
    }

    /// What reports call a file of this format whose numbers are spelled so, such as `ply-le`.
    pub fn variant(self, encoding: Encoding) -> &'static str {
        (self.facts().variant)(encoding)
    }

    /// Whether faces may have more than three corners. If not, the writer cuts them, and a loss names that.
    pub fn holds_polygons(self) -> bool {
        self.facts().holds_polygons
    }

    /// Whether faces name vertices by index; else each face has vertices of its own, and only their places tell them
    /// apart.
    pub fn has_indices(self) -> bool {
        self.facts().has_indices
    }

    /// The corner of a picture that its texture coordinates count from.
    pub fn texture_origin(self) -> TextureOrigin {
        self.facts().texture_origin
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

    /// The format of content that is unmistakable, whatever the name of the file is.
    pub fn from_content(bytes: &[u8]) -> Option<Format> {
        Format::from_head(bytes, bytes.len() as u64)
    }

    /// The format of unmistakable content that starts with these bytes and has so many in all.
    pub(crate) fn from_head(head: &[u8], length: u64) -> Option<Format> {
        Format::ALL.iter().copied().find(|format| format.is_surely(head, length))
    }

    /// Whether content that starts with these bytes, and has so many in all, is surely of this format.
    pub(crate) fn is_surely(self, head: &[u8], length: u64) -> bool {
        (self.facts().sniff)(head, length)
    }

    /// The names of all formats, for messages: `OBJ, PLY, …`.
    pub(crate) fn names() -> String {
        let names: Vec<&str> = Format::ALL.iter().map(|format| format.name()).collect();
        names.join(", ")
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
