//! What is known of OFF, and how its content is told.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};
use crate::formats::off::letters::{Columns, letters_and_count};
use crate::text;

pub(crate) const FACTS: Facts = Facts {
    name: "OFF",
    extensions: &["off", "coff", "noff", "cnoff", "stoff"],
    encodings: &[Encoding::Ascii],
    variant: |_| "off",
    holds_polygons: true,
    has_indices: true,
    texture_origin: TextureOrigin::LowerLeft,
    sniff: |head, _| sniff(head),
};

/// Whether a text is surely OFF: it begins with the word, and two numbers or `BINARY` follow.
fn sniff<'a>(bytes: &'a [u8]) -> bool {
    let bytes = &bytes[text::text_start(bytes)..];
    let without_comment = |line: &'a [u8]| line.split(|&b| b == b'#').next().unwrap_or_default();
    let mut words = bytes.split(|&b| text::is_line_end(b)).map(without_comment).flat_map(text::words);
    let Some((letters, mut glued)) = words.next().and_then(letters_and_count) else { return false };
    let is_count = |word: &[u8]| text::digits(word).is_some_and(|(_, length)| length == word.len());
    let mut next = || match std::mem::take(&mut glued) {
        [] => words.next().unwrap_or_default(),
        count => count,
    };
    let first = next();
    is_known(letters) && (first == b"BINARY" || (is_count(first) && is_count(next())))
}

fn is_known(letters: &[u8]) -> bool {
    Columns::of_letters(letters).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_surely_off_when_numbers_follow_the_word() {
        for text in
            ["OFF\n3 1 0", "OFF3 1", "# c\n CNOFF # d\n\n8\n9", "OFF BINARY", "STOFF 1 2", "\u{feff}OFF 1 2"]
        {
            assert!(sniff(text.as_bytes()), "{text}");
        }
        for text in [
            "",
            "OFF",
            "OFF 3",
            "OFF is a format",
            "OFFER 3 1 0",
            "XOFF 3 1 0",
            "3 1 0",
            "SOFF 3 1",
            "OFF3x 1",
        ] {
            assert!(!sniff(text.as_bytes()), "{text}");
        }
    }
}
