//! Whether any point of one set is near any of another.
//!
//! Few points are compared pair by pair. Of many, boxes are: sets whose boxes are too far apart have no near pair,
//! where even the farthest corners are near any pair is near, and else the larger set is halved. The bounds are
//! computed as a distance is, and every step of that is monotone in rounding too, so that this is not only fast:
//! it says exactly what comparing all pairs would.

/// Up to so many pairs are compared one by one.
const FEW: usize = 64;

/// A distance, and what is near by it.
#[derive(Clone, Copy, Debug)]
pub struct Nearness {
    distance: f64,
    /// A squared length below this is near, and one above the other is not; between them rounding might decide, so the
    /// lengths are divided by the distance first. That alone is what says it where squares are not normal numbers.
    surely_near: f64,
    surely_far: f64,
}

impl Nearness {
    /// What is within a distance, which is a number of 0 or more: within 0 are points that are equal.
    pub fn within(distance: f64) -> Self {
        let square = distance * distance;
        let (surely_near, surely_far) = if square.is_normal() {
            (square * (1.0 - 1e-12), square * (1.0 + 1e-12))
        } else {
            (0.0, f64::INFINITY)
        };
        Nearness { distance, surely_near, surely_far }
    }

    /// Whether two points are within the distance of each other.
    pub fn are_near(&self, a: [f64; 3], b: [f64; 3]) -> bool {
        self.is_near([a[0] - b[0], a[1] - b[1], a[2] - b[2]])
    }

    fn is_near(&self, way: [f64; 3]) -> bool {
        let [x, y, z] = way;
        let square = x * x + y * y + z * z;
        if square < self.surely_near {
            true
        } else if square > self.surely_far {
            false
        } else {
            way == [0.0; 3]
                || way.iter().map(|part| part / self.distance).map(|part| part * part).sum::<f64>() <= 1.0
        }
    }

    /// Whether any two points, one of each set, are near.
    pub(super) fn any(
        &self,
        one: impl ExactSizeIterator<Item = [f64; 3]> + Clone,
        other: impl ExactSizeIterator<Item = [f64; 3]> + Clone,
    ) -> bool {
        if one.len() * other.len() <= FEW {
            one.into_iter().any(|a| other.clone().any(|b| self.are_near(a, b)))
        } else {
            self.any_by_boxes(&mut one.collect::<Vec<_>>(), &mut other.collect::<Vec<_>>())
        }
    }

    /// The same, by halves, which it reorders. The larger set is halved, so the depth is the logarithm of both sizes.
    fn any_by_boxes(&self, one: &mut [[f64; 3]], other: &mut [[f64; 3]]) -> bool {
        if one.len() * other.len() <= FEW {
            return one.iter().any(|&a| other.iter().any(|&b| self.are_near(a, b)));
        }
        let (a, b) = (Bounds::of(one), Bounds::of(other));
        if !self.is_near(a.least_way(&b)) {
            return false;
        }
        if self.is_near(a.longest_way(&b)) {
            return true;
        }
        let (halved, bounds, whole) =
            if one.len() >= other.len() { (one, a, other) } else { (other, b, one) };
        let axis = bounds.longest_axis();
        let middle = halved.len() / 2;
        halved.select_nth_unstable_by(middle, |p, q| p[axis].total_cmp(&q[axis]));
        let (low, high) = halved.split_at_mut(middle);
        self.any_by_boxes(low, whole) || self.any_by_boxes(high, whole)
    }
}

/// A box along the axes.
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
}

impl Bounds {
    fn of(points: &[[f64; 3]]) -> Self {
        let end = |start, best: fn(f64, f64) -> f64| {
            points.iter().fold([start; 3], |end, p| std::array::from_fn(|axis| best(end[axis], p[axis])))
        };
        Bounds { low: end(f64::INFINITY, f64::min), high: end(f64::NEG_INFINITY, f64::max) }
    }

    fn least_way(&self, other: &Bounds) -> [f64; 3] {
        std::array::from_fn(|axis| {
            (other.low[axis] - self.high[axis]).max(self.low[axis] - other.high[axis]).max(0.0)
        })
    }

    fn longest_way(&self, other: &Bounds) -> [f64; 3] {
        std::array::from_fn(|axis| (other.high[axis] - self.low[axis]).max(self.high[axis] - other.low[axis]))
    }

    fn longest_axis(&self) -> usize {
        let length = |axis: &usize| self.high[*axis] - self.low[*axis];
        (0..3).max_by(|one, other| length(one).total_cmp(&length(other))).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn cloud(size: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f64; 3]>> {
        prop::collection::vec(prop::array::uniform3(-1.0..1.0f64), size)
    }

    proptest! {
        #[test]
        fn boxes_say_what_all_pairs_say(
            one in cloud(1..40),
            other in cloud(1..40),
            way in prop::array::uniform3(-3.0..3.0f64),
            epsilon in 0.01..4.0f64,
        ) {
            let other: Vec<[f64; 3]> = other.iter().map(|p| std::array::from_fn(|i| p[i] + way[i])).collect();
            let is_near = |a: [f64; 3], b: [f64; 3]| {
                (0..3).map(|i| (a[i] - b[i]) / epsilon).map(|part| part * part).sum::<f64>() <= 1.0
            };
            let expected = one.iter().any(|&a| other.iter().any(|&b| is_near(a, b)));
            let near = Nearness::within(epsilon);
            prop_assert_eq!(near.any(one.iter().copied(), other.iter().copied()), expected);
        }
    }

    /// Two dense balls just too far apart: all pairs would be 10¹⁰.
    #[test]
    fn dense_clusters_are_not_compared_pair_by_pair() {
        let ball = |x: f64| {
            (0..100_000u32)
                .map(move |i| [x + f64::from(i % 47) / 1e6, f64::from(i % 101) / 1e6, f64::from(i) / 1e9])
        };
        let near = Nearness::within(1.0);
        assert!(!near.any(ball(0.0), ball(1.001)));
        assert!(near.any(ball(0.0), ball(1.000_01)));
    }

    #[test]
    fn at_the_distance_itself_the_quotient_decides() {
        for distance in [1e-200, 0.1, 0.3, 1e200] {
            let near = Nearness::within(distance);
            assert!(near.is_near([0.0, distance, 0.0]) && near.is_near([-distance, 0.0, 0.0]));
            assert!(!near.is_near([0.0, distance * (1.0 + 1e-15), 0.0]));
            assert!(near.is_near([distance / 2.0; 3]) && !near.is_near([distance; 3]));
        }
    }
}
