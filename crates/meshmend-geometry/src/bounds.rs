//! The box along the axes in which points lie.

use rayon::prelude::*;

use crate::vector::{Point, is_finite};

/// The bounding box's diagonal, finite points only; halved on the way so that it can't overflow early.
pub fn diagonal(points: &[Point]) -> f64 {
    let Some((low, high)) = bounds(points) else { return 0.0 };
    let half = |axis: usize| high[axis] / 2.0 - low[axis] / 2.0;
    let diagonal = 2.0 * half(0).hypot(half(1)).hypot(half(2));
    diagonal.min(f64::MAX)
}

/// Points of a piece of work.
const CHUNK: usize = 1 << 14;

/// The lowest and highest coordinates of the finite points, if there are any.
pub(crate) fn bounds(points: &[Point]) -> Option<([f64; 3], [f64; 3])> {
    let none = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let of_chunk = |points: &[Point]| {
        let (mut low, mut high) = none;
        for point in points.iter().filter(|p| is_finite(p)) {
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        (low, high)
    };
    let joined = |a: ([f64; 3], [f64; 3]), b: ([f64; 3], [f64; 3])| {
        (std::array::from_fn(|i| a.0[i].min(b.0[i])), std::array::from_fn(|i| a.1[i].max(b.1[i])))
    };
    let bounds = points.par_chunks(CHUNK).map(of_chunk).reduce(|| none, joined);
    (bounds.0[0] <= bounds.1[0]).then_some(bounds)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_diagonal_of_a_huge_box_is_finite() {
        assert_eq!(diagonal(&[[-1e308; 3], [1e308; 3]]), f64::MAX);
        assert_eq!(diagonal(&[[0.0; 3], [2.0, 3.0, 6.0], [f64::NAN; 3]]), 7.0);
        assert_eq!(diagonal(&[[-1.0, 5.0, -4.0], [1.0, 2.0, 2.0]]), 7.0);
        assert_eq!(diagonal(&[]), 0.0);
    }
}
