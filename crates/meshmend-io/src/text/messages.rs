//! Counts and bytes as messages show them.

use std::fmt::Display;

/// A number with the words for one or for several: `1 value is`, `2 values are`. For a noun alone there is
/// [`counted`](meshmend_core::counted).
pub(crate) fn one_or_many(count: impl Display, one: &str, many: &str) -> String {
    let count = count.to_string();
    let words = if count == "1" { one } else { many };
    format!("{count} {words}")
}

/// Bytes as printable text, cut to a few words.
pub(crate) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(LONGEST)]);
    let ellipsis = if bytes.len() > LONGEST { "…" } else { "" };
    meshmend_core::printable(&text) + ellipsis
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_and_unprintable_words_are_shown_short_and_printable() {
        assert_eq!(shown(b"a\x07b"), "a\u{fffd}b");
        assert_eq!(shown("a\u{202e}b".as_bytes()), "a\\u{202e}b");
        assert_eq!(shown(&[b'x'; 40]), "x".repeat(40));
        assert_eq!(shown(&[b'x'; 41]), "x".repeat(40) + "…");
    }
}
