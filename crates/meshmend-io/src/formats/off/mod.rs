//! OFF: text with counts, then one vertex a line, then one face a line.
//!
//! | header | vertices have |
//! |---|---|
//! | `OFF` | three coordinates |
//! | with `N` in front | a normal too: vertex layer `normal` |
//! | with `C` in front | a colour too: vertex layer `color` |
//! | with `ST` in front | a texture coordinate too: vertex layer `texcoord` |
//!
//! A texture coordinate is written only where there is neither normal nor colour, or the file was read so: many programs
//! don't read such headers. Colours of vertices are written with four numbers, as some programs read no others.
//!
//! What follows a face's indices is its colour: face layer `color`, or `color_index` where all are single numbers.
//! Colours of three or four bytes each are kept as bytes; one number with a point makes the colours of the file
//! fractions; any others are kept as the text that they are. `#` begins a comment, also at the end of a line; comments
//! are metadata.
//!
//! **As it is written.** The word may be missing or have the first count glued to it, the number of edges may be missing,
//! and colours may stand before normals, which is MeshLab's order and told by the values. Vertices and faces may stand on
//! lines in any way, if the file then comes out even; only colours of faces are bound to lines. All of this is noted.
//! Files of four or n dimensions, or binary, are errors; lines after the last face are skipped and noted.

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
    look_beside: Driver::names_no_files,
    prepare: write::prepare,
    encode: write::encode,
    losses: write::losses,
};
