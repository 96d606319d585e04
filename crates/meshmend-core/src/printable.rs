//! Texts from files as they may be shown.

use std::fmt::Write;

/// A text from a file or a file name without characters that would take hold of a terminal or of a line: control characters
/// are replaced, and those that change the direction of what follows are spelled as `\u{202e}`.
///
/// ```
/// # use meshmend_core::printable;
/// assert_eq!(printable("a\u{7}b \u{202e}txt.exe"), "a\u{fffd}b \\u{202e}txt.exe");
/// ```
pub fn printable(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{200e}' | '\u{200f}' | '\u{61c}' => {
                // Writing to a string can't fail.
                write!(shown, "{}", character.escape_unicode()).ok();
            }
            control if control.is_control() => shown.push(char::REPLACEMENT_CHARACTER),
            other => shown.push(other),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_character_that_turns_a_line_round_is_spelled() {
        let turning =
            "\u{202a}\u{202b}\u{202c}\u{202d}\u{202e}\u{2066}\u{2067}\u{2068}\u{2069}\u{200e}\u{200f}\u{61c}";
        let shown = printable(turning);
        assert!(shown.is_ascii(), "{shown}");
        assert_eq!(shown.matches("\\u{").count(), turning.chars().count());
        assert_eq!(printable(&shown), shown);
        assert_eq!(printable("שלום \u{1b}[31m é"), "שלום \u{fffd}[31m é");
    }
}
