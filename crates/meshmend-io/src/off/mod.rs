//! OFF: text with counts, then one vertex a line, then one face a line.
//!
//! | header | vertices have |
//! |---|---|
//! | `OFF` | three coordinates |
//! | with `N` in front | a normal too: vertex layer `normal` |
//! | with `C` in front | a colour too: vertex layer `color` |
//! | with `ST` in front | a texture coordinate too: vertex layer `texcoord` |
//!
//! A texture coordinate is written only where there is neither normal nor colour: many programs don't read such
//! headers.
//!
//! What follows a face's indices is its colour: face layer `color`. Colours of three or four bytes each are kept
//! as bytes, of three or four fractions each as fractions, any others as the text that they are. `#` begins a
//! comment; whole lines of comment are metadata. A file without the word `OFF`, of four or n dimensions, or
//! binary is an error; lines after the last face are skipped and noted.

mod blocks;
mod colors;
mod lines;
mod read;
mod write;

use crate::Encoding;
use crate::format::Driver;
use crate::text::word;

pub(crate) static DRIVER: Driver = Driver {
    name: "OFF",
    extensions: &["off", "coff", "noff", "cnoff", "stoff"],
    encodings: &[Encoding::Ascii],
    holds_polygons: true,
    sniff: |bytes| read::Columns::of_header(word(bytes, 0)).is_some(),
    read: read::read,
    read_blocks: |_, _, _| None,
    prepare: |_| {},
    encode: write::encode,
    losses: write::losses,
};

/// What an OFF file's writer chose.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct OffShape;
