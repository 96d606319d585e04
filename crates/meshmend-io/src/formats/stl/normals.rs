//! Stored normals of facets, compared with those of the corners.
//!
//! Stored normals are not kept: a writer computes them from the corners. So those that point elsewhere are counted.

use crate::input::notes::Notes;
use crate::{NoteKind, Place};

/// The square of the sine of the angle from which on two directions differ: a thousandth of a radian.
const SQUARE_OF_SINE: f64 = 1e-6;

/// The stored normals that point elsewhere than the facets do.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Recomputed {
    pub(super) count: u64,
    /// Where the first of their facets begins.
    pub(super) first: Option<usize>,
}

impl Recomputed {
    /// Takes in the stored normal of a facet that begins at a byte. A vector that is zero or not finite has no
    /// direction, so it does not differ.
    #[inline]
    pub(super) fn see(&mut self, stored: [f64; 3], corners: [[f64; 3]; 3], at: usize) {
        if stored != [0.0; 3] && differ(stored, corners) {
            self.count += 1;
            self.first.get_or_insert(at);
        }
    }

    /// Takes in what was seen at later places.
    pub(super) fn see_all(&mut self, later: Recomputed) {
        self.count += later.count;
        self.first = self.first.or(later.first);
    }

    /// Notes them, with the place of the first.
    pub(super) fn note(self, notes: &mut Notes, place: impl FnOnce(usize) -> Place) {
        let message =
            "stored normals that point elsewhere than their facets are not kept, but computed afresh";
        let first = self.first.map_or(Place::File, place);
        notes.add_many(NoteKind::NormalsRecomputed, message, self.count, || first);
    }
}

#[inline]
fn differ(stored: [f64; 3], corners: [[f64; 3]; 3]) -> bool {
    let (Some(along), true) = (along_area(corners), stored.iter().all(|x| x.is_finite())) else {
        return false;
    };
    let mut stored = stored;
    if !is_ordinary(dot(stored, stored)) {
        stored = scaled(stored);
    }
    let (product, squares) = (dot(stored, along), dot(stored, stored) * dot(along, along));
    product <= 0.0 || product * product < (1.0 - SQUARE_OF_SINE) * squares
}

/// The unit normal of a triangle, or zero if it has none.
pub(super) fn unit_normal(corners: [[f64; 3]; 3]) -> [f64; 3] {
    let Some(along) = along_area(corners) else { return [0.0; 3] };
    let scale = 1.0 / dot(along, along).sqrt();
    along.map(|x| x * scale)
}

/// A vector along the area vector of a triangle, of a length whose square is an ordinary number. Returns `None` if
/// the corners lie on a line or are not finite.
#[inline]
fn along_area(corners: [[f64; 3]; 3]) -> Option<[f64; 3]> {
    let [a, b, c] = corners;
    let along = cross(minus(b, a), minus(c, a));
    if is_ordinary(dot(along, along)) { Some(along) } else { along_odd_area(corners) }
}

/// The same where a square may overflow or vanish.
#[cold]
fn along_odd_area(corners: [[f64; 3]; 3]) -> Option<[f64; 3]> {
    // Half of a difference never overflows.
    let [a, b, c] = if corners.iter().flatten().any(|x| x.abs() > 1e300) {
        corners.map(|p| p.map(|x| 0.5 * x))
    } else {
        corners
    };
    let along = scaled(cross(scaled(minus(b, a)), scaled(minus(c, a))));
    is_ordinary(dot(along, along)).then_some(along)
}

/// A vector in the same direction whose largest coordinate is about 1, or the vector itself if it is zero or not
/// finite.
fn scaled(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest > 0.0 && largest.is_finite() { vector.map(|x| x / largest) } else { vector }
}

/// Whether a square is far from where numbers overflow or vanish.
#[inline]
fn is_ordinary(square: f64) -> bool {
    square > 1e-200 && square < 1e200
}

#[inline]
fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline]
fn cross(u: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

#[inline]
fn dot(u: [f64; 3], v: [f64; 3]) -> f64 {
    u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
}

/// A number, perhaps without its last bits, as only a direction is needed. NaN if the word is not an ordinary number.
#[inline]
pub(super) fn roughly(word: &[u8]) -> f64 {
    let (is_negative, digits) = match word {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        rest => (false, rest),
    };
    let mantissa = if digits.len() <= MOST_DIGITS { short_mantissa(digits) } else { long_mantissa(digits) };
    let Some((whole, scale, rest)) = mantissa else { return f64::NAN };
    let exponent = match rest {
        [] => Some(0),
        [b'e' | b'E', exponent @ ..] => {
            std::str::from_utf8(exponent).ok().and_then(|exponent| exponent.parse::<i16>().ok())
        }
        _ => None,
    };
    let Some(exponent) = exponent else { return f64::NAN };
    let value = whole as f64 * power_of_ten(scale.saturating_add(i32::from(exponent)));
    if is_negative { -value } else { value }
}

/// How many digits always fit a whole number of 64 bits.
const MOST_DIGITS: usize = 19;

/// The digits before an exponent as a whole number, the power of ten that multiplies it, and the bytes that follow.
type Mantissa<'a> = (u64, i32, &'a [u8]);

/// The mantissa of a short word, all of whose digits fit.
#[inline]
fn short_mantissa(word: &[u8]) -> Option<Mantissa<'_>> {
    let (mut whole, mut point, mut end) = (0_u64, None, 0);
    for &byte in word {
        let digit = byte.wrapping_sub(b'0');
        if digit < 10 {
            whole = 10 * whole + u64::from(digit);
        } else if byte == b'.' && point.is_none() {
            point = Some(end);
        } else {
            break;
        }
        end += 1;
    }
    let after_point = point.map_or(0, |point| end - point - 1);
    let digits = end - usize::from(point.is_some());
    (digits > 0).then(|| (whole, -(after_point as i32), &word[end..]))
}

/// The mantissa of any word. Digits beyond those that matter are only counted.
#[cold]
fn long_mantissa(mut rest: &[u8]) -> Option<Mantissa<'_>> {
    let (mut whole, mut scale, mut is_after_point, mut any) = (0_u64, 0_i32, false, false);
    while let [byte, after @ ..] = rest {
        match byte {
            b'0'..=b'9' => {
                any = true;
                if whole < 1 << 56 {
                    whole = 10 * whole + u64::from(byte - b'0');
                    scale -= i32::from(is_after_point);
                } else {
                    scale += i32::from(!is_after_point);
                }
            }
            b'.' if !is_after_point => is_after_point = true,
            _ => break,
        }
        rest = after;
    }
    any.then_some((whole, scale, rest))
}

#[inline]
fn power_of_ten(exponent: i32) -> f64 {
    const TENTHS: [f64; 20] = [
        1e0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15,
        1e-16, 1e-17, 1e-18, 1e-19,
    ];
    let tenth = usize::try_from(-i64::from(exponent)).ok().and_then(|at| TENTHS.get(at));
    tenth.copied().unwrap_or_else(|| 10_f64.powi(exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FLAT: [[f64; 3]; 3] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

    fn is_named(stored: [f64; 3], corners: [[f64; 3]; 3]) -> bool {
        let mut seen = Recomputed::default();
        seen.see(stored, corners, 7);
        assert_eq!(seen.first, (seen.count > 0).then_some(7));
        seen.count == 1
    }

    #[test]
    fn a_thousandth_of_a_radian_is_the_border_whatever_the_lengths_are() {
        for length in [1.0, 1e-30, 1e30, 1e-300, 1e300] {
            let tilted = |angle: f64| [length * angle.sin(), 0.0, length * angle.cos()];
            for size in [1.0, 1e-30, 1e30, 1e-300, 1e300] {
                let corners = FLAT.map(|p| p.map(|x| x * size));
                assert!(!is_named(tilted(0.999e-3), corners), "{length} {size}");
                assert!(is_named(tilted(1.001e-3), corners), "{length} {size}");
                assert!(is_named(tilted(std::f64::consts::PI), corners), "{length} {size}");
            }
        }
    }

    #[test]
    fn what_has_no_direction_differs_from_none() {
        for stored in [[0.0; 3], [-0.0; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 0.0]] {
            assert!(!is_named(stored, FLAT), "{stored:?}");
        }
        let line = [[0.0; 3], [1.0; 3], [3.0; 3]];
        let infinite = [[0.0; 3], [1.0, 0.0, 0.0], [f64::INFINITY, 1.0, 0.0]];
        for corners in [line, infinite, [[1.0; 3]; 3]] {
            assert!(!is_named([1.0, 0.0, 0.0], corners), "{corners:?}");
            assert_eq!(unit_normal(corners), [0.0; 3]);
        }
    }

    #[test]
    fn normals_are_found_at_all_sizes() {
        for size in [1.0, 5e-324, 1e-310, 1e-200, 1e150, f64::MAX] {
            assert_eq!(unit_normal(FLAT.map(|p| p.map(|x| x * size))), [0.0, 0.0, 1.0], "{size}");
        }
        assert_eq!(
            unit_normal([[-f64::MAX; 3], [f64::MAX, 0.0, 0.0], [0.0, f64::MAX, 0.0]]).map(|x| x.is_finite()),
            [true; 3]
        );
    }

    #[test]
    fn numbers_are_read_closely_enough() {
        for text in
            ["0", "-1", "+0.5", "0.57735026918962576451", "1e0", "-7.0710678e-01", "5E-1", "1e3", ".25", "3."]
        {
            let exact: f64 = text.parse().unwrap();
            assert!((roughly(text.as_bytes()) - exact).abs() <= 1e-15 * exact.abs(), "{text}");
        }
        assert_eq!(roughly(&[b'9'; 400]), f64::INFINITY);
        for text in ["", "-", ".", "nan", "-nan(ind)", "1.#QNAN", "1,5", "1e", "1e+x", "0x1", "1.2.3", "inf"]
        {
            assert!(roughly(text.as_bytes()).is_nan(), "{text}");
        }
    }
}
