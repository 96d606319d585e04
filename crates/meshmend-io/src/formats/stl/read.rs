//! The STL reader: text or binary.

use std::io::{self, Read};

use crate::formats::stl::form::{begins_with_solid, claimed_length, has_binary_count, is_surely_binary};
use crate::formats::stl::{read_binary, read_text};
use crate::input::source::{Parsed, Source};
use crate::input::streamed::{MeshSink, Rows};
use crate::{Limits, Place, ReadError, ReadErrorKind};

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let claimed = claimed_length(source.bytes);
    let length = source.bytes.len() as u64;
    let is_text = begins_with_solid(source.bytes) && !is_surely_binary(source.bytes, length);
    if !is_text {
        return match claimed {
            Some(_) => read_binary::read(source, &mut io::empty(), limits),
            None => Err(too_short(source)),
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

/// Reads what can't be text, block by block.
pub(super) fn read_blocks(
    head: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
) -> Option<Result<Parsed, ReadError>> {
    is_binary(head).then(|| read_binary::read(head, rest, limits))
}

/// Hands over the facets of what can't be text.
pub(super) fn stream(
    head: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
    sink: &mut dyn MeshSink,
) -> Option<Result<Rows, ReadError>> {
    is_binary(head).then(|| match claimed_length(head.bytes) {
        Some(_) => read_binary::stream(head, rest, limits, sink),
        None => Err(too_short(head)),
    })
}

/// The error of what is neither text nor has the header of a binary file.
fn too_short(source: &Source<'_>) -> ReadError {
    let (length, is_empty) = (source.bytes.len() as u64, source.bytes.is_empty());
    let reason = if is_empty { "the file is empty" } else { "neither text nor as long as a binary header" };
    source.malformed(Place::Byte(length), reason)
}

/// Whether a file with this head can't be text.
fn is_binary(head: &Source<'_>) -> bool {
    !begins_with_solid(head.bytes) || is_surely_binary(head.bytes, head.length as u64)
}
