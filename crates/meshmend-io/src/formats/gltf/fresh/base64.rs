//! Bytes as text in base 64, piece by piece.

use std::io::{self, Write};

/// Writes bytes as text in base 64.
pub(super) struct Base64<'a> {
    out: &'a mut dyn Write,
    /// Up to two bytes that wait for a third one.
    rest: Vec<u8>,
}

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

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
