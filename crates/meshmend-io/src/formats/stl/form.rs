//! Which form a file has, text or binary, and the measures of the binary form.

use crate::text::{is_space, trimmed_start, without_mark};

/// The length of the header and the count of a binary file.
pub(super) const HEAD: usize = 84;
/// The length of a facet in a binary file.
pub(super) const FACET: usize = 50;
/// The name of the layer that holds the two bytes after each facet of a binary file.
pub(super) const ATTRIBUTE: &str = "attribute";
/// The key of metadata that holds the header of a binary file.
pub(super) const HEADER: &str = "stl-header";
/// The key of metadata that holds the name of a single solid.
pub(super) const SOLID: &str = "solid";

/// The length that the file has if its count is right, or `None` if it is too short to have a count.
pub(super) fn claimed_length(bytes: &[u8]) -> Option<u64> {
    bytes.get(HEAD - 4..HEAD).map(|count| HEAD as u64 + FACET as u64 * u64::from(little_endian(count)))
}

pub(super) fn little_endian(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |value, &byte| value << 8 | u32::from(byte))
}

pub(super) fn begins_with_solid(bytes: &[u8]) -> bool {
    let start = trimmed_start(without_mark(bytes));
    let word = start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    word && start.get(5).is_none_or(|&next| is_space(next) || next == 0)
}

/// Whether a file that starts with these bytes has the length that its count says, and the bytes of the count are not
/// text.
pub(super) fn is_surely_binary(bytes: &[u8], length: u64) -> bool {
    claimed_length(bytes) == Some(length) && has_binary_count(bytes)
}

/// Whether the place of the count has bytes that do not occur in text.
pub(super) fn has_binary_count(bytes: &[u8]) -> bool {
    bytes[HEAD - 4..HEAD].iter().any(|&b| b < b' ' && !is_space(b))
}
