//! Base64, as data URIs have it: strict, with the padding at the end and nothing else between.

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

/// A text for some bytes, with padding.
///
/// *Cost*: linear.
pub(super) fn encode(bytes: &[u8]) -> String {
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let byte = |at: usize| three.get(at).copied().unwrap_or(0);
        let bits = u32::from_be_bytes([0, byte(0), byte(1), byte(2)]);
        for place in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * place)) as usize & 63];
            out.push(if place > three.len() { '=' } else { char::from(digit) });
        }
    }
    out
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
}
