//! Which points are within a distance of each other, without missing a pair across a cell's wall.
//!
//! Space is divided into cubes so small that any two points in one cube are near. Then only pairs of points in
//! different cubes up to two steps apart have to be measured, and only while the cubes are not joined already.
//! The cubes that hold points are sorted, and for each of the steps in (x, y) a pointer runs along once.
//!
//! Points in the same place are one point to all of this.

use meshmend_core::VertexId;
use petgraph::unionfind::UnionFind;
use rayon::prelude::*;

use crate::coincident::coincident_points;
use crate::{Context, PassError};

/// The side of a cube in parts of the distance: a little under 1/√3, so that its diagonal is within it.
const SIDE: f64 = 0.577;

/// Quotients of this size have no fraction left to tell cubes apart reliably.
const LARGEST_QUOTIENT: f64 = (1u64 << 50) as f64;

/// A cube's place, in sides.
type Cube = [i64; 3];

/// For each point the lowest one of its class: the connected components of "distance ≤ ε" among the finite points.
///
/// *Cost*: O(n log n) and the pairs measured: near cubes that are not joined yet measure all their pairs, which is
/// many only where two dense clusters lie just farther apart than ε.
///
/// # Errors
/// When ε is so small beside the coordinates that doubles can't resolve it.
pub(crate) fn classes(
    points: &[[f64; 3]],
    epsilon: f64,
    context: &Context<'_>,
) -> Result<Vec<VertexId>, PassError> {
    let side = (epsilon * SIDE).max(f64::MIN_POSITIVE);
    let finite = |p: &[f64; 3]| p.iter().all(|x| x.is_finite());
    let extent = points.iter().filter(|p| finite(p)).flatten().fold(0.0f64, |most, x| most.max(x.abs()));
    if extent / side > LARGEST_QUOTIENT {
        let reason = format!(
            "a tolerance of {epsilon:e} can't be resolved by coordinates as large as {extent:e}; weld exactly instead"
        );
        return Err(PassError::Request { pass: "weld", reason });
    }
    let cube_of = |p: &[f64; 3]| p.map(|x| (x / side).floor() as i64);
    let same = coincident_points(points);
    let mut keyed: Vec<(Cube, u32)> = points
        .par_iter()
        .zip(&same)
        .zip(0..points.len() as u32)
        .filter(|((p, lowest), v)| lowest.0 == *v && finite(p))
        .map(|((p, _), v)| (cube_of(p), v))
        .collect();
    keyed.par_sort_unstable();
    let mut near = Near { points, epsilon, classes: UnionFind::new(points.len()) };
    let cubes: Vec<&[(Cube, u32)]> = keyed.chunk_by(|one, other| one.0 == other.0).collect();
    for cube in &cubes {
        cube.iter().for_each(|&(_, v)| {
            near.classes.union(cube[0].1, v);
        });
    }
    for dx in 0..=2 {
        for dy in if dx == 0 { 0..=2 } else { -2..=2 } {
            context.check_cancelled()?;
            near.join_across(&cubes, dx, dy);
        }
    }
    Ok(near.lowest(&same))
}

/// The bounding box's diagonal, finite points only; halved on the way so that it can't overflow early.
pub(crate) fn diagonal(points: &[[f64; 3]]) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
        for axis in 0..3 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    let half = |axis: usize| (high[axis] / 2.0 - low[axis] / 2.0).max(0.0);
    let diagonal = 2.0 * half(0).hypot(half(1)).hypot(half(2));
    diagonal.min(f64::MAX)
}

struct Near<'a> {
    points: &'a [[f64; 3]],
    epsilon: f64,
    classes: UnionFind<u32>,
}

impl Near<'_> {
    /// Joins each cube with those that are `dx` and `dy` sides away and up to two along z, each pair once.
    fn join_across(&mut self, cubes: &[&[(Cube, u32)]], dx: i64, dy: i64) {
        let mut first = 0;
        for cube in cubes {
            let [x, y, z] = cube[0].0;
            let lowest_z = if dx == 0 && dy == 0 { z + 1 } else { z - 2 };
            let from = [x + dx, y + dy, lowest_z];
            while first < cubes.len() && cubes[first][0].0 < from {
                first += 1;
            }
            let to = [x + dx, y + dy, z + 2];
            for other in cubes[first..].iter().take_while(|other| other[0].0 <= to) {
                self.join_cubes(cube, other);
            }
        }
    }

    fn join_cubes(&mut self, one: &[(Cube, u32)], other: &[(Cube, u32)]) {
        if self.classes.equiv(one[0].1, other[0].1) {
            return;
        }
        let is_near = one.iter().any(|a| other.iter().any(|b| self.are_near(a.1, b.1)));
        if is_near {
            self.classes.union(one[0].1, other[0].1);
        }
    }

    fn are_near(&self, one: u32, other: u32) -> bool {
        let (a, b) = (self.points[one as usize], self.points[other as usize]);
        let parts: [f64; 3] = std::array::from_fn(|axis| (a[axis] - b[axis]) / self.epsilon);
        parts.iter().map(|part| part * part).sum::<f64>() <= 1.0
    }

    /// The lowest point of the class of each point, given the lowest one in the same place.
    fn lowest(&mut self, same: &[VertexId]) -> Vec<VertexId> {
        let mut lowest = vec![VertexId(u32::MAX); same.len()];
        for &v in same {
            let root = self.classes.find_mut(v.0) as usize;
            lowest[root] = lowest[root].min(v);
        }
        same.iter().map(|v| lowest[self.classes.find(v.0) as usize]).collect()
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

    #[test]
    fn no_pair_is_missed_across_a_wall() {
        let mut state = 1u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 40) as f64 / (1u64 << 24) as f64 - 0.5
        };
        for (count, epsilon) in [(300, 0.05), (300, 0.1), (100, 0.3), (500, 0.01)] {
            let points: Vec<[f64; 3]> = (0..count).map(|_| [next(), next(), next() * 0.1]).collect();
            assert_eq!(lowest(&points, epsilon), naive(&points, epsilon), "{count} within {epsilon}");
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
