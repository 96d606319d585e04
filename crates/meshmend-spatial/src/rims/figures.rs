//! What a loop encloses, in doubles; its direction exactly enough however thin it is.

use meshmend_geometry::vector::{Point, cross, length, minus};
use num_bigint::BigInt;

use crate::exact::integers::{self, IntegerPoint, integer, lowest_exponent};
use crate::exact::nearest::leading_digits;

/// What a loop encloses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LoopArea {
    /// Twice its area, as seen along its direction.
    pub(super) twice: f64,
    /// The direction from which it is seen to run anticlockwise, of length 1; `None` only where the area is exactly 0.
    pub(super) direction: Option<Point>,
}

impl LoopArea {
    /// What a loop of shrunk points encloses. Its direction has digits however thin the loop is.
    ///
    /// *Cost*: linear; some microseconds a point where rounding leaves no digits.
    pub(super) fn of(points: &[Point]) -> Self {
        let Some(&first) = points.first() else { return LoopArea::default() };
        let (mut sum, mut size) = ([0.0; 3], 0.0);
        for side in points.windows(2) {
            let (a, b) = (minus(side[0], first), minus(side[1], first));
            let part = cross(a, b);
            sum = std::array::from_fn(|i| sum[i] + part[i]);
            size += length(a) * length(b);
        }
        let error = f64::EPSILON * (points.len() as f64 + 8.0) * size;
        let twice = length(sum);
        if twice > DIGITS * error && twice > SMALLEST {
            return LoopArea { twice, direction: Some(sum.map(|x| x / twice)) };
        }
        LoopArea::exactly(points)
    }

    fn exactly(points: &[Point]) -> Self {
        let lowest = lowest_exponent(points.iter().flatten());
        let whole = |point: &Point| point.map(|x| integer(x, lowest));
        let Some(first) = points.first().map(whole) else { return LoopArea::default() };
        let mut sum: IntegerPoint = std::array::from_fn(|_| BigInt::ZERO);
        for side in points.windows(2) {
            let [a, b] = [&side[0], &side[1]].map(|point| integers::minus(&whole(point), &first));
            let part = integers::cross(&a, &b);
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
        }
        let (digits, power) = leading_digits(&sum);
        let size = length(digits);
        if size == 0.0 {
            return LoopArea::default();
        }
        let quarter = ((power + 2 * i64::from(lowest)) / 4) as i32;
        let rest = (power + 2 * i64::from(lowest)) as i32 - 3 * quarter;
        let twice = size * 2f64.powi(quarter).powi(3) * 2f64.powi(rest);
        LoopArea { twice, direction: Some(digits.map(|x| x / size)) }
    }
}

/// How many times the error of rounding an area vector has to be for its direction to be told from it.
const DIGITS: f64 = 1e6;

/// The length below which products may have underflowed.
const SMALLEST: f64 = 1e-140;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_of_hardly_any_area_have_a_direction_and_those_of_none_have_not() {
        let thin = [[0.0; 3], [1.0, 1.0, 0.0], [2.0, 2f64.next_up(), 0.0]];
        let area = LoopArea::of(&thin);
        assert_eq!((area.direction, area.twice), (Some([0.0, 0.0, 1.0]), 2f64.next_up() - 2.0));
        let square = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let area = LoopArea::of(&square);
        assert_eq!((area.twice, area.direction), (2.0, Some([0.0, 0.0, 1.0])));
        assert_eq!(LoopArea::exactly(&square), area);
        let slit = [[0.1, 0.1, 0.1], [0.3, 0.3, 0.3], [0.7, 0.7, 0.7], [0.2, 0.2, 0.2]];
        assert_eq!(LoopArea::of(&slit), LoopArea::default());
        let tiny = square.map(|point| point.map(|x| x * 1e-155));
        let area = LoopArea::of(&tiny);
        assert_eq!(area.direction, Some([0.0, 0.0, 1.0]));
        assert!((area.twice - 2e-310).abs() < 1e-312, "{}", area.twice);
    }
}
