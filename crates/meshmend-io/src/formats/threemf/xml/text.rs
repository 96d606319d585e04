//! The bytes of an entry as text: UTF-8, or UTF-16 that is turned into it.

use std::borrow::Cow;

use crate::formats::threemf::package::Fault;

/// The text of an entry.
#[derive(Debug)]
pub(in crate::formats::threemf) struct Text {
    pub(in crate::formats::threemf) text: String,
    /// Whether the entry has it in UTF-16.
    pub(in crate::formats::threemf) was_utf16: bool,
}

impl Text {
    /// # Errors
    /// If the bytes are neither UTF-8 nor UTF-16.
    ///
    /// *Cost*: linear; UTF-8 is not copied.
    pub(in crate::formats::threemf) fn of(content: Vec<u8>, entry: &str) -> Result<Self, Fault> {
        let unit_of: fn([u8; 2]) -> u16 = match content.as_slice() {
            [0xfe, 0xff, ..] | [0, b'<', ..] => u16::from_be_bytes,
            _ => u16::from_le_bytes,
        };
        let wide = match content.as_slice() {
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => Some(2),
            [b'<', 0, ..] | [0, b'<', ..] => Some(0),
            _ => None,
        };
        let wrong = || Fault::of_entry(entry, "the text is neither UTF-8 nor UTF-16");
        let Some(start) = wide else {
            let text = String::from_utf8(content).map_err(|_| wrong())?;
            return Ok(Text { text, was_utf16: false });
        };
        let units = content[start..].chunks(2).map(|pair| <[u8; 2]>::try_from(pair).map(unit_of));
        let units: Vec<u16> = units.collect::<Result<_, _>>().map_err(|_| wrong())?;
        let text = String::from_utf16(&units).map_err(|_| wrong())?;
        Ok(Text { text, was_utf16: true })
    }
}

/// A text as the value of an attribute.
pub(in crate::formats::threemf) fn escaped(text: &str) -> Cow<'_, str> {
    let needs = |c: char| matches!(c, '<' | '>' | '&' | '"' | '\'') || c.is_control();
    if !text.contains(needs) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        match c {
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&apos;"),
            '\t' | '\n' | '\r' => escaped.push_str(&format!("&#{};", u32::from(c))),
            // Other control characters are not allowed in XML, in any spelling.
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    Cow::Owned(escaped)
}

/// A text that says in its first line that it is UTF-8, if that names an encoding.
pub(in crate::formats::threemf) fn declared_as_utf8(text: &str) -> String {
    let line_end = text.find("?>").filter(|_| text.starts_with("<?xml"));
    let Some(line_end) = line_end else { return text.to_owned() };
    let (line, rest) = text.split_at(line_end);
    let value = line.find("encoding").and_then(|at| {
        let start = at + line[at..].find(['"', '\''])? + 1;
        let end = start + line[start..].find(['"', '\''])?;
        Some(start..end)
    });
    match value {
        Some(value) => format!("{}UTF-8{}{rest}", &line[..value.start], &line[value.end..]),
        None => text.to_owned(),
    }
}
