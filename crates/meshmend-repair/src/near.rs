//! Which points are within a distance of each other, without missing a pair across a cell's wall.
//!
//! Space is divided into cubes so small that any two points in one cube are near, and eight cubes along each axis are a
//! cell. Near points are in cubes up to two steps apart, so in one cell or in cells beside each other:
//!
//! ```text
//! ┌─┬─┬─┬─┬─┬─┬─┬─╥─┬─┬─┬─      points are sorted by cell and cube; for each row of cells beside a cell a pointer
//! ├─┼─┼─┼─┼a┼b┼─┼─╫─┼─┼─┼─      runs along once
//! ├─┼─┼─┼─┼─┼─┼─┼─╫─┼─┼─┼─      a and b: compared within the cell; they reach no cell beside it
//! ├─┼─┼─┼─┼─┼─┼─┼c╫d┼─┼─┼─      c and d: compared across the wall
//! ```
//!
//! Cubes are only compared while they are not joined already.

mod ahead;
mod pairs;
mod places;

use meshmend_core::{Id, VertexId};
use petgraph::unionfind::UnionFind;
use rayon::prelude::*;

use crate::{Context, PassError};
use ahead::{AHEAD, ROWS, ahead_in_row, reaches};
pub(crate) use pairs::Nearness;
use places::{Grid, InCell, Packed, Places, Spread, steps_between};

/// The side of a cube in parts of the distance. Less than 1/√3, so that a cube's diagonal is within the distance, and
/// more than 1/2, so that the distance is within two sides; both by more than what quotients are rounded by.
const SIDE: f64 = 0.54;

/// How many cubes apart along an axis near points may be.
const REACH: i8 = 2;

/// Quotients of this size have no fraction left to tell cubes apart reliably.
const LARGEST_QUOTIENT: f64 = (1u64 << 48) as f64;

/// After so many cells a request to stop is looked for.
const CELLS_BETWEEN_LOOKS: usize = 1 << 16;

/// For each point the lowest one of its class: the connected components of "distance ≤ ε" among the finite points.
///
/// *Cost*: sorting the points; some 40 bytes a point, 60 and more where few are near each other.
///
/// # Errors
/// When ε is so small beside the coordinates that doubles can't resolve it.
pub(crate) fn classes(
    points: &[[f64; 3]],
    epsilon: f64,
    context: &Context<'_>,
) -> Result<Vec<VertexId>, PassError> {
    let side = epsilon * SIDE;
    let Some((low, high)) = bounds(points) else { return Ok((0..points.len()).map(VertexId::new).collect()) };
    let extent = low.iter().chain(&high).fold(0.0f64, |most, x| most.max(x.abs()));
    if side < f64::MIN_POSITIVE || extent / side > LARGEST_QUOTIENT {
        let reason = format!(
            "a tolerance of {epsilon:e} can't be resolved by coordinates as large as {extent:e}; weld exactly instead"
        );
        return Err(PassError::Request { pass: "weld", reason });
    }
    let (grid, near) = (Grid::of_side(side), Nearness::within(epsilon));
    match Packed::between(grid, low, high) {
        Some(places) => Cloud::new(points, near, places).classes(context),
        None => Cloud::new(points, near, Spread(grid)).classes(context),
    }
}

/// The bounding box's diagonal, finite points only; halved on the way so that it can't overflow early.
pub(crate) fn diagonal(points: &[[f64; 3]]) -> f64 {
    let Some((low, high)) = bounds(points) else { return 0.0 };
    let half = |axis: usize| high[axis] / 2.0 - low[axis] / 2.0;
    let diagonal = 2.0 * half(0).hypot(half(1)).hypot(half(2));
    diagonal.min(f64::MAX)
}

/// Points of a piece of work.
const CHUNK: usize = 1 << 14;

/// The lowest and highest coordinates of the finite points, if there are any.
fn bounds(points: &[[f64; 3]]) -> Option<([f64; 3], [f64; 3])> {
    let none = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let of_chunk = |points: &[[f64; 3]]| {
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

/// Whether a point is somewhere.
pub(crate) fn is_finite(point: &[f64; 3]) -> bool {
    point.iter().all(|x| x.is_finite())
}

/// Points by cell and cube.
struct Cloud<'a, P: Places> {
    points: &'a [[f64; 3]],
    near: Nearness,
    places: P,
    /// The finite points by cell, then cube, then name.
    order: Vec<u32>,
    /// The cubes that have points, with where those begin, and one more.
    cubes: Vec<(InCell, u32)>,
    /// One position of each cube: mostly it is near enough, and the others need not be looked up.
    firsts: Vec<[f64; 3]>,
    cells: Vec<P::Cell>,
    /// Where the cubes of each cell begin, and one more.
    cell_cubes: Vec<u32>,
}

impl<'a, P: Places> Cloud<'a, P> {
    fn new(points: &'a [[f64; 3]], near: Nearness, places: P) -> Self {
        let mut order = Vec::with_capacity(points.len());
        let (mut cubes, mut cells, mut cell_cubes) = (Vec::new(), Vec::new(), Vec::new());
        let mut last = None;
        places.visit_sorted(points, |cell, at, point| {
            if last != Some((cell, at)) {
                if last.is_none_or(|(last_cell, _)| last_cell != cell) {
                    cell_cubes.push(cubes.len() as u32);
                    cells.push(cell);
                }
                cubes.push((at, order.len() as u32));
                last = Some((cell, at));
            }
            order.push(point);
        });
        cell_cubes.push(cubes.len() as u32);
        let first = |&(_, start): &(InCell, u32)| points[order[start as usize] as usize];
        let firsts = cubes.par_iter().map(first).collect();
        cubes.push((0, order.len() as u32));
        Cloud { near, places, points, firsts, order, cubes, cells, cell_cubes }
    }

    fn classes(&self, context: &Context<'_>) -> Result<Vec<VertexId>, PassError> {
        let mut joined = UnionFind::new(self.cubes.len() - 1);
        let mut rows = ROWS.map(|step| (step, 0));
        for (cell, &place) in self.cells.iter().enumerate() {
            if cell % CELLS_BETWEEN_LOOKS == 0 {
                context.check_cancelled()?;
            }
            self.join_within(cell, &mut joined);
            let cubes = &self.cubes[self.cubes_of(cell)];
            let ahead = cubes.iter().fold(0, |ahead, &(at, _)| ahead | AHEAD[at as usize]);
            for (row, ([dx, dy], next)) in rows.iter_mut().enumerate() {
                let mut steps = ahead_in_row(ahead, row).peekable();
                if steps.peek().is_none() {
                    continue;
                }
                *next += self.cells_before(*next, self.places.beside(place, [*dx, *dy, -1]));
                let mut other = *next;
                for dz in steps {
                    let step = [*dx, *dy, dz];
                    let wanted = self.places.beside(place, step);
                    other += self.cells_before(other, wanted);
                    if self.cells.get(other) == Some(&wanted) {
                        self.join_across(cell, other, step, &mut joined);
                    }
                }
            }
        }
        Ok(self.lowest(&mut joined))
    }

    /// How many cells from this one on come before a place.
    fn cells_before(&self, first: usize, place: P::Cell) -> usize {
        self.cells[first..].iter().take_while(|&&other| other < place).count()
    }

    fn cubes_of(&self, cell: usize) -> std::ops::Range<usize> {
        self.cell_cubes[cell] as usize..self.cell_cubes[cell + 1] as usize
    }

    fn join_within(&self, cell: usize, joined: &mut UnionFind<u32>) {
        let cubes = self.cubes_of(cell);
        for one in cubes.clone() {
            for other in one + 1..cubes.end {
                let way = steps_between(self.cubes[one].0, self.cubes[other].0, [0; 3]);
                // They are sorted along the first axis.
                if way[0] > REACH {
                    break;
                }
                self.join_cubes(one, other, way, joined);
            }
        }
    }

    /// Joins the cubes of a cell with those of the cell a step away.
    fn join_across(&self, cell: usize, beside: usize, step: [i8; 3], joined: &mut UnionFind<u32>) {
        for one in self.cubes_of(cell).filter(|&one| reaches(self.cubes[one].0, step)) {
            for other in self.cubes_of(beside) {
                let way = steps_between(self.cubes[one].0, self.cubes[other].0, step);
                if way[0] > REACH {
                    break;
                }
                self.join_cubes(one, other, way, joined);
            }
        }
    }

    /// Joins two cubes so many steps apart, if they have near points.
    fn join_cubes(&self, one: usize, other: usize, way: [i8; 3], joined: &mut UnionFind<u32>) {
        let are_beside = way.iter().all(|steps| steps.abs() <= REACH);
        if are_beside
            && !joined.equiv(one as u32, other as u32)
            && (self.near.are_near(self.firsts[one], self.firsts[other])
                || self.near.any(self.positions_of(one), self.positions_of(other)))
        {
            joined.union(one as u32, other as u32);
        }
    }

    fn points_of(&self, cube: usize) -> std::ops::Range<usize> {
        self.cubes[cube].1 as usize..self.cubes[cube + 1].1 as usize
    }

    fn positions_of(&self, cube: usize) -> impl ExactSizeIterator<Item = [f64; 3]> + Clone {
        self.order[self.points_of(cube)].iter().map(|&point| self.points[point as usize])
    }

    /// The lowest point of the class of each point.
    fn lowest(&self, joined: &mut UnionFind<u32>) -> Vec<VertexId> {
        let count = self.cubes.len() - 1;
        let mut lowest_of = vec![u32::MAX; count];
        for cube in 0..count {
            let root = joined.find_mut(cube as u32) as usize;
            // The points of a cube are sorted.
            lowest_of[root] = lowest_of[root].min(self.order[self.points_of(cube).start]);
        }
        let mut lowest: Vec<VertexId> = (0..self.points.len()).map(VertexId::new).collect();
        for cube in 0..count {
            let class = VertexId(lowest_of[joined.find(cube as u32) as usize]);
            for &point in &self.order[self.points_of(cube)] {
                lowest[point as usize] = class;
            }
        }
        lowest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lowest(points: &[[f64; 3]], epsilon: f64) -> Vec<u32> {
        classes(points, epsilon, &Context::default()).unwrap().iter().map(|v| v.0).collect()
    }

    /// The definition, pair by pair.
    fn naive(points: &[[f64; 3]], epsilon: f64) -> Vec<u32> {
        let mut sets = UnionFind::<u32>::new(points.len());
        for a in 0..points.len() {
            for b in 0..a {
                let d: f64 = (0..3).map(|i| ((points[a][i] - points[b][i]) / epsilon).powi(2)).sum();
                if d <= 1.0 {
                    sets.union(a as u32, b as u32);
                }
            }
        }
        (0..points.len()).map(|v| (0..=v).find(|&u| sets.equiv(u as u32, v as u32)).unwrap() as u32).collect()
    }

    /// Numbers from −1/2 to 1/2.
    fn random() -> impl FnMut() -> f64 {
        let mut state = 1u64;
        move || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 40) as f64 / (1u64 << 24) as f64 - 0.5
        }
    }

    #[test]
    fn no_pair_is_missed_across_a_wall() {
        let mut next = random();
        for (count, epsilon) in [(300, 0.05), (300, 0.1), (100, 0.3), (500, 0.01)] {
            let points: Vec<[f64; 3]> = (0..count).map(|_| [next(), next(), next() * 0.1]).collect();
            assert_eq!(lowest(&points, epsilon), naive(&points, epsilon), "{count} within {epsilon}");
        }
    }

    /// Clusters so far from each other that places need 64 bits, 128, or more.
    #[test]
    fn the_distance_may_be_small_beside_the_extent() {
        let mut next = random();
        for epsilon in [1e-3, 1e-6, 1e-12] {
            let clusters: Vec<[f64; 3]> = (0..40).map(|_| [next(), next(), next()]).collect();
            let points: Vec<[f64; 3]> =
                (0..400).map(|i| clusters[i % 40].map(|x| x + 3.0 * epsilon * next())).collect();
            let found = lowest(&points, epsilon);
            assert_eq!(found, naive(&points, epsilon), "within {epsilon}");
            assert!(found.iter().zip(0..).any(|(&low, point)| low != point), "some are joined");
        }
    }

    #[test]
    fn classes_are_chains_and_their_lowest_member_names_them() {
        let points: Vec<[f64; 3]> = [4.0, 0.0, 1.0, 2.0, 3.0, 9.0].map(|x| [x, 0.0, 0.0]).to_vec();
        assert_eq!(lowest(&points, 1.0), [0, 0, 0, 0, 0, 5]);
        assert_eq!(lowest(&points, 0.999), [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn what_is_not_finite_is_near_nothing() {
        let points = [[f64::NAN; 3], [f64::NAN; 3], [f64::INFINITY, 0.0, 0.0], [f64::INFINITY, 0.0, 0.0]];
        assert_eq!(lowest(&points, 1.0), [0, 1, 2, 3]);
    }

    #[test]
    fn a_tolerance_below_the_resolution_is_refused() {
        assert!(classes(&[[1.0; 3]], 1e-20, &Context::default()).is_err());
        assert!(classes(&[[0.0; 3]], f64::MIN_POSITIVE, &Context::default()).is_err());
    }

    #[test]
    fn coordinates_are_resolved_as_far_as_a_place_in_cubes_goes() {
        let largest = SIDE * LARGEST_QUOTIENT;
        assert_eq!(lowest(&[[largest, 0.0, 0.0], [largest - 1.0, 0.0, 0.0], [1.5; 3]], 1.0), [0, 0, 2]);
        assert!(classes(&[[largest.next_up(), 0.0, 0.0]], 1.0, &Context::default()).is_err());
    }

    #[test]
    fn the_diagonal_of_a_huge_box_is_finite() {
        assert_eq!(diagonal(&[[-1e308; 3], [1e308; 3]]), f64::MAX);
        assert_eq!(diagonal(&[[0.0; 3], [2.0, 3.0, 6.0], [f64::NAN; 3]]), 7.0);
        assert_eq!(diagonal(&[[-1.0, 5.0, -4.0], [1.0, 2.0, 2.0]]), 7.0);
        assert_eq!(diagonal(&[]), 0.0);
    }
}
