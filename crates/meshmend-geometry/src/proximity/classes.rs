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

use meshmend_core::{Id, VertexId};
use petgraph::unionfind::UnionFind;
use rayon::prelude::*;

use super::grid::{Grid, InCell, Packed, Places, REACH, Spread, steps_between};
use super::nearness::Nearness;
use super::neighbour_cells::{NEIGHBOURS_AHEAD, ROWS, ahead_in_row, reaches};
use crate::bounds::bounds;

/// The side of a cube in parts of the distance. Less than 1/√3, so that a cube's diagonal is within the distance, and
/// more than 1/2, so that the distance is within two sides; both by more than what quotients are rounded by.
const SIDE: f64 = 0.54;

/// Quotients of this size have no fraction left to tell cubes apart reliably.
const LARGEST_QUOTIENT: f64 = (1u64 << 48) as f64;

/// After so many cells a request to stop is looked for.
const CELLS_BETWEEN_LOOKS: usize = 1 << 16;

/// Why points were not put into classes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoClasses {
    /// The distance is too small beside the coordinates for doubles to resolve it.
    Unresolved {
        /// The largest coordinate, without its sign.
        extent: f64,
    },
    /// The caller asked to stop.
    Stopped,
}

/// For each point the lowest one of its class: the connected components of "distance ≤ ε" among the finite points.
///
/// ε is a positive number. From time to time the caller is asked whether to go on.
///
/// # Errors
/// When ε is so small beside the coordinates that doubles can't resolve it, or when the caller does not go on.
///
/// *Cost*: sorting the points; some 40 bytes a point, 60 and more where few are near each other.
pub fn proximity_classes(
    points: &[[f64; 3]],
    epsilon: f64,
    goes_on: &dyn Fn() -> bool,
) -> Result<Vec<VertexId>, NoClasses> {
    let side = epsilon * SIDE;
    let Some((low, high)) = bounds(points) else { return Ok((0..points.len()).map(VertexId::new).collect()) };
    let extent = low.iter().chain(&high).fold(0.0f64, |most, x| most.max(x.abs()));
    if side < f64::MIN_POSITIVE || extent / side > LARGEST_QUOTIENT {
        return Err(NoClasses::Unresolved { extent });
    }
    let (grid, near) = (Grid::of_side(side), Nearness::within(epsilon));
    let classes = match Packed::between(grid, low, high) {
        Some(places) => Cloud::new(points, near, places, goes_on).classes(goes_on),
        None => Cloud::new(points, near, Spread(grid), goes_on).classes(goes_on),
    };
    classes.ok_or(NoClasses::Stopped)
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
    /// The points, or none if the caller does not go on.
    fn new(points: &'a [[f64; 3]], near: Nearness, places: P, goes_on: &dyn Fn() -> bool) -> Self {
        let mut order = Vec::with_capacity(points.len());
        let (mut cubes, mut cells, mut cell_cubes) = (Vec::new(), Vec::new(), Vec::new());
        let mut last = None;
        places.visit_sorted(points, goes_on, |cell, at, point| {
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

    /// Returns `None` if the caller does not go on.
    fn classes(&self, goes_on: &dyn Fn() -> bool) -> Option<Vec<VertexId>> {
        if !goes_on() {
            return None;
        }
        let mut joined = UnionFind::new(self.cubes.len() - 1);
        let mut rows = ROWS.map(|step| (step, 0));
        for (cell, &place) in self.cells.iter().enumerate() {
            if cell % CELLS_BETWEEN_LOOKS == 0 && !goes_on() {
                return None;
            }
            self.join_within(cell, &mut joined);
            let cubes = &self.cubes[self.cubes_of(cell)];
            let ahead = cubes.iter().fold(0, |ahead, &(at, _)| ahead | NEIGHBOURS_AHEAD[at as usize]);
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
        goes_on().then(|| self.lowest(&mut joined))
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
        proximity_classes(points, epsilon, &|| true).unwrap().iter().map(|v| v.0).collect()
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
        assert!(proximity_classes(&[[1.0; 3]], 1e-20, &|| true).is_err());
        assert!(proximity_classes(&[[0.0; 3]], f64::MIN_POSITIVE, &|| true).is_err());
    }

    #[test]
    fn coordinates_are_resolved_as_far_as_a_place_in_cubes_goes() {
        let largest = SIDE * LARGEST_QUOTIENT;
        assert_eq!(lowest(&[[largest, 0.0, 0.0], [largest - 1.0, 0.0, 0.0], [1.5; 3]], 1.0), [0, 0, 2]);
        assert!(proximity_classes(&[[largest.next_up(), 0.0, 0.0]], 1.0, &|| true).is_err());
    }
}
