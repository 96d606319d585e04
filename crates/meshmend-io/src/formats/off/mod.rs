//! OFF: text with counts, then one vertex a line, then one face a line.
//!
//! | header | vertices have |
//! |---|---|
//! | `OFF` | three coordinates |
//! | with `N` in front | a normal too: vertex layer `normal` |
//! | with `C` in front | a colour too: vertex layer `color` |
//! | with `ST` in front | a texture coordinate too: vertex layer `texcoord` |
//!
//! A texture coordinate is written only if there is neither normal nor colour, or if the input had it so: many
//! programs don't read other headers. Colours of vertices are written with four numbers, as some programs read no
//! others.
//!
//! The colour of a face follows its indices: face layer `color`, or `color_index` if all are single numbers. Colours
//! of three or four bytes each are kept as bytes. If one number has a point, the colours of the file are fractions.
//! All others are kept as text. `#` begins a comment, also at the end of a line; comments are metadata.
//!
//! **What programs write.** The word may be missing, or the first count may follow it without a blank. The number of
//! edges may be missing. Colours may stand before normals, which is the order of MeshLab and follows from the values.
//! Line breaks may be anywhere between numbers if the file is used up so; only colours of faces depend on lines.
//! Notes name all of this. Files of four or n dimensions and binary files are errors. Lines after the last face are
//! skipped, with a note.

mod across_lines;
mod colors;
pub(crate) mod facts;
mod header;
mod letters;
mod read;
mod reader;
mod sections;
mod shape;
mod usual_lines;
mod vertex_attributes;
mod write;

use crate::formats::driver::Driver;

pub(crate) static DRIVER: Driver = Driver {
    read: read::read,
    read_blocks: Driver::needs_whole_file,
    stream: Driver::streams_nothing,
    look_beside: Driver::names_no_files,
    prepare: write::prepare,
    encode: write::encode,
    losses: write::losses,
};
