//! Base64, as data URIs have it: strict, with the padding at the end and nothing else between.

use std::io::{self, Write};

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Not a digit.
const NONE: u8 = 64;

const VALUES: [u8; 256] = {
    let mut values = [NONE; 256];
    let mut digit = 0;
    while digit < DIGITS.len() {
        values[DIGITS[digit] as usize] = digit as u8;
        digit += 1;
    }
    values
};

/// The bytes of a text, or the place of the first character that is wrong. The padding may be left out.
///
/// *Cost*: linear.
pub(super) fn decode(text: &[u8]) -> Result<Vec<u8>, usize> {
    let padding = text.iter().rev().take(2).take_while(|&&byte| byte == b'=').count();
    let digits = text.get(..text.len() - padding).unwrap_or_default();
    if digits.len() % 4 == 1 || (padding > 0 && !text.len().is_multiple_of(4)) {
        return Err(text.len());
    }
    let mut out = Vec::with_capacity(digits.len() / 4 * 3 + 2);
    let mut at = 0;
    for quad in digits.chunks(4) {
        let values = quad.iter().map(|&byte| VALUES[usize::from(byte)]);
        if let Some(wrong) = values.clone().position(|value| value == NONE) {
            return Err(at + wrong);
        }
        let bits = values.fold(0_u32, |bits, value| bits << 6 | u32::from(value)) << (6 * (4 - quad.len()));
        let [_, bytes @ ..] = bits.to_be_bytes();
        let whole = quad.len() - 1;
        if bytes[whole..].iter().any(|&byte| byte != 0) {
            return Err(at + whole);
        }
        out.extend_from_slice(&bytes[..whole]);
        at += 4;
    }
    Ok(out)
}

/// Bytes as text in base64, with padding.
///
/// *Cost*: linear.
pub fn encode(bytes: &[u8]) -> String {
    let digits = |three: &[u8]| -> [u8; 4] {
        let digits = four_digits([0, 1, 2].map(|at| three.get(at).copied().unwrap_or(0)));
        std::array::from_fn(|place| if place > three.len() { b'=' } else { digits[place] })
    };
    bytes.chunks(3).flat_map(digits).map(char::from).collect()
}

/// Writes bytes as text in base 64.
pub(super) struct Base64<'a> {
    out: &'a mut dyn Write,
    /// Up to two bytes that wait for a third one.
    rest: Vec<u8>,
}

impl<'a> Base64<'a> {
    pub(super) fn new(out: &'a mut dyn Write) -> Self {
        Base64 { out, rest: Vec::new() }
    }

    /// Writes the last digits.
    pub(super) fn finish(self) -> io::Result<()> {
        let digits = four_digits([0, 1, 2].map(|at| self.rest.get(at).copied().unwrap_or(0)));
        match self.rest.len() {
            0 => Ok(()),
            count => {
                self.out.write_all(&digits[..=count])?;
                self.out.write_all(&b"=="[..3 - count])
            }
        }
    }
}

impl Write for Base64<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut text = Vec::with_capacity(bytes.len().div_ceil(3) * 4 + 4);
        for &byte in bytes {
            self.rest.push(byte);
            if let [a, b, c] = self.rest[..] {
                text.extend_from_slice(&four_digits([a, b, c]));
                self.rest.clear();
            }
        }
        self.out.write_all(&text)?;
        Ok(bytes.len())
    }

    /// What waits here is written at the end, and the sink is flushed then.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn four_digits([a, b, c]: [u8; 3]) -> [u8; 4] {
    let bits = u32::from_be_bytes([0, a, b, c]);
    [18, 12, 6, 0].map(|shift| DIGITS[(bits >> shift & 63) as usize])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_lengths_and_bytes_come_back() {
        let bytes: Vec<u8> = (0..=255).rev().chain(0..=255).collect();
        for length in 0..=bytes.len() {
            let text = encode(&bytes[..length]);
            assert_eq!(decode(text.as_bytes()).as_deref(), Ok(&bytes[..length]));
            assert_eq!(decode(text.trim_end_matches('=').as_bytes()).as_deref(), Ok(&bytes[..length]));
        }
        assert_eq!(
            (encode(b"M"), encode(b"Ma"), encode(b"Man")),
            ("TQ==".into(), "TWE=".into(), "TWFu".into())
        );
    }

    #[test]
    fn nothing_else_is_taken() {
        for (text, place) in [
            ("A", 1),
            ("TQ=", 3),
            ("TQ===", 5),
            ("TWF\n", 3),
            ("TW-u", 2),
            ("T===", 1),
            ("TR==", 1),
            ("TWFuTWF=", 6),
            ("=", 1),
            ("TQ==TQ==", 2),
        ] {
            assert_eq!(decode(text.as_bytes()), Err(place), "{text}");
        }
    }

    #[test]
    fn bytes_are_encoded_alike_however_they_come() {
        let digits = |bytes: &[u8], piece: usize| {
            let mut out = Vec::new();
            let mut encoder = Base64::new(&mut out);
            bytes.chunks(piece).for_each(|piece| encoder.write_all(piece).unwrap());
            encoder.finish().unwrap();
            String::from_utf8(out).unwrap()
        };
        // The examples of RFC 4648.
        for (bytes, expected) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("foobar", "Zm9vYmFy"),
        ] {
            (1..=4).for_each(|piece| assert_eq!(digits(bytes.as_bytes(), piece), expected));
        }
        assert_eq!(digits(&[0xfb, 0xff, 0xfe], 2), "+//+");
    }
}
