//! Coordinates as whole numbers of any size.

use meshmend_geometry::vector::Point;
use num_bigint::BigInt;

/// A point of whole numbers.
pub(crate) type IntegerPoint = [BigInt; 3];

/// Numbers times the least power of two that makes all of them whole.
pub(crate) fn integers<const N: usize>(numbers: [f64; N]) -> [BigInt; N] {
    let lowest = lowest_exponent(numbers.iter());
    numbers.map(|number| integer(number, lowest))
}

/// Numbers times the least power of two that makes all of them whole, if none is beyond 2⁴⁰ then.
pub(super) fn small_integers<const N: usize>(numbers: [f64; N]) -> Option<[i64; N]> {
    let (mut lowest, mut highest) = (i32::MAX, i32::MIN);
    for &number in numbers.iter().filter(|&&number| number != 0.0) {
        let (digits, exponent) = parts(number);
        lowest = lowest.min(exponent + digits.trailing_zeros() as i32);
        highest = highest.max(exponent + 64 - digits.unsigned_abs().leading_zeros() as i32);
    }
    let whole = |number: f64| {
        let (digits, exponent) = parts(number);
        if digits == 0 {
            return 0;
        }
        let shift = exponent - lowest;
        if shift < 0 { digits >> -shift } else { digits << shift }
    };
    (highest <= lowest.saturating_add(40)).then(|| numbers.map(whole))
}

/// Points, all coordinates times the least power of two that makes all of them whole.
pub(crate) fn integer_points<const N: usize>(points: [Point; N]) -> [IntegerPoint; N] {
    let lowest = lowest_exponent(points.iter().flatten());
    points.map(|point| point.map(|number| integer(number, lowest)))
}

/// The exponent of the lowest bit that is set in any of some numbers; 0 if there is none.
pub(crate) fn lowest_exponent<'a>(numbers: impl Iterator<Item = &'a f64>) -> i32 {
    let parts = numbers.map(|&number| parts(number)).filter(|&(digits, _)| digits != 0);
    parts.map(|(digits, exponent)| exponent + digits.trailing_zeros() as i32).min().unwrap_or(0)
}

/// A number divided by two to the power of an exponent that is at most that of its lowest bit.
pub(crate) fn integer(number: f64, lowest: i32) -> BigInt {
    let (digits, exponent) = parts(number);
    if digits == 0 {
        return BigInt::ZERO;
    }
    let shift = exponent - lowest;
    if shift < 0 { BigInt::from(digits >> -shift) } else { BigInt::from(digits) << shift }
}

/// The vector from the second point to the first.
pub(crate) fn minus(a: &IntegerPoint, b: &IntegerPoint) -> IntegerPoint {
    std::array::from_fn(|i| &a[i] - &b[i])
}

/// The scalar product.
pub(crate) fn dot(a: &IntegerPoint, b: &IntegerPoint) -> BigInt {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The vector product.
pub(crate) fn cross(a: &IntegerPoint, b: &IntegerPoint) -> IntegerPoint {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

/// Whole digits with their sign and the exponent of two that they are times.
fn parts(number: f64) -> (i64, i32) {
    let bits = number.to_bits();
    let (fraction, exponent) = ((bits & ((1 << 52) - 1)) as i64, ((bits >> 52) & 0x7ff) as i32);
    let (digits, exponent) = if exponent == 0 { (fraction, 1) } else { (fraction | 1 << 52, exponent) };
    (if number.is_sign_negative() { -digits } else { digits }, exponent - 1075)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_whole_times_one_power_of_two() {
        assert_eq!(integers([0.75, -3.0, 0.0, -0.0]), [3, -12, 0, 0].map(BigInt::from));
        assert_eq!(integers([12.0, 4.0]), [3, 1].map(BigInt::from));
        assert_eq!(integers([5e-324, -1e-323]), [1, -2].map(BigInt::from));
        let [one, huge] = integers([5e-324, 2.0_f64.powi(1000)]);
        assert_eq!((one, huge), (BigInt::from(1), BigInt::from(1) << 2074));
        assert_eq!(integers([0.0; 2]), [BigInt::ZERO; 2]);
    }

    #[test]
    fn small_numbers_are_those_of_any_size() {
        let all = [0.0, -0.0, 1.0, -3.0, 0.75, 5e-324, -1.5e-323, 1e-300, 1e300, 1e9, -1e12, f64::MAX];
        for one in all {
            for other in all {
                // Where all are 0, there is no lowest bit.
                let expected = integers([one, other, 0.0]);
                let is_small = expected.iter().all(|number| number.bits() <= 40);
                let found = small_integers([one, other, 0.0]);
                assert_eq!(found.map(|found| found.map(BigInt::from)), is_small.then_some(expected));
            }
        }
    }
}
