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
        let add = |bounds: Bounds, point| bounds.with(Bounds { low: point, high: point });
        points.into_iter().fold(Bounds::NONE, add)
    }

    /// The smallest box that holds two boxes.
    #[inline]
    pub fn with(self, other: Self) -> Self {
        Bounds {
            low: std::array::from_fn(|i| if other.low[i] < self.low[i] { other.low[i] } else { self.low[i] }),
            high: std::array::from_fn(|i| {
                if other.high[i] > self.high[i] { other.high[i] } else { self.high[i] }
            }),
        }
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

    /// The point in its middle.
    #[inline]
    pub fn centre(&self) -> Point {
        std::array::from_fn(|i| self.low[i] / 2.0 + self.high[i] / 2.0)
    }
}
