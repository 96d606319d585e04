//! The sign of a number.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

use num_bigint::BigInt;

/// Whether a number is below, at or above 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// Below 0.
    Negative,
    /// 0.
    Zero,
    /// Above 0.
    Positive,
}

impl Sign {
    /// The sign of a double; that of a double that is not a number is zero.
    #[inline]
    pub fn of(number: f64) -> Self {
        if number > 0.0 {
            Sign::Positive
        } else if number < 0.0 {
            Sign::Negative
        } else {
            Sign::Zero
        }
    }

    /// Whether the number is 0.
    #[inline]
    pub fn is_zero(self) -> bool {
        self == Sign::Zero
    }
}

/// The sign of the difference of what was compared.
impl From<Ordering> for Sign {
    fn from(order: Ordering) -> Self {
        match order {
            Ordering::Less => Sign::Negative,
            Ordering::Equal => Sign::Zero,
            Ordering::Greater => Sign::Positive,
        }
    }
}

impl From<&BigInt> for Sign {
    fn from(number: &BigInt) -> Self {
        match number.sign() {
            num_bigint::Sign::Minus => Sign::Negative,
            num_bigint::Sign::NoSign => Sign::Zero,
            num_bigint::Sign::Plus => Sign::Positive,
        }
    }
}

impl Neg for Sign {
    type Output = Sign;
    #[inline]
    fn neg(self) -> Sign {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

/// The sign of the product.
impl Mul for Sign {
    type Output = Sign;
    #[inline]
    fn mul(self, other: Sign) -> Sign {
        match self {
            Sign::Negative => -other,
            Sign::Zero => Sign::Zero,
            Sign::Positive => other,
        }
    }
}
