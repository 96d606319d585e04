//! The attributes of a tag, with the places of their values.

use std::borrow::Cow;
use std::ops::Range;

/// One attribute of a tag.
#[derive(Clone, Debug)]
pub(in crate::formats::threemf) struct Attribute<'a> {
    /// The name as it stands there, with its prefix.
    pub(in crate::formats::threemf) name: &'a str,
    /// The value as it stands there.
    pub(in crate::formats::threemf) value: &'a str,
    /// The whole attribute within the text of the tag, with the blanks before it.
    pub(in crate::formats::threemf) whole: Range<usize>,
    /// The value within the text of the tag.
    pub(in crate::formats::threemf) place: Range<usize>,
}

/// The attributes in the text of a tag from a byte on. An item is an error where the text is no attribute; it is the
/// last one.
pub(in crate::formats::threemf) fn attributes(
    text: &str,
    start: usize,
) -> impl Iterator<Item = Result<Attribute<'_>, NoAttribute>> {
    let mut at = start;
    std::iter::from_fn(move || {
        let found = next(text, at);
        at = match &found {
            Some(Ok(attribute)) => attribute.whole.end,
            _ => text.len(),
        };
        found
    })
}

/// What stands in a tag is no attribute.
#[derive(Clone, Copy, Debug)]
pub(in crate::formats::threemf) struct NoAttribute;

#[inline]
fn next(text: &str, from: usize) -> Option<Result<Attribute<'_>, NoAttribute>> {
    let bytes = text.as_bytes();
    let start = skip_blanks(bytes, from);
    if start >= bytes.len() {
        return None;
    }
    Some(attribute(text, from, start).ok_or(NoAttribute))
}

#[inline]
fn attribute(text: &str, from: usize, start: usize) -> Option<Attribute<'_>> {
    let bytes = text.as_bytes();
    let is_apart = start > from;
    let name_end = start + bytes[start..].iter().position(|&byte| byte == b'=' || is_blank(byte))?;
    let equals = skip_blanks(bytes, name_end);
    let quote_at = skip_blanks(bytes, equals + 1);
    let quote = *bytes.get(quote_at).filter(|&&quote| quote == b'"' || quote == b'\'')?;
    if !is_apart || bytes.get(equals) != Some(&b'=') || name_end == start {
        return None;
    }
    let value = quote_at + 1;
    let end = value + bytes[value..].iter().position(|&byte| byte == quote)?;
    let (name, text) = (text.get(start..name_end)?, text.get(value..end)?);
    Some(Attribute { name, value: text, whole: from..end + 1, place: value..end })
}

fn skip_blanks(bytes: &[u8], from: usize) -> usize {
    let rest = bytes.get(from..).unwrap_or_default();
    from + rest.iter().position(|&byte| !is_blank(byte)).unwrap_or(rest.len())
}

fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\n' | b'\r')
}

/// A value with its entities resolved. `None` if one of them is not among the five that XML knows.
pub(in crate::formats::threemf) fn unescaped(value: &str) -> Option<Cow<'_, str>> {
    quick_xml::escape::unescape(value).ok()
}
