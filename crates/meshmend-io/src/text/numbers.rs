//! Numbers at the start of some bytes.

use fast_float2::FastFloat;

use super::lines::word;

/// The floating-point types.
pub(crate) trait Real: FastFloat + From<f32> {
    /// The number nearest to a text, given the double nearest to it. `None` if the double does not decide.
    fn nearest(double: f64) -> Option<Self>;
}

impl Real for f64 {
    #[inline]
    fn nearest(double: f64) -> Option<f64> {
        Some(double)
    }
}

impl Real for f32 {
    /// A double halfway between two single numbers does not decide: the text may lie on either side. Texts of single
    /// numbers often have too many digits for the fast path of their type, but few enough for that of doubles.
    #[inline]
    fn nearest(double: f64) -> Option<f32> {
        const SURPLUS_BITS: u64 = (1 << 29) - 1;
        const HALF: u64 = 1 << 28;
        let is_normal = double.abs() >= f64::from(f32::MIN_POSITIVE) || double == 0.0;
        (is_normal && double.to_bits() & SURPLUS_BITS != HALF).then_some(double as f32)
    }
}

/// The floating-point number at the start of some bytes, and its length. The caller checks what ends it. The
/// spellings of NaN and infinity by several run-time libraries are understood.
#[inline]
pub(crate) fn real<T: Real>(bytes: &[u8]) -> Option<(T, usize)> {
    match fast_float2::parse_partial::<f64, _>(bytes) {
        Ok((double, length)) if bytes.get(length).is_none_or(|&next| !matches!(next, b'#' | b'(' | b'.')) => {
            T::nearest(double).map(|value| (value, length)).or_else(|| exact_real(bytes))
        }
        _ => odd_real(bytes),
    }
}

#[cold]
fn exact_real<T: Real>(bytes: &[u8]) -> Option<(T, usize)> {
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

/// The digits at the start of some bytes as a number, and their count. The number saturates.
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

/// The whole number at the start of some bytes, with or without a sign, and its length. The number saturates.
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
}
