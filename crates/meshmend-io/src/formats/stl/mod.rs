//! STL: facets with three coordinates a corner, as text or binary; no indices.
//!
//! Each facet has vertices of its own, as the reader does not weld. Coordinates are doubles in text, and single
//! numbers in binary files. A writer computes normals from the corners. Stored normals that point elsewhere are
//! noted.
//!
//! **Which form.** A file of exactly 84 + 50 n bytes for its own count n is binary, whatever its header says, if the
//! bytes of the count are not text. Any other file that begins with `solid` is text, unless it can't be read as text
//! and has room for the facets of its count. All other files are binary.
//!
//! **Binary.** It is an error if the file has fewer bytes than the count says, or room for another facet, which the
//! count would hide. Fewer surplus bytes are skipped, with a note. The header without the zeros at its end is
//! metadata; it is written to the byte. The two bytes that end each facet are the face layer `attribute` if one of
//! them is not 0. They may be colours (`colors.rs`).
//!
//! **Text.** Words may have any case, and any blanks and line ends between them. A facet with more than three
//! vertices is a polygon; one with fewer is an error. Polygons are cut into triangles, as the repair cuts them,
//! before they are written. The name of a single solid is metadata `solid`. The names of several solids are the face
//! layer `object` if they differ. Names may have any words (`solid_names.rs`). A missing `endsolid` after a whole
//! facet is noted.

pub(crate) mod colors;
pub(crate) mod facts;
mod form;
mod normals;
mod prepare;
mod read;
mod read_binary;
mod read_text;
mod solid_names;
mod usual_facets;
mod write;

use crate::formats::driver::Driver;

pub(crate) static DRIVER: Driver = Driver {
    read: read::read,
    read_blocks: read::read_blocks,
    stream: read::stream,
    look_beside: Driver::names_no_files,
    prepare: prepare::prepare,
    encode: write::encode,
    losses: write::losses,
};
