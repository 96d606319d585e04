//! A box along the axes.

use meshmend_geometry::vector::Point;

/// The points between a lowest and a highest one, both included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least of each coordinate.
    pub low: Point,
    /// The greatest of each coordinate.
    pub high: Point,
}

impl Bounds {
    /// A box that holds no point.
    pub const NONE: Bounds = Bounds { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };

    /// The smallest box that holds some points.
    #[inline]
    pub fn of(points: impl IntoIterator<Item = Point>) -> Self {
        let mut bounds = Bounds::NONE;
        for point in points {
            bounds = bounds.with(&Bounds { low: point, high: point });
        }
        bounds
    }

    /// The smallest box that holds two boxes.
    #[inline]
    pub fn with(&self, other: &Self) -> Self {
        let ([a, b, c], [p, q, r]) = (self.low, other.low);
        let low = [lesser(a, p), lesser(b, q), lesser(c, r)];
        let ([a, b, c], [p, q, r]) = (self.high, other.high);
        Bounds { low, high: [greater(a, p), greater(b, q), greater(c, r)] }
    }

    /// Whether two boxes have a point in common.
    #[inline]
    pub fn overlaps(&self, other: &Self) -> bool {
        // All of it at once: branches in between would be guessed wrong.
        (self.low[0] <= other.high[0])
            & (other.low[0] <= self.high[0])
            & (self.low[1] <= other.high[1])
            & (other.low[1] <= self.high[1])
            & (self.low[2] <= other.high[2])
            & (other.low[2] <= self.high[2])
    }

    /// The length of its longest side, within rounding.
    #[inline]
    pub fn size(&self) -> f64 {
        let ([a, b, c], [p, q, r]) = (self.low, self.high);
        greater(greater(p - a, q - b), r - c)
    }

    /// The point in its middle.
    #[inline]
    pub fn centre(&self) -> Point {
        let ([a, b, c], [p, q, r]) = (self.low, self.high);
        [a / 2.0 + p / 2.0, b / 2.0 + q / 2.0, c / 2.0 + r / 2.0]
    }
}

// What `f64::min` and `f64::max` say of numbers, without their care for what is none.
#[inline]
fn lesser(one: f64, other: f64) -> f64 {
    if other < one { other } else { one }
}
#[inline]
fn greater(one: f64, other: f64) -> f64 {
    if other > one { other } else { one }
}
