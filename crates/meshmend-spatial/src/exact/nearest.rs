//! Whole numbers of any size as doubles, for what is shown.

use num_bigint::BigInt;

/// The square root of a quotient of two numbers above 0, to about 15 digits; at most the largest double.
pub(crate) fn root_of_quotient(numerator: &BigInt, denominator: &BigInt) -> f64 {
    let cut = |number: &BigInt| number.bits().saturating_sub(64);
    let [one, other] = [numerator, denominator].map(cut);
    let (a, b) = (doubled(numerator, one), doubled(denominator, other));
    let power = one as i64 - other as i64;
    // An even power has a root.
    let odd = power & 1;
    let root = (a / b * if odd == 1 { 2.0 } else { 1.0 }).sqrt();
    let half = ((power - odd) / 2).clamp(-2100, 2100) as i32;
    (root * 2f64.powi(half / 2) * 2f64.powi(half - half / 2)).min(f64::MAX)
}

/// The first digits of a vector, and the power of two by which they are less than it. They are all 0 only if the vector is.
pub(crate) fn leading_digits(vector: &[BigInt; 3]) -> ([f64; 3], i64) {
    let most = vector.iter().map(BigInt::bits).max().unwrap_or(0);
    let cut = most.saturating_sub(64);
    (vector.each_ref().map(|number| doubled(number, cut)), cut as i64)
}

/// A number less some of its last bits, of which 64 at most are left.
fn doubled(number: &BigInt, cut: u64) -> f64 {
    let digits = (number.magnitude() >> cut).iter_u64_digits().next().unwrap_or(0) as f64;
    if number.sign() == num_bigint::Sign::Minus { -digits } else { digits }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_quotients_are_near_the_true_ones() {
        let big = |x: u32| BigInt::from(x);
        assert_eq!(root_of_quotient(&big(9), &big(4)), 1.5);
        assert_eq!(root_of_quotient(&(big(9) << 2001u32), &(big(2) << 2000u32)), 3.0);
        assert_eq!(root_of_quotient(&big(1), &(big(4) << 600u32)), 2f64.powi(-301));
        assert_eq!(root_of_quotient(&(big(1) << 6000u32), &big(1)), f64::MAX);
    }

    #[test]
    fn digits_of_a_vector_are_cut_alike() {
        let vector = [3, 0, -4].map(|x| BigInt::from(x) << 3000u32);
        let ([x, y, z], power) = leading_digits(&vector);
        assert_eq!((x / z, y), (-0.75, 0.0));
        assert_eq!((x.log2().floor(), power), (62.0, 2939));
        assert_eq!(leading_digits(&[3, 0, -4].map(BigInt::from)), ([3.0, 0.0, -4.0], 0));
        assert_eq!(leading_digits(&[0, 0, 0].map(BigInt::from)), ([0.0; 3], 0));
    }
}
