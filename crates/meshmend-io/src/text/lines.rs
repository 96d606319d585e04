//! Text as bytes: blanks, line ends and words. Its character encoding is never looked at.

/// Space, tabulator, vertical tabulator and form feed.
#[inline]
pub(crate) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0b | 0x0c)
}

/// Line feed and carriage return: each of them, and both together, ends a line.
#[inline]
pub(crate) fn is_line_end(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

/// Blanks and line ends.
#[inline]
pub(crate) fn is_space(byte: u8) -> bool {
    is_blank(byte) || is_line_end(byte)
}

/// Where a text begins: after its byte order mark, if it has one.
pub(crate) fn text_start(bytes: &[u8]) -> usize {
    bytes.len() - without_mark(bytes).len()
}

/// The bytes without a byte order mark.
pub(crate) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// The line of a byte, counted from 1. Lines end with LF, CR LF or CR.
///
/// *Cost*: one pass over the bytes before it. It is meant for messages.
pub(crate) fn line_number(bytes: &[u8], at: usize) -> u64 {
    let before = &bytes[..at.min(bytes.len())];
    let ends = before.iter().enumerate().filter(|&(i, &byte)| match byte {
        b'\n' => true,
        b'\r' => bytes.get(i + 1) != Some(&b'\n'),
        _ => false,
    });
    ends.count() as u64 + 1
}

/// The place of the first line end at or after a byte, or the end of the text.
pub(crate) fn line_end(bytes: &[u8], at: usize) -> usize {
    bytes[at..].iter().position(|&byte| is_line_end(byte)).map_or(bytes.len(), |length| at + length)
}

/// Where the next line begins, if a line ends here.
pub(crate) fn after_line_end(bytes: &[u8], end: usize) -> usize {
    match (bytes.get(end), bytes.get(end + 1)) {
        (Some(b'\r'), Some(b'\n')) => end + 2,
        (Some(_), _) => end + 1,
        (None, _) => end,
    }
}

/// The bytes without blanks and line ends at both ends.
pub(crate) fn trimmed(bytes: &[u8]) -> &[u8] {
    let start = bytes.iter().position(|&b| !is_space(b)).unwrap_or(bytes.len());
    let end = bytes.iter().rposition(|&b| !is_space(b)).map_or(start, |last| last + 1);
    &bytes[start..end]
}

/// The bytes without blanks and line ends at their start.
pub(crate) fn trimmed_start(bytes: &[u8]) -> &[u8] {
    let start = bytes.iter().position(|&b| !is_space(b)).unwrap_or(bytes.len());
    &bytes[start..]
}

/// The text of a comment, without one blank at its start and all blanks at its end.
pub(crate) fn comment_text(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().rposition(|&b| !is_space(b)).map_or(0, |last| last + 1);
    match bytes[..end].split_first() {
        Some((&first, rest)) if is_blank(first) => rest,
        _ => &bytes[..end],
    }
}

/// The place of the next byte that is neither a blank nor a line end; at most the end.
#[inline]
pub(crate) fn skip_space(bytes: &[u8], mut at: usize, end: usize) -> usize {
    while at < end && bytes.get(at).is_some_and(|&b| is_space(b)) {
        at += 1;
    }
    at
}

/// The run of bytes from here on that are neither blanks nor line ends.
pub(crate) fn word(bytes: &[u8], at: usize) -> &[u8] {
    let length = bytes[at..].iter().position(|&b| is_space(b)).unwrap_or(bytes.len() - at);
    &bytes[at..at + length]
}

/// The words of some bytes.
pub(crate) fn words(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    bytes.split(|&b| is_space(b)).filter(|word| !word.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways() {
        let text = b"a\nb\r\nc\rd";
        let lines: Vec<u64> = [0, 2, 5, 7].iter().map(|&at| line_number(text, at)).collect();
        assert_eq!(lines, [1, 2, 3, 4]);
        assert_eq!(after_line_end(text, line_end(text, 2)), 5);
    }

    #[test]
    fn comments_lose_one_blank_in_front_and_all_behind() {
        assert_eq!(comment_text(b"  a b \r"), b" a b");
        assert_eq!(comment_text(b"a"), b"a");
        assert_eq!(comment_text(b"  "), b"");
    }
}
