//! What is known of a format before any file is read or written.

use crate::Encoding;

/// The facts about a format. They import none of its code, so that errors and options can name a format.
pub(crate) struct Facts {
    /// The usual name, such as `OBJ`.
    pub(crate) name: &'static str,
    /// The file name extensions, in lower case and without the dot; the usual one first.
    pub(crate) extensions: &'static [&'static str],
    /// The encodings in which files are written, the default first.
    pub(crate) encodings: &'static [Encoding],
    /// What a file with its numbers spelled so is called in reports.
    pub(crate) variant: fn(Encoding) -> &'static str,
    /// Whether faces may have more than three corners.
    pub(crate) holds_polygons: bool,
    /// Whether faces name vertices by index, so that several faces can share one.
    pub(crate) has_indices: bool,
    /// Where texture coordinates count from.
    pub(crate) texture_origin: TextureOrigin,
    /// Whether a file that starts with these bytes, and has so many in all, is surely of this format, whatever its
    /// name.
    pub(crate) sniff: fn(&[u8], u64) -> bool,
}

/// The corner of a picture whose texture coordinates are 0 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextureOrigin {
    /// The lower left one.
    LowerLeft,
    /// The upper left one.
    UpperLeft,
}
