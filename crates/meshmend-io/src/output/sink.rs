//! What writers write to: a buffer before the real sink, and numbers as text.

use std::io::{self, Write};

/// Collects bytes and passes them on in large pieces.
pub(crate) struct Sink<'a> {
    out: &'a mut dyn Write,
    buffer: Vec<u8>,
}

const PIECE: usize = 1 << 16;

impl<'a> Sink<'a> {
    pub(crate) fn new(out: &'a mut dyn Write) -> Self {
        Sink { out, buffer: Vec::with_capacity(PIECE + (PIECE >> 2)) }
    }

    #[inline]
    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        self.buffer.extend_from_slice(bytes);
    }

    #[inline]
    pub(crate) fn byte(&mut self, byte: u8) {
        self.buffer.push(byte);
    }

    /// A number with the fewest digits that read back to the same bits.
    #[inline]
    pub(crate) fn real(&mut self, value: f64) {
        push_real(&mut self.buffer, value);
    }

    /// A single-precision number with the fewest digits that read back to the same bits.
    pub(crate) fn single(&mut self, value: f32) {
        if f64::from(value).fract() == 0.0 || !value.is_finite() {
            return push_real(&mut self.buffer, f64::from(value));
        }
        self.buffer.extend_from_slice(zmij::Buffer::new().format_finite(value).as_bytes());
    }

    #[inline]
    pub(crate) fn integer(&mut self, value: i64) {
        push_integer(&mut self.buffer, value);
    }

    /// Passes on what is collected if it is large. Writers call this after each line or row.
    #[inline]
    pub(crate) fn checkpoint(&mut self) -> io::Result<()> {
        if self.buffer.len() >= PIECE { self.pass_on() } else { Ok(()) }
    }

    /// Passes on what is left.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        self.pass_on()?;
        self.out.flush()
    }

    fn pass_on(&mut self) -> io::Result<()> {
        self.out.write_all(&self.buffer)?;
        self.buffer.clear();
        Ok(())
    }
}

/// A number with the fewest digits that read back to the same bits.
pub(crate) fn number_text(value: f64) -> String {
    let mut buffer = Vec::new();
    push_real(&mut buffer, value);
    buffer.into_iter().map(char::from).collect()
}

/// Whole numbers below this are written digit by digit.
const EXACT: f64 = 1e16;

#[inline]
fn push_real(buffer: &mut Vec<u8>, value: f64) {
    if value.fract() == 0.0 && value.abs() < EXACT {
        if value == 0.0 && value.is_sign_negative() {
            buffer.push(b'-');
        }
        push_integer(buffer, value as i64);
    } else if value.is_finite() {
        buffer.extend_from_slice(zmij::Buffer::new().format_finite(value).as_bytes());
    } else {
        let name: &[u8] = match value {
            f64::INFINITY => b"inf",
            f64::NEG_INFINITY => b"-inf",
            _ => b"nan",
        };
        buffer.extend_from_slice(name);
    }
}

#[inline]
fn push_integer(buffer: &mut Vec<u8>, value: i64) {
    let (mut digits, mut at, mut rest) = ([0_u8; 20], 20, value.unsigned_abs());
    loop {
        at -= 1;
        digits[at] = b'0' + (rest % 10) as u8;
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    if value < 0 {
        buffer.push(b'-');
    }
    buffer.extend_from_slice(&digits[at..]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text;

    fn text_of(value: f64) -> String {
        let mut buffer = Vec::new();
        push_real(&mut buffer, value);
        String::from_utf8(buffer).unwrap()
    }

    #[test]
    fn numbers_are_short() {
        let values = [0.0, -0.0, 1.0, -1.5, 0.1, 1e15, 1e16, 1e-7, 1e308, f64::NAN, f64::NEG_INFINITY];
        let texts: Vec<String> = values.iter().map(|&v| text_of(v)).collect();
        assert_eq!(
            texts,
            ["0", "-0", "1", "-1.5", "0.1", "1000000000000000", "1e+16", "1e-7", "1e+308", "nan", "-inf"]
        );
    }

    #[test]
    fn numbers_read_back_to_the_same_bits() {
        let mut bits = 0x3ff0_0000_0000_0000_u64;
        for _ in 0..20_000 {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let value = f64::from_bits(bits);
            let read = text::real::<f64>(text_of(value).as_bytes()).unwrap().0;
            assert!(read.to_bits() == bits || (read.is_nan() && value.is_nan()));
        }
    }

    #[test]
    fn single_numbers_are_as_short_as_their_type_allows() {
        let mut out = Vec::new();
        let mut sink = Sink::new(&mut out);
        for value in [0.1, 1.0, -0.0, 1.5e-9, f32::INFINITY, f32::NAN] {
            sink.single(value);
            sink.byte(b' ');
        }
        sink.finish().unwrap();
        assert_eq!(String::from_utf8(out).unwrap(), "0.1 1 -0 1.5e-9 inf nan ");
    }

    /// Keeps the sizes of the pieces that it is given.
    struct Pieces(Vec<usize>);

    impl Write for Pieces {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.push(bytes.len());
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn bytes_are_passed_on_in_large_pieces() {
        let mut pieces = Pieces(Vec::new());
        let mut sink = Sink::new(&mut pieces);
        for _ in 0..5 * PIECE / 2 {
            sink.byte(b'x');
            sink.checkpoint().unwrap();
        }
        sink.finish().unwrap();
        assert_eq!(pieces.0, [65_536, 65_536, 32_768]);
    }

    #[test]
    fn everything_arrives_and_errors_come_back() {
        let mut out = Vec::new();
        let mut sink = Sink::new(&mut out);
        (0..100_000).try_for_each(|i| (sink.integer(i), sink.checkpoint()).1).unwrap();
        sink.finish().unwrap();
        assert_eq!(out.len(), 10 + 90 * 2 + 900 * 3 + 9_000 * 4 + 90_000 * 5);
        let mut full: &mut [u8] = &mut [0; 3];
        let mut sink = Sink::new(&mut full);
        sink.bytes(b"four");
        assert!(sink.finish().is_err());
    }
}
