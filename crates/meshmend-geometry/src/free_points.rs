//! Where there is room for a new vertex.
//!
//! A new vertex must stay a vertex of its own when the result is stored, read and compared once more. A point is *free*
//! when no vertex has that position once it is stored, and none is so near that the two would be taken for one.
//!
//! * On an edge or a diagonal: the first free point of 1/2, 1/3, 2/3, 1/4, … 63/64 of the way.
//! * If no such point is free: the first free point beside the middle, along the axis in which the edge is shortest, one step
//!   away, two steps away, and so on. A step is one unit in the last place, or twice the tolerance. There always
//!   is such a point.

use std::collections::{BTreeMap, BTreeSet};

use crate::Precision;
use crate::proximity::Nearness;
use crate::vector::{Point, is_finite, place_bits};

/// How far points have to be from each other so that they stay apart when they are stored, read and compared.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spacing {
    /// How precisely points are stored.
    pub precision: Precision,
    /// How precisely points are told apart when they are compared.
    pub apart: Precision,
    /// Points within this distance of each other become one; 0 if only equal ones do.
    pub tolerance: f64,
}

/// Points that are taken, and where there is room beside them.
pub struct FreePoints {
    spacing: Spacing,
    taken: Taken,
    /// How many steps were tried in vain from a middle along an axis: what is taken stays taken.
    walked: BTreeMap<(Place, usize), u64>,
}

/// A position as bits, −0 being 0.
type Place = [u64; 3];

enum Taken {
    /// As they are told apart.
    Places { places: BTreeSet<Place>, apart: Precision },
    /// By cubes of twice the tolerance: what is within the tolerance is in the same cube or one beside it.
    Cubes { cubes: BTreeMap<[i64; 3], BTreeMap<Place, Point>>, near: Nearness, side: f64 },
}

impl FreePoints {
    /// Beside these vertices.
    ///
    /// *Cost*: O(n log n).
    pub fn beside(spacing: Spacing, vertices: impl Iterator<Item = Point>) -> Self {
        let tolerance = spacing.tolerance;
        let taken = if tolerance > 0.0 {
            let near = Nearness::within(tolerance);
            Taken::Cubes { cubes: BTreeMap::new(), near, side: 2.0 * tolerance }
        } else {
            Taken::Places { places: BTreeSet::new(), apart: spacing.apart }
        };
        let mut free = FreePoints { spacing, taken, walked: BTreeMap::new() };
        vertices.for_each(|vertex| free.taken.insert(vertex));
        free
    }

    /// The first free point on an edge, or beside it, which is then taken; and its place on the edge.
    pub fn on_edge(&mut self, [low, high]: [Point; 2]) -> (Point, (u32, u32)) {
        if let Some((point, ratio)) = self.first_free([low, high]) {
            self.taken.insert(point);
            return (point, ratio);
        }
        let middle = Some(part_of_the_way([low, high], (1, 2)))
            .filter(is_finite)
            .unwrap_or_else(|| mean(&[low, high]));
        let extent = std::array::from_fn(|i| (high[i] - low[i]).abs());
        (self.beside_middle(middle, shortest_axis(extent)), (1, 2))
    }

    /// The mean of some points, or the first free point beside it along the axis in which they are least extended; it is then
    /// taken.
    pub fn amid(&mut self, points: &[Point]) -> Point {
        let middle = self.spacing.precision.round(mean(points));
        if is_finite(&middle) && self.taken.is_free(middle, &mut [None; 2]) {
            self.taken.insert(middle);
            return middle;
        }
        let extent = std::array::from_fn(|axis| {
            let along = || points.iter().map(|point| point[axis]);
            along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
        });
        self.beside_middle(mean(points), shortest_axis(extent))
    }

    /// Whether some point on an edge is free.
    pub fn is_room_on_edge(&self, ends: [Point; 2]) -> bool {
        self.first_free(ends).is_some()
    }

    fn first_free(&self, ends: [Point; 2]) -> Option<(Point, (u32, u32))> {
        let mut last_two = [None; 2];
        ratios().find_map(|ratio| {
            let point = self.spacing.precision.round(part_of_the_way(ends, ratio));
            (is_finite(&point) && self.taken.is_free(point, &mut last_two)).then_some((point, ratio))
        })
    }

    /// The first free point so many steps from a middle along an axis.
    fn beside_middle(&mut self, middle: Point, axis: usize) -> Point {
        let precision = self.spacing.precision;
        let start = precision.round(middle);
        // A point that is not finite equals nothing, so that it is free.
        if !is_finite(&start) {
            return start;
        }
        let origin = (place_bits(middle), axis);
        let mut step = self.walked.get(&origin).copied().unwrap_or(0);
        let (mut last, mut last_two) = ([start; 2], [None; 2]);
        loop {
            step += 1;
            for (side, last) in [1, -1].into_iter().zip(&mut last) {
                let mut point = if self.spacing.tolerance > 0.0 { middle } else { start };
                point[axis] = self.stepped(point[axis], side * step as i64);
                let point = precision.round(point);
                let is_new = place_bits(point) != place_bits(*last);
                *last = point;
                if is_new && is_finite(&point) && self.taken.is_free(point, &mut last_two) {
                    self.walked.insert(origin, step - 1);
                    self.taken.insert(point);
                    return point;
                }
            }
        }
    }

    fn stepped(&self, x: f64, steps: i64) -> f64 {
        let Spacing { apart, tolerance, .. } = self.spacing;
        if tolerance > 0.0 { x + steps as f64 * (2.0 * tolerance) } else { apart.moved(x, steps) }
    }
}

impl Taken {
    fn insert(&mut self, point: Point) {
        match self {
            Taken::Places { places, apart } => {
                places.insert(place_bits(apart.round(point)));
            }
            Taken::Cubes { cubes, side, .. } => {
                if is_finite(&point) {
                    cubes.entry(cube(point, *side)).or_default().insert(place_bits(point), point);
                }
            }
        }
    }

    /// Whether a point is free. The two vertices that were last found to be near are asked first: along an edge they are
    /// its ends, again and again.
    fn is_free(&self, point: Point, last_two: &mut [Option<Point>; 2]) -> bool {
        match self {
            Taken::Places { places, apart } => {
                let point = apart.round(point);
                // A point that is beyond single precision equals nothing.
                !is_finite(&point) || !places.contains(&place_bits(point))
            }
            Taken::Cubes { cubes, near, side } => {
                if last_two.iter().flatten().any(|&vertex| near.are_near(vertex, point)) {
                    return false;
                }
                let home = cube(point, *side);
                let beside = std::iter::once([0; 3]).chain(steps_round());
                let at = beside.filter_map(|step| cubes.get(&std::array::from_fn(|i| home[i] + step[i])));
                let found = at.flat_map(BTreeMap::values).find(|&&vertex| near.are_near(vertex, point));
                if let Some(&vertex) = found {
                    *last_two = [Some(vertex), last_two[0]];
                }
                found.is_none()
            }
        }
    }
}

fn part_of_the_way([low, high]: [Point; 2], (n, d): (u32, u32)) -> Point {
    std::array::from_fn(|i| low[i] + (high[i] - low[i]) * f64::from(n) / f64::from(d))
}

/// 1/2, 1/3, 2/3, 1/4, … 63/64.
fn ratios() -> impl Iterator<Item = (u32, u32)> {
    (2..=64).flat_map(|d| (1..d).map(move |n| (n, d)))
}

/// All steps to a cube beside another one.
fn steps_round() -> impl Iterator<Item = [i64; 3]> {
    (0..27).filter(|&step| step != 13).map(|step| [step / 9 - 1, step / 3 % 3 - 1, step % 3 - 1])
}

fn cube(point: Point, side: f64) -> [i64; 3] {
    point.map(|x| ((x / side).floor() as i64).clamp(i64::MIN + 1, i64::MAX - 1))
}

fn mean(points: &[Point]) -> Point {
    let count = points.len() as f64;
    std::array::from_fn(|axis| points.iter().map(|p| p[axis] / count).sum())
}

/// The first axis along which an extent is least.
fn shortest_axis(extent: Point) -> usize {
    (1..3).fold(0, |least, axis| if extent[axis] < extent[least] { axis } else { least })
}

#[cfg(test)]
mod tests {
    use super::*;

    const ENDS: [Point; 2] = [[0.0; 3], [8.0, 4.0, 4.0]];

    fn spacing(precision: Precision, tolerance: f64) -> Spacing {
        Spacing { precision, apart: precision, tolerance }
    }

    /// Where vertices that are equal in single precision are joined, a created one differs from all in that sense, and
    /// need not be rounded itself.
    #[test]
    fn what_is_told_apart_in_single_precision_needs_room_there() {
        let apart = Spacing { apart: Precision::Single, ..Spacing::default() };
        let ends = [[1.0, 0.0, 0.0], [1.0 + 1e-9, 1e-9, 0.0]];
        let mut free = beside(apart, &ends);
        let found = free.on_edge(ends).0;
        assert_eq!(found, [1.0 + 5e-10, 5e-10, 0.0]);
        let ends = [[1.0, 1.0, 1.0], [1.0 + 1e-9, 1.0, 1.0]];
        let mut free = beside(apart, &ends);
        let beside_edge: Vec<f64> = (0..2).map(|_| free.on_edge(ends).0[1]).collect();
        assert_eq!(beside_edge, [1.0_f32.next_up(), 1.0_f32.next_down()].map(f64::from));
        let ends = [[1e39, 0.0, 0.0], [1.5e39, 0.0, 0.0]];
        let middle = 1e39 + (1.5e39 - 1e39) / 2.0;
        assert_eq!(beside(apart, &ends).on_edge(ends), ([middle, 0.0, 0.0], (1, 2)));
    }

    fn beside(spacing: Spacing, vertices: &[Point]) -> FreePoints {
        FreePoints::beside(spacing, vertices.iter().copied())
    }

    #[test]
    fn an_edge_has_room_in_the_middle_then_at_a_third_and_so_on() {
        let mut free = beside(Spacing::default(), &ENDS);
        let found: Vec<(Point, (u32, u32))> = (0..3).map(|_| free.on_edge(ENDS)).collect();
        assert_eq!(found[0], ([4.0, 2.0, 2.0], (1, 2)));
        assert_eq!([found[1].1, found[2].1], [(1, 3), (2, 3)]);
        assert_eq!(found[1].0, [8.0 / 3.0, 4.0 / 3.0, 4.0 / 3.0]);
    }

    #[test]
    fn where_the_ends_are_neighbours_among_numbers_there_is_room_beside_the_edge() {
        let up = 1.0f64.next_up();
        let ends = [[1.0, 1.0, 1.0], [up, 1.0, up]];
        let mut free = beside(Spacing::default(), &ends);
        // The edge has no extent along the second axis.
        let beside_edge: Vec<Point> = (0..4).map(|_| free.on_edge(ends).0).collect();
        let middle = |y: f64| [1.0 + (up - 1.0) * 0.5, y, 1.0 + (up - 1.0) * 0.5];
        let [above, below] = [up, 1.0f64.next_down()];
        let expected = [above, below, above.next_up(), below.next_down()].map(middle);
        assert_eq!(beside_edge, expected);
    }

    #[test]
    fn steps_lead_through_zero_and_past_numbers_that_are_too_large() {
        let tiny = f64::from_bits(1);
        let ends = [[0.0, -tiny, 0.0], [tiny, 0.0, 0.0]];
        let mut free = beside(Spacing::default(), &ends);
        let heights: Vec<f64> = (0..3).map(|_| free.on_edge(ends).0[2]).collect();
        assert_eq!(heights, [tiny, -tiny, 2.0 * tiny]);
        let ends = [[f64::MAX; 3], [f64::MAX; 3]];
        let mut free = beside(Spacing::default(), &ends);
        let found: Vec<f64> = (0..2).map(|_| free.on_edge(ends).0[0]).collect();
        assert_eq!(found, [f64::MAX.next_down(), f64::MAX.next_down().next_down()]);
    }

    #[test]
    fn an_edge_that_is_longer_than_any_number_has_a_middle() {
        let ends = [[-f64::MAX, 0.0, 0.0], [f64::MAX, 0.0, 0.0]];
        let mut free = beside(Spacing::default(), &ends);
        assert_eq!(free.on_edge(ends).0, [0.0, f64::from_bits(1), 0.0]);
    }

    #[test]
    fn amid_points_is_their_mean_or_beside_it_where_they_are_flat() {
        let square = [[0.0; 3], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
        let mut free = beside(Spacing::default(), &square);
        let tiny = f64::from_bits(1);
        assert_eq!([(); 3].map(|()| free.amid(&square)), [0.0, tiny, -tiny].map(|z| [1.0, 1.0, z]));
    }

    #[test]
    fn what_is_nowhere_is_free() {
        let ends = [[f64::NAN; 3], [1.0; 3]];
        let mut free = beside(Spacing::default(), &ends);
        assert!(free.on_edge(ends).0[0].is_nan() && free.on_edge(ends).0[0].is_nan());
    }

    #[test]
    fn within_a_tolerance_nothing_is_free() {
        // 1/3 and 2/3 are as near to the ends as 1/2 is to the vertex that is there.
        let vertices = [ENDS[0], ENDS[1], [4.0, 2.0, 2.5]];
        let found = |tolerance| beside(spacing(Precision::Double, tolerance), &vertices).on_edge(ENDS);
        assert_eq!(found(0.4).1, (1, 2));
        assert_eq!(found(0.5).1, (1, 3));
        // Nothing on the edge is farther from its ends than 5: two tolerances beside the middle.
        assert_eq!(found(5.0), ([4.0, 12.0, 2.0], (1, 2)));
    }

    #[test]
    fn all_points_that_were_taken_are_apart() {
        let spacing = spacing(Precision::Double, 0.3);
        let near = Nearness::within(0.3);
        let mut free = beside(spacing, &[[0.0; 3], [1.0, 0.0, 0.0]]);
        let mut points = vec![[0.0; 3], [1.0, 0.0, 0.0]];
        for _ in 0..100 {
            let (point, _) = free.on_edge([[0.0; 3], [1.0, 0.0, 0.0]]);
            assert!(points.iter().all(|&other| !near.are_near(other, point)), "{point:?}");
            points.push(point);
        }
    }

    #[test]
    fn points_are_rounded_before_it_is_asked_whether_they_are_free() {
        let up = f64::from(1.0f32.next_up());
        let ends = [[1.0, 0.0, 0.0], [up, 0.0, 0.0]];
        let double = beside(Spacing::default(), &ends).on_edge(ends);
        assert_eq!(double.1, (1, 2));
        let mut free = beside(spacing(Precision::Single, 0.0), &ends);
        let tiny = f64::from(f32::from_bits(1));
        // Of the two numbers beside the middle the one whose last bit is 0.
        assert_eq!(free.on_edge(ends).0, [1.0, tiny, 0.0]);
        assert_eq!(free.on_edge(ends).0, [1.0, -tiny, 0.0]);
        // A step of less than a unit in the last place leads nowhere until there are enough of them.
        let wide = [[1e6, 0.0, 0.0], [1e6, 0.0, 1e-3]];
        let mut free = beside(spacing(Precision::Single, 1e-3), &wide);
        let (point, _) = free.on_edge(wide);
        assert_eq!(Precision::Single.round(point), point);
        assert!(point[0] > 1e6, "{point:?}");
    }

    #[test]
    fn a_step_is_a_unit_in_the_last_place_on_both_sides_of_zero() {
        for precision in [Precision::Double, Precision::Single] {
            for x in [-1.5, -0.0, 0.0, 2.0] {
                let [up, down] = [1, -1].map(|steps| precision.moved(x, steps));
                assert!(down < x && x < up, "{x}: {down} {up}");
                assert_eq!(precision.moved(up, -1), x + 0.0);
                assert_eq!(precision.round([up; 3]), [up; 3]);
            }
        }
        assert_eq!(Precision::Double.moved(1.0, 1), 1.0f64.next_up());
        assert_eq!(Precision::Single.moved(-1.0, 2), f64::from((-1.0f32).next_up().next_up()));
    }
}
