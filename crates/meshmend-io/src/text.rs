//! Text as bytes: blanks, line ends and numbers, without a look at its character encoding.

use std::fmt::Display;

use fast_float2::FastFloat;

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

/// Where a text begins: after the byte order mark, if there is one.
pub(crate) fn text_start(bytes: &[u8]) -> usize {
    bytes.len() - without_mark(bytes).len()
}

/// The bytes after the byte order mark, if there is one.
pub(crate) fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

/// The line of a byte, counted from 1. Lines end with LF, CR LF or CR.
///
/// *Cost*: one pass over the bytes before it; only for messages.
pub(crate) fn line_number(bytes: &[u8], at: usize) -> u64 {
    let before = &bytes[..at.min(bytes.len())];
    let ends = before.iter().enumerate().filter(|&(i, &byte)| match byte {
        b'\n' => true,
        b'\r' => bytes.get(i + 1) != Some(&b'\n'),
        _ => false,
    });
    ends.count() as u64 + 1
}

/// The place of the next line end at or after a byte, or the end.
pub(crate) fn line_end(bytes: &[u8], at: usize) -> usize {
    bytes[at..].iter().position(|&byte| is_line_end(byte)).map_or(bytes.len(), |length| at + length)
}

/// The place of the line after the one whose end is here.
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

/// What a comment says: without the blank that parts it from its sign, and without blanks at its end.
pub(crate) fn comment_text(bytes: &[u8]) -> &[u8] {
    let end = bytes.iter().rposition(|&b| !is_space(b)).map_or(0, |last| last + 1);
    match bytes[..end].split_first() {
        Some((&first, rest)) if is_blank(first) => rest,
        _ => &bytes[..end],
    }
}

/// The place of the next byte that is neither blank nor line end, or an end before it.
#[inline]
pub(crate) fn skip_space(bytes: &[u8], mut at: usize, end: usize) -> usize {
    while at < end && bytes.get(at).is_some_and(|&b| is_space(b)) {
        at += 1;
    }
    at
}

/// The next run of bytes that are neither blanks nor line ends, and where it ends.
pub(crate) fn word(bytes: &[u8], at: usize) -> &[u8] {
    let length = bytes[at..].iter().position(|&b| is_space(b)).unwrap_or(bytes.len() - at);
    &bytes[at..at + length]
}

/// The words of some bytes.
pub(crate) fn words(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    bytes.split(|&b| is_space(b)).filter(|word| !word.is_empty())
}

/// A number with what is said of one, or of several: `1 value is`, `2 values are`. What is counted alone is
/// [`counted`](meshmend_core::counted).
pub(crate) fn one_or_many(count: impl Display, one: &str, many: &str) -> String {
    let count = count.to_string();
    let words = if count == "1" { one } else { many };
    format!("{count} {words}")
}

/// Bytes as people may read them: short, and printable.
pub(crate) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(LONGEST)]);
    let ellipsis = if bytes.len() > LONGEST { "…" } else { "" };
    meshmend_core::printable(&text) + ellipsis
}

/// The types of numbers with a fraction.
pub(crate) trait Real: FastFloat + From<f32> {
    /// The number nearest to what the text says, of which this is the nearest double, if that tells.
    fn nearest(double: f64) -> Option<Self>;
}

impl Real for f64 {
    #[inline]
    fn nearest(double: f64) -> Option<f64> {
        Some(double)
    }
}

impl Real for f32 {
    /// A double does not tell when it is halfway between two single numbers: what the text says may be on either side.
    /// Most texts of single numbers have too many digits to be read as such fast, and few enough for a double.
    #[inline]
    fn nearest(double: f64) -> Option<f32> {
        const SURPLUS_BITS: u64 = (1 << 29) - 1;
        const HALF: u64 = 1 << 28;
        let is_normal = double.abs() >= f64::from(f32::MIN_POSITIVE) || double == 0.0;
        (is_normal && double.to_bits() & SURPLUS_BITS != HALF).then_some(double as f32)
    }
}

/// A number with a fraction at the start of some bytes, and how long it is. What ends it is for the caller to
/// check; spellings of NaN and infinity of several run-time libraries are known.
#[inline]
pub(crate) fn real<T: Real>(bytes: &[u8]) -> Option<(T, usize)> {
    match fast_float2::parse_partial::<f64, _>(bytes) {
        Ok((double, length)) if bytes.get(length).is_none_or(|&next| !matches!(next, b'#' | b'(' | b'.')) => {
            T::nearest(double).map(|value| (value, length)).or_else(|| plain_real(bytes))
        }
        _ => odd_real(bytes),
    }
}

#[cold]
fn plain_real<T: Real>(bytes: &[u8]) -> Option<(T, usize)> {
    fast_float2::parse_partial::<T, _>(bytes).ok()
}

/// `-nan(ind)`, `1.#INF`, `-1.#IND00` and their like.
#[cold]
fn odd_real<T: Real>(bytes: &[u8]) -> Option<(T, usize)> {
    let word = word(bytes, 0);
    let (sign, rest) = match word.split_first() {
        Some((b'-', rest)) => (-1.0_f32, rest),
        Some((b'+', rest)) => (1.0, rest),
        _ => (1.0, word),
    };
    let starts =
        |prefix: &[u8]| rest.len() >= prefix.len() && rest[..prefix.len()].eq_ignore_ascii_case(prefix);
    let value = if starts(b"1.#inf") {
        f32::INFINITY
    } else if starts(b"nan(") || starts(b"1.#") {
        f32::NAN
    } else {
        let (value, length) = fast_float2::parse_partial::<T, _>(bytes).ok()?;
        return (bytes.get(length) != Some(&b'.')).then_some((value, length));
    };
    Some((T::from(sign * value), word.len()))
}

/// A run of digits at the start of some bytes, and how long it is; saturates at the largest number.
#[inline]
pub(crate) fn digits(bytes: &[u8]) -> Option<(u64, usize)> {
    let (mut value, mut length) = (0_u64, 0);
    while let Some(digit) = bytes.get(length).map(|byte| byte.wrapping_sub(b'0')).filter(|&digit| digit < 10)
    {
        value = if length < 19 { value * 10 + u64::from(digit) } else { u64::MAX };
        length += 1;
    }
    (length > 0).then_some((value, length))
}

/// A whole number with or without a sign at the start of some bytes, and how long it is; saturates.
#[inline]
pub(crate) fn integer(bytes: &[u8]) -> Option<(i64, usize)> {
    let saturated = |value: u64| i64::try_from(value).unwrap_or(i64::MAX);
    match bytes.first() {
        Some(b'-') => digits(&bytes[1..]).map(|(value, length)| (-saturated(value), length + 1)),
        Some(b'+') => digits(&bytes[1..]).map(|(value, length)| (saturated(value), length + 1)),
        _ => digits(bytes).map(|(value, length)| (saturated(value), length)),
    }
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
    fn numbers_stop_where_they_end() {
        assert_eq!(real::<f64>(b"-1.5e3 x"), Some((-1500.0, 6)));
        assert_eq!(real::<f64>(b"+2,5"), Some((2.0, 2)));
        assert_eq!(real::<f64>(b"1e400"), Some((f64::INFINITY, 5)));
        assert_eq!(real::<f64>(b"1.2.3"), None);
        assert_eq!(real::<f64>(b"1#c"), Some((1.0, 1)));
        assert_eq!(real::<f64>(b"x"), None);
        assert!(real::<f64>(b"-0").is_some_and(|(value, _)| value.is_sign_negative()));
    }

    #[test]
    fn other_spellings_of_no_number_are_known() {
        for text in ["nan", "NaN", "-nan(ind)", "1.#QNAN", "-1.#IND00"] {
            let (value, length) = real::<f32>(text.as_bytes()).unwrap();
            assert!(value.is_nan(), "{text}");
            assert_eq!(length, text.len());
        }
        assert_eq!(real::<f32>(b"-1.#INF"), Some((f32::NEG_INFINITY, 7)));
        assert_eq!(real::<f32>(b"+1.#inf"), Some((f32::INFINITY, 7)));
        assert_eq!(real::<f64>(b"-inf"), Some((f64::NEG_INFINITY, 4)));
    }

    #[test]
    fn text_is_rounded_once_to_its_type() {
        // Halfway between two single numbers in double precision, but not as written.
        assert_eq!(real::<f32>(b"1.00000005960464477540"), Some((1.0000001, 22)));
    }

    #[test]
    fn single_numbers_are_those_nearest_to_the_text() {
        let direct = |text: &str| {
            let parsed: f32 = text.parse().unwrap();
            let (read, length) = real::<f32>(text.as_bytes()).unwrap();
            assert_eq!((read.to_bits(), length), (parsed.to_bits(), text.len()), "{text}");
        };
        let mut bits = 1_u32;
        for _ in 0..20_000 {
            bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let (value, above) = (f32::from_bits(bits), f32::from_bits(bits.wrapping_add(1)));
            if !value.is_finite() || !above.is_finite() {
                continue;
            }
            // The number, and what is halfway to the next one, less, and more than that.
            let half = f64::midpoint(f64::from(value), f64::from(above));
            direct(&format!("{value:e}"));
            direct(&format!("{half:e}"));
            direct(&format!("{:e}", half.next_down()));
            direct(&format!("{:.20e}", half.next_up()));
        }
        for text in [
            "3.4028235e38",
            "3.4028235677973366e38",
            "3.5e38",
            "-1e300",
            "1e-45",
            "7e-46",
            "1e-60",
            "-0",
            "1e999",
        ] {
            direct(text);
        }
    }

    #[test]
    fn whole_numbers_saturate() {
        assert_eq!(digits(b"18446744073709551617/"), Some((u64::MAX, 20)));
        assert_eq!(integer(b"-9223372036854775808"), Some((-i64::MAX, 20)));
        assert_eq!(integer(b"-12 "), Some((-12, 3)));
        // The neighbours of the digits are none.
        assert_eq!([digits(b"12/"), digits(b"12:")], [Some((12, 2)); 2]);
        assert_eq!(integer(b"+12 "), Some((12, 3)));
        assert_eq!(integer(b"-"), None);
    }

    #[test]
    fn long_and_unprintable_words_are_shown_short_and_printable() {
        assert_eq!(shown(b"a\x07b"), "a\u{fffd}b");
        assert_eq!(shown("a\u{202e}b".as_bytes()), "a\\u{202e}b");
        assert_eq!(shown(&[b'x'; 40]), "x".repeat(40));
        assert_eq!(shown(&[b'x'; 41]), "x".repeat(40) + "…");
    }

    #[test]
    fn comments_lose_one_blank_in_front_and_all_behind() {
        assert_eq!(comment_text(b"  a b \r"), b" a b");
        assert_eq!(comment_text(b"a"), b"a");
        assert_eq!(comment_text(b"  "), b"");
    }
}
