//! The STL reader: text or binary.

use std::io::{self, Read};

use crate::formats::stl::form::{begins_with_solid, claimed_length, has_binary_count, is_surely_binary};
use crate::formats::stl::{read_binary, read_text};
use crate::input::source::{Parsed, Source};
use crate::{Limits, Place, ReadError, ReadErrorKind};

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let claimed = claimed_length(source.bytes);
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

/// Reads what can't be text, block by block.
pub(super) fn read_blocks(
    head: &Source<'_>,
    rest: &mut dyn Read,
    limits: &Limits,
) -> Option<Result<Parsed, ReadError>> {
    let is_binary = !begins_with_solid(head.bytes) || is_surely_binary(head.bytes, head.length as u64);
    is_binary.then(|| read_binary::read(head, rest, limits))
}
