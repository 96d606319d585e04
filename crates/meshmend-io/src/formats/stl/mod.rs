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
mod normals;
mod read_binary;
mod read_text;
mod solid_names;
mod triangles;
mod usual_facets;
mod write;

use std::io::{self, Read};

use meshmend_geometry::rounding::in_single_precision;

use crate::formats::format::Driver;
use crate::read::{Parsed, Source};
use crate::text::{is_space, trimmed_start, without_mark};
use crate::{Encoding, Limits, Place, Prepared, ReadError, ReadErrorKind, WriteErrorKind, rounding_losses};

pub(crate) static DRIVER: Driver = Driver {
    name: "STL",
    extensions: &["stl", "stla", "stlb"],
    encodings: &[Encoding::LittleEndian, Encoding::Ascii],
    holds_polygons: false,
    sniff,
    read,
    read_blocks,
    prepare,
    encode: write::encode,
    losses: write::losses,
};

/// The length of the header and the count of a binary file.
const HEAD: usize = 84;
/// The length of a facet in a binary file.
const FACET: usize = 50;
/// The name of the layer that holds the two bytes after each facet of a binary file.
const ATTRIBUTE: &str = "attribute";
/// The key of metadata that holds the header of a binary file.
const HEADER: &str = "stl-header";
/// The key of metadata that holds the name of a single solid.
const SOLID: &str = "solid";

fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let claimed = read_binary::claimed_length(source.bytes);
    let length = source.bytes.len() as u64;
    let is_text = begins_with_solid(source.bytes) && !is_surely_binary(source.bytes, length);
    if !is_text {
        return match claimed {
            Some(_) => read_binary::read(source, &mut io::empty(), limits),
            None if source.bytes.is_empty() => Err(source.malformed(Place::Byte(0), "the file is empty")),
            None => Err(source.malformed(Place::Byte(length), "neither text nor as long as a binary header")),
        };
    }
    match (read_text::read(source, limits), claimed) {
        (Ok(parsed), _) => Ok(parsed),
        (Err(error), _) if matches!(error.kind, ReadErrorKind::LimitExceeded { .. }) => Err(error),
        (Err(_), Some(claimed)) if claimed <= length => read_binary::read(source, &mut io::empty(), limits),
        (Err(_), Some(_)) if has_binary_count(source.bytes) => {
            read_binary::read(source, &mut io::empty(), limits)
        }
        (Err(error), _) => Err(error),
    }
}

/// What can't be text is read block by block.
fn read_blocks(head: &Source<'_>, rest: &mut dyn Read, limits: &Limits) -> Option<Result<Parsed, ReadError>> {
    let is_binary = !begins_with_solid(head.bytes) || is_surely_binary(head.bytes, head.length as u64);
    is_binary.then(|| read_binary::read(head, rest, limits))
}

/// Text that begins with `solid` and a facet, or binary of exactly the length that it claims.
fn sniff(bytes: &[u8], length: u64) -> bool {
    const START: usize = 1 << 12;
    let is_exact = read_binary::claimed_length(bytes) == Some(length) && bytes.len() > HEAD;
    is_exact || begins_with_solid(bytes) && solid_names::holds_facet(&bytes[..bytes.len().min(START)])
}

/// Rounds positions where they are stored in single precision, so that all else is about what will be read again, and cuts
/// polygons into triangles.
fn prepare(prepared: &mut Prepared) -> Result<(), WriteErrorKind> {
    let rounded =
        if prepared.encoding == Encoding::Ascii { None } else { in_single_precision(&prepared.mesh) };
    if let Some((mesh, rounding)) = rounded {
        let vertices = mesh.counts().vertices;
        prepared.mesh = mesh;
        prepared.losses.extend(rounding_losses(rounding, vertices));
    }
    triangles::cut_polygons(prepared)
}

fn begins_with_solid(bytes: &[u8]) -> bool {
    let start = trimmed_start(without_mark(bytes));
    let word = start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    word && start.get(5).is_none_or(|&next| is_space(next) || next == 0)
}

/// Whether the file, of which the start is at hand, has the length that its count says, and the count is none of text.
fn is_surely_binary(bytes: &[u8], length: u64) -> bool {
    read_binary::claimed_length(bytes) == Some(length) && has_binary_count(bytes)
}

/// Whether the place of the count holds bytes that no text has.
fn has_binary_count(bytes: &[u8]) -> bool {
    bytes[HEAD - 4..HEAD].iter().any(|&b| b < b' ' && !is_space(b))
}

/// What an STL file's writer chose.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct StlShape;
