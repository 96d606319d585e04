//! STL: facets with three coordinates a corner, as text or binary; no indices.
//!
//! Each facet has vertices of its own: nothing is welded here. Coordinates are doubles in text, and single precision in
//! binary files. Stored normals are computed afresh when written; those that point elsewhere are noted.
//!
//! **Which form.** A file of exactly 84 + 50 n bytes for its own count n is binary, whatever its header says, if the
//! bytes of the count are none of text. Any other file that begins with `solid` is text, unless it does not read as
//! such and has room for the facets that its count says. Anything else is binary.
//!
//! **Binary.** Fewer bytes than the count says are an error; so is room for one more facet or beyond, as the
//! count then hides facets. Fewer surplus bytes are skipped and noted. The header is metadata, without the zeros at its
//! end; it is written to the byte. The two bytes that end each facet are the face layer `attribute` if one of them is
//! not 0; they may be colours (`colors.rs`).
//!
//! **Text.** Words in any case, parted by any blanks and line ends. A facet with more than three vertices is a
//! polygon; with fewer it is an error. Polygons are cut into triangles, as the repair cuts them, before they are
//! written. The name of a single solid is metadata `solid`; different ones of several solids are the face layer `object`.
//! Names may hold any words (`names.rs`). A missing `endsolid` after a whole facet is noted.

pub(crate) mod colors;
pub(crate) mod facts;
mod form;
mod normals;
mod prepare;
mod read;
mod read_binary;
mod read_text;
mod solid_names;
mod triangles;
mod usual_facets;
mod write;

use crate::formats::driver::Driver;

pub(crate) static DRIVER: Driver = Driver {
    read: read::read,
    read_blocks: read::read_blocks,
    look_beside: Driver::names_no_files,
    prepare: prepare::prepare,
    encode: write::encode,
    losses: write::losses,
};
