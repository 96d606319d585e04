//! The fields over which a rank can be taken.

use std::fmt;

use crate::homology::PrimeField;

/// A field of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Field {
    /// The rationals, ℚ.
    Rationals,
    /// The integers modulo a prime.
    Modulo(Prime),
}

/// A prime number below 2³².
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Prime(u32);

impl Prime {
    /// The prime 2.
    pub const TWO: Prime = Prime(2);

    /// A number as a prime; `None` if it is not one.
    ///
    /// *Cost*: at most 2¹⁵ divisions.
    pub fn new(number: u32) -> Option<Self> {
        is_prime(number).then_some(Prime(number))
    }

    /// The number.
    pub fn number(self) -> u32 {
        self.0
    }

    pub(super) fn field(self) -> PrimeField {
        PrimeField::modulo(self.0)
    }

    /// The primes below 2³¹, from the largest one on.
    pub(super) fn descending() -> impl Iterator<Item = Prime> {
        (2..1u32 << 31).rev().filter_map(Prime::new)
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Field::Rationals => f.pad("Q"),
            Field::Modulo(prime) => f.pad(&format!("Z/{}", prime.0)),
        }
    }
}

fn is_prime(number: u32) -> bool {
    let may_divide = |divisor: &u32| u64::from(*divisor).pow(2) <= u64::from(number);
    match number {
        0 | 1 => false,
        2 => true,
        _ if number.is_multiple_of(2) => false,
        _ => !(3..).step_by(2).take_while(may_divide).any(|divisor| number.is_multiple_of(divisor)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn primes_are_primes() {
        let found: Vec<u32> = (0..60).filter_map(Prime::new).map(Prime::number).collect();
        assert_eq!(found, [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59]);
        assert_eq!(Prime::new(u32::MAX), None);
        // The largest prime below 2³², and a square of a prime near it.
        assert!(Prime::new(4_294_967_291).is_some() && Prime::new(65_521 * 65_521).is_none());
        let largest: Vec<u32> = Prime::descending().take(3).map(Prime::number).collect();
        assert_eq!(largest, [2_147_483_647, 2_147_483_629, 2_147_483_587]);
        assert_eq!(Field::Modulo(Prime::TWO).to_string(), "Z/2");
    }
}
