//! Points in boxes in boxes, for those near a segment.

use std::convert::Infallible;

use meshmend_geometry::vector::{Point, minus};

/// Most points of a box that is not divided.
const LEAF: usize = 8;

/// Points of a box before whose division it is asked whether to go on.
const LARGE: usize = 1 << 14;

/// A tree of boxes over finite points.
pub(crate) struct PointTree {
    /// The points with their numbers, in the order of the boxes.
    points: Vec<(Point, u32)>,
    /// The boxes; the first one has all points.
    boxes: Vec<PointBox>,
}

struct PointBox {
    low: Point,
    high: Point,
    first: u32,
    end: u32,
    /// The second half's box; the first half's is the next one. 0 where it is not divided.
    second: u32,
}

impl PointTree {
    /// A tree over points, numbered as they come.
    ///
    /// *Cost*: O(n log n); 40 bytes a point.
    pub(crate) fn of(points: impl Iterator<Item = Point>) -> Self {
        let Ok(tree) = Self::watched(points, &|| Ok::<(), Infallible>(()));
        tree
    }

    /// The same. From time to time it is asked whether to go on.
    pub(crate) fn watched<E>(
        points: impl Iterator<Item = Point>,
        goes_on: &impl Fn() -> Result<(), E>,
    ) -> Result<Self, E> {
        let points = points.zip(0u32..).collect();
        let mut tree = PointTree { points, boxes: Vec::new() };
        if !tree.points.is_empty() {
            tree.divide(0, tree.points.len(), goes_on)?;
        }
        Ok(tree)
    }

    /// Makes the boxes of some points; no deeper than the logarithm of their number.
    fn divide<E>(&mut self, first: usize, end: usize, goes_on: &impl Fn() -> Result<(), E>) -> Result<(), E> {
        let points = &mut self.points[first..end];
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for (point, _) in &*points {
            low = std::array::from_fn(|i| low[i].min(point[i]));
            high = std::array::from_fn(|i| high[i].max(point[i]));
        }
        let here = self.boxes.len();
        self.boxes.push(PointBox { low, high, first: first as u32, end: end as u32, second: 0 });
        if points.len() <= LEAF {
            return Ok(());
        }
        if points.len() >= LARGE {
            goes_on()?;
        }
        let size = |axis: usize| high[axis] / 2.0 - low[axis] / 2.0;
        let axis = (1..3).fold(0, |most, axis| if size(axis) > size(most) { axis } else { most });
        let middle = points.len() / 2;
        points.select_nth_unstable_by(middle, |(a, one), (b, other)| {
            a[axis].total_cmp(&b[axis]).then(one.cmp(other))
        });
        self.divide(first, first + middle, goes_on)?;
        self.boxes[here].second = self.boxes.len() as u32;
        self.divide(first + middle, end, goes_on)
    }

    /// Visits the numbers of all points that are not farther than a distance from a segment, and of some others near it.
    ///
    /// *Cost*: logarithmic for each that is visited, unless the points crowd round the segment.
    pub(crate) fn visit_near(&self, segment: [Point; 2], within: f64, mut visit: impl FnMut(u32)) {
        let segment = Segment::of(segment, within);
        let mut open = vec![0u32];
        while let Some(place) = open.pop() {
            let Some(here) = self.boxes.get(place as usize) else { continue };
            if !segment.may_be_near(here.low, here.high) {
                continue;
            }
            if here.second > 0 {
                open.extend([here.second, place + 1]);
                continue;
            }
            for (point, number) in &self.points[here.first as usize..here.end as usize] {
                if segment.may_be_near(*point, *point) {
                    visit(*number);
                }
            }
        }
    }
}

/// A segment with all that is within a distance of it.
struct Segment {
    low: Point,
    high: Point,
    from: Point,
    along: Point,
    within: f64,
}

impl Segment {
    fn of([from, to]: [Point; 2], within: f64) -> Self {
        Segment {
            low: std::array::from_fn(|i| (from[i].min(to[i]) - within).next_down()),
            high: std::array::from_fn(|i| (from[i].max(to[i]) + within).next_up()),
            from,
            along: minus(to, from),
            within,
        }
    }

    /// Whether something in a box may be within the distance: `false` only if that is sure.
    fn may_be_near(&self, low: Point, high: Point) -> bool {
        if (0..3).any(|i| high[i] < self.low[i] || low[i] > self.high[i]) {
            return false;
        }
        // Whether the box lies beside the segment, seen along an axis.
        let is_beside = |axis: usize| {
            let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
            let middle = |k: usize| low[k] / 2.0 + high[k] / 2.0 - self.from[k];
            let half = |k: usize| high[k] / 2.0 - low[k] / 2.0;
            let [x, y] = [self.along[i], self.along[j]];
            let (p, q) = (x * middle(j), y * middle(i));
            let size = x.abs() * half(j) + y.abs() * half(i) + self.within * (x.abs() + y.abs());
            let coordinates = [i, j].map(|k| low[k].abs().max(high[k].abs()).max(self.from[k].abs()));
            let rounding = (x.abs() + y.abs()) * (coordinates[0] + coordinates[1]) * 1e-12;
            (p - q).abs() > size + rounding + f64::MIN_POSITIVE
        };
        !(0..3).any(is_beside)
    }
}

#[cfg(test)]
mod tests {
    use meshmend_geometry::vector::{dot, length};
    use proptest::prelude::*;

    use super::*;

    fn distance(point: Point, [from, to]: [Point; 2]) -> f64 {
        let (along, off) = (minus(to, from), minus(point, from));
        let share = (dot(off, along) / dot(along, along)).clamp(0.0, 1.0);
        length(minus(off, along.map(|x| x * share)))
    }

    proptest! {
        #[test]
        fn all_that_is_near_is_visited(
            points in prop::collection::vec(prop::array::uniform3(-8i32..9), 2..80),
            within in 0.0f64..2.0,
        ) {
            let points: Vec<Point> = points.into_iter().map(|point| point.map(f64::from)).collect();
            let segment = [points[0], points[1]];
            let tree = PointTree::of(points.iter().copied());
            let mut visited = Vec::new();
            tree.visit_near(segment, within, |number| visited.push(number as usize));
            visited.sort_unstable();
            for (number, &point) in points.iter().enumerate() {
                if distance(point, segment) < within - 1e-9 || within == 0.0 && distance(point, segment) == 0.0 {
                    prop_assert!(visited.binary_search(&number).is_ok());
                }
                if distance(point, segment) > 4.0 * within + 1e-3 {
                    prop_assert!(visited.binary_search(&number).is_err());
                }
            }
        }
    }
}
