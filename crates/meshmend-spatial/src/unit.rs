//! Units in which lengths and areas in doubles neither under- nor overflow: a power of two near the largest coordinate.

use meshmend_geometry::vector::Point;

/// A power of two, in two factors that doubles hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unit {
    shrinking: [f64; 2],
    growing: [f64; 2],
}

impl Unit {
    /// The one by which a coordinate of this size becomes one of about 1.
    pub(crate) fn of(largest: f64) -> Self {
        let power = if largest > 0.0 { largest.log2().floor().clamp(-1074.0, 1023.0) as i32 } else { 0 };
        let halves = [power / 2, power - power / 2];
        Unit { shrinking: halves.map(|half| 2f64.powi(-half)), growing: halves.map(|half| 2f64.powi(half)) }
    }

    /// A point in this unit.
    pub(crate) fn shrunk(&self, point: Point) -> Point {
        point.map(|x| x * self.shrinking[0] * self.shrinking[1])
    }

    /// A length as it was; at most the largest double.
    pub(crate) fn length(&self, shrunk: f64) -> f64 {
        (shrunk * self.growing[0] * self.growing[1]).min(f64::MAX)
    }

    /// An area as it was; at most the largest double.
    pub(crate) fn area(&self, shrunk: f64) -> f64 {
        self.length(self.length(shrunk))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_bring_any_size_near_to_one_and_back() {
        for size in [5e-324, 1e-300, 0.3, 1.0, 7.0, 1e300, f64::MAX] {
            let unit = Unit::of(size);
            let [x, ..] = unit.shrunk([size, 0.0, 0.0]);
            assert!((1.0..2.0).contains(&x), "{size} {x}");
            assert_eq!(unit.length(x), size);
        }
        assert_eq!(Unit::of(1e300).area(1.0), f64::MAX);
    }
}
