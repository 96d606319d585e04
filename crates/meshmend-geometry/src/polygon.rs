//! Cuts one polygon in space into triangles by shape, or at its holes into simple polygons.
//!
//! Up to 64 corners the best of all triangulations is found: no triangle lies the wrong way round if that can be had, none
//! is without an area, no diagonal is taken, and what is left is decided by shape. Larger polygons are cut by ears in
//! the plane of their area vector, and those for which that takes n² steps or fails, by a sweep. Where both fail (a
//! polygon that crosses itself) it is cut in halves again and again.
//! *Source*: G. Klincsek, *Minimal triangulations of polygonal domains*, 1980, for the dynamic program.

mod outline;
mod pieces;
mod sweep;
mod sweep_line;
mod turning;
mod walks;

use std::cmp::Ordering;

use earcut::Earcut;
use meshmend_core::{VertexId, distinct_count};

pub use pieces::{has_hole, simple_pieces};
pub use turning::ExactArea;

use crate::vector::{Point, area_vector, cross, dot, minus};

/// A polygon in space. Its corners are named after their places.
#[derive(Clone, Copy, Debug)]
pub struct Polygon<'a> {
    /// The point of each corner.
    pub points: &'a [Point],
    /// The vertex at which each corner stands.
    pub vertices: &'a [VertexId],
}

impl Polygon<'_> {
    fn len(&self) -> usize {
        self.points.len()
    }

    fn vertex(&self, corner: usize) -> VertexId {
        self.vertices[corner]
    }

    /// The triangles of a polygon of four corners, and the diagonal between them: those of [`triangulate_polygon`].
    ///
    /// *Cost*: constant.
    pub(crate) fn in_two(
        self,
        avoid: Avoid,
        is_taken: &dyn Fn(usize, usize) -> bool,
    ) -> ([Triangle; 2], [usize; 2]) {
        let normal = area_vector(self.points.iter().copied());
        best_of_two(&Costs { polygon: self, avoid, is_taken, normal })
    }
}

/// What a triangulation avoids first, after triangles that join two corners at one vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Avoid {
    /// Triangles that lie the wrong way round or have no area, and then diagonals that are taken.
    Folds,
    /// Diagonals that are taken, and then such triangles.
    TakenDiagonals,
}

/// Three corners of a polygon, by their places, the way round that the polygon has.
pub type Triangle = [usize; 3];

const LARGEST_EXACT: usize = 64;
/// Ears of a comb or of a polygon that crosses itself take n² steps: at this size some tenths of a second.
const LARGEST_BY_EARS: usize = 4096;

/// The triangles of a polygon: two fewer than it has corners, which all of its sides bound once and all diagonals twice.
///
/// They join two corners at one vertex, lie the wrong way round or take a diagonal that is taken only where every other
/// choice that was tried is worse.
///
/// *Cost*: O(n³) up to 64 corners; O(n²) up to 4096 and mostly n log n; O(n log n) beyond.
pub fn triangulate_polygon(
    polygon: Polygon<'_>,
    avoid: Avoid,
    is_taken: &dyn Fn(usize, usize) -> bool,
) -> Vec<Triangle> {
    least_cost(polygon, avoid, is_taken).1
}

/// The best triangulation that was found, and what it costs.
fn least_cost(
    polygon: Polygon<'_>,
    avoid: Avoid,
    is_taken: &dyn Fn(usize, usize) -> bool,
) -> (Cost, Vec<Triangle>) {
    let count = polygon.len();
    if count < 3 {
        return Default::default();
    }
    let costs = Costs { polygon, avoid, is_taken, normal: area_vector(polygon.points.iter().copied()) };
    if count <= LARGEST_EXACT {
        return best_of_all(&costs);
    }
    let mut least: Option<(Cost, Vec<Triangle>)> = None;
    for way in [by_ears, by_sweep_along_an_axis, by_sweep_along_the_normal, by_halves] {
        let Some(triangles) = way(polygon, costs.normal).filter(|found| is_triangulation(count, found))
        else {
            continue;
        };
        let cost = costs.of_all(&triangles);
        if cost.is_proper() {
            return (cost, triangles);
        }
        if least.as_ref().is_none_or(|(other, _)| costs.compared(&cost, other) == Ordering::Less) {
            least = Some((cost, triangles));
        }
    }
    least.unwrap_or_default()
}

/// How bad a triangulation is, the worst first.
#[derive(Clone, Copy, Debug, Default)]
struct Cost {
    /// Triangles two of whose corners stand at one vertex.
    joined: u32,
    /// Triangles that lie the wrong way round.
    folded: u32,
    /// Triangles without an area.
    flat: u32,
    /// Diagonals that are taken.
    taken: u32,
    /// The sum of one over the quality of each shape: 1 for an equilateral triangle.
    shape: f64,
}

impl Cost {
    fn plus(self, other: Cost) -> Cost {
        Cost {
            joined: self.joined + other.joined,
            folded: self.folded + other.folded,
            flat: self.flat + other.flat,
            taken: self.taken + other.taken,
            shape: self.shape + other.shape,
        }
    }

    /// Whether the triangles lie side by side.
    fn is_proper(&self) -> bool {
        self.joined == 0 && self.folded == 0
    }
}

/// The costs of a polygon's triangles and diagonals.
struct Costs<'a> {
    polygon: Polygon<'a>,
    avoid: Avoid,
    is_taken: &'a dyn Fn(usize, usize) -> bool,
    normal: Point,
}

impl Costs<'_> {
    fn compared(&self, one: &Cost, other: &Cost) -> Ordering {
        let counts = |cost: &Cost| match self.avoid {
            Avoid::Folds => [cost.joined, cost.folded, cost.flat, cost.taken],
            Avoid::TakenDiagonals => [cost.joined, cost.taken, cost.folded, cost.flat],
        };
        counts(one).cmp(&counts(other)).then(one.shape.total_cmp(&other.shape))
    }

    fn of(&self, triangle: Triangle) -> Cost {
        let [a, b, c] = triangle.map(|corner| self.polygon.vertex(corner));
        let joined = u32::from(a == b || b == c || c == a);
        Cost { joined, ..shape_cost(triangle.map(|corner| self.polygon.points[corner]), self.normal) }
    }

    fn of_side(&self, one: usize, other: usize) -> Cost {
        let is_diagonal = !are_neighbours(self.polygon.len(), one, other);
        Cost { taken: u32::from(is_diagonal && (self.is_taken)(one, other)), ..Cost::default() }
    }

    fn of_all(&self, triangles: &[Triangle]) -> Cost {
        triangles.iter().fold(Cost::default(), |sum, &triangle| sum.plus(self.of(triangle)))
    }
}

/// Whether two places of a polygon are neighbours.
fn are_neighbours(count: usize, one: usize, other: usize) -> bool {
    one.abs_diff(other) == 1 || one.abs_diff(other) == count - 1
}

/// The better of the two triangulations that four corners have, and its diagonal: what [`best_of_all`] finds.
fn best_of_two(costs: &Costs<'_>) -> ([Triangle; 2], [usize; 2]) {
    let cost = |[last, first]: [Triangle; 2], [one, other]: [usize; 2]| {
        costs.of(first).plus(costs.of_side(one, other)).plus(costs.of(last))
    };
    let (first, second) = ([[0, 1, 3], [1, 2, 3]], [[0, 2, 3], [0, 1, 2]]);
    let (cost_of_first, cost_of_second) = (cost(first, [1, 3]), cost(second, [0, 2]));
    match costs.compared(&cost_of_second, &cost_of_first) {
        Ordering::Less => (second, [0, 2]),
        _ => (first, [1, 3]),
    }
}

/// The cheapest triangulation of every range of corners, from short ranges to long ones.
fn best_of_all(costs: &Costs<'_>) -> (Cost, Vec<Triangle>) {
    let count = costs.polygon.len();
    let mut table = vec![(Cost::default(), 0usize); count * count];
    for length in 2..count {
        for low in 0..count - length {
            let high = low + length;
            let mut best: Option<(Cost, usize)> = None;
            for middle in low + 1..high {
                let parts = table[low * count + middle].0.plus(table[middle * count + high].0);
                let cost = parts.plus(costs.of([low, middle, high]));
                if best.is_none_or(|(least, _)| costs.compared(&cost, &least) == Ordering::Less) {
                    best = Some((cost, middle));
                }
            }
            let (least, middle) = best.unwrap_or_default();
            table[low * count + high] = (least.plus(costs.of_side(low, high)), middle);
        }
    }
    let (mut triangles, mut ranges) = (Vec::with_capacity(count - 2), vec![(0, count - 1)]);
    while let Some((low, high)) = ranges.pop() {
        if high - low < 2 {
            continue;
        }
        let middle = table[low * count + high].1;
        triangles.push([low, middle, high]);
        ranges.extend([(middle, high), (low, middle)]);
    }
    (table[count - 1].0, triangles)
}

/// What the shape of a triangle costs: one over its quality, always finite.
fn shape_cost([a, b, c]: [Point; 3], normal: Point) -> Cost {
    let (u, v, w) = (minus(b, a), minus(c, a), minus(c, b));
    let area = cross(u, v);
    let size = dot(area, area).sqrt();
    let lengths = dot(u, u) + dot(v, v) + dot(w, w);
    let shape = lengths / (size * 2.0 * 3.0f64.sqrt());
    if !shape.is_finite() || size == 0.0 {
        return Cost { flat: 1, ..Cost::default() };
    }
    Cost { folded: u32::from(dot(area, normal) <= 0.0), shape, ..Cost::default() }
}

/// Ears in the plane in which the polygon's area vector is largest; nothing for those that are too large, or in which
/// one vertex has several corners.
fn by_ears(polygon: Polygon<'_>, normal: Point) -> Option<Vec<Triangle>> {
    if polygon.len() > LARGEST_BY_EARS || distinct_count(polygon.vertices) < polygon.len() {
        return None;
    }
    let flat = seen_along_an_axis(polygon, normal)?;
    let mut found: Vec<u32> = Vec::new();
    Earcut::new().earcut(flat, &[], &mut found);
    let triangles = found.chunks_exact(3).map(|t| [t[0] as usize, t[1] as usize, t[2] as usize]);
    Some(triangles.map(in_polygon_order).collect())
}

fn by_sweep_along_an_axis(polygon: Polygon<'_>, normal: Point) -> Option<Vec<Triangle>> {
    sweep::by_sweep(&seen_along_an_axis(polygon, normal)?, polygon.vertices)
}

fn by_sweep_along_the_normal(polygon: Polygon<'_>, normal: Point) -> Option<Vec<Triangle>> {
    sweep::by_sweep(&seen_along_the_normal(polygon, normal)?, polygon.vertices)
}

/// The points without the coordinate in which the normal is largest, exactly; they run round the polygon's inside
/// anticlockwise.
fn seen_along_an_axis(polygon: Polygon<'_>, normal: Point) -> Option<Vec<[f64; 2]>> {
    let size = normal.map(f64::abs);
    let dropped = if size[2] >= size[0] && size[2] >= size[1] { 2 } else { usize::from(size[1] >= size[0]) };
    let (x, y) = ((dropped + 1) % 3, (dropped + 2) % 3);
    let (x, y) = if normal[dropped] < 0.0 { (y, x) } else { (x, y) };
    // A zero has one sign.
    all_finite(polygon.points.iter().map(|point| [point[x] + 0.0, point[y] + 0.0]))
}

/// The points as the polygon's area vector sees them, rounded; they run round the polygon's inside anticlockwise.
fn seen_along_the_normal(polygon: Polygon<'_>, normal: Point) -> Option<Vec<[f64; 2]>> {
    let &origin = polygon.points.first()?;
    let least = if normal[0].abs() <= normal[1].abs().min(normal[2].abs()) {
        0
    } else {
        1 + usize::from(normal[2].abs() < normal[1].abs())
    };
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let unit = |v: Point| v.map(|x| x / dot(v, v).sqrt());
    let right = unit(cross(axis, unit(normal)));
    let up = cross(unit(normal), right);
    let seen = polygon.points.iter().map(|&point| minus(point, origin));
    all_finite(seen.map(|point| [dot(point, right) + 0.0, dot(point, up) + 0.0]))
}

fn all_finite(points: impl Iterator<Item = [f64; 2]>) -> Option<Vec<[f64; 2]>> {
    let points: Vec<[f64; 2]> = points.collect();
    points.iter().flatten().all(|x| x.is_finite()).then_some(points)
}

/// A triangle with its places ascending round: the way round that the polygon has.
fn in_polygon_order(mut triangle: Triangle) -> Triangle {
    triangle.sort_unstable();
    triangle
}

/// Each range of corners is cut at its middle: a triangulation whatever the shape.
fn by_halves(polygon: Polygon<'_>, _normal: Point) -> Option<Vec<Triangle>> {
    let (mut triangles, mut ranges) = (Vec::with_capacity(polygon.len()), vec![(0, polygon.len() - 1)]);
    while let Some((low, high)) = ranges.pop() {
        if high - low < 2 {
            continue;
        }
        let middle = low + (high - low) / 2;
        triangles.push([low, middle, high]);
        ranges.extend([(middle, high), (low, middle)]);
    }
    Some(triangles)
}

/// Whether triangles of ascending places are the polygon: each side once, each diagonal in two of them.
fn is_triangulation(count: usize, triangles: &[Triangle]) -> bool {
    if triangles.len() + 2 != count {
        return false;
    }
    let mut sides: Vec<(usize, usize)> =
        triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (a, c)]).collect();
    sides.sort_unstable();
    sides.chunk_by(|one, other| one == other).all(|run| {
        let (a, b) = run[0];
        a < b && run.len() == if are_neighbours(count, a, b) { 1 } else { 2 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().map(|p| [p[0], p[1], 0.0]).collect()
    }

    fn cut(points: &[Point], is_taken: &dyn Fn(usize, usize) -> bool) -> Vec<Triangle> {
        let vertices: Vec<VertexId> = (0..points.len() as u32).map(VertexId).collect();
        triangulate_polygon(Polygon { points, vertices: &vertices }, Avoid::Folds, is_taken)
    }

    #[test]
    fn four_corners_are_cut_as_the_general_way_cuts_them() {
        let at = |n: u32| [f64::from(n % 3), f64::from(n / 3 % 3), f64::from(n / 9)];
        let vertices: Vec<VertexId> = (0..4).map(VertexId).collect();
        for corners in (0..18_u32.pow(4)).step_by(7) {
            let points = [0, 1, 2, 3].map(|place| at(corners / 18_u32.pow(place) % 18));
            for taken in 0..8 {
                let avoid = if taken > 3 { Avoid::Folds } else { Avoid::TakenDiagonals };
                let is_taken = |one: usize, other: usize| taken >> ((one + other) / 4) & 1 == 1;
                let polygon = Polygon { points: &points, vertices: &vertices };
                let normal = area_vector(points.into_iter());
                let costs = Costs { polygon, avoid, is_taken: &is_taken, normal };
                assert_eq!(best_of_two(&costs).0.to_vec(), best_of_all(&costs).1, "{points:?}");
            }
        }
    }

    #[test]
    fn a_kite_is_cut_along_its_short_diagonal_unless_that_is_taken() {
        let kite = flat(&[[0.0, 0.0], [3.0, -1.0], [6.0, 0.0], [3.0, 1.0]]);
        let short = vec![[0, 1, 3], [1, 2, 3]];
        assert_eq!(cut(&kite, &|_, _| false), short);
        assert_eq!(cut(&kite, &|a, b| (a.min(b), a.max(b)) == (1, 3)), [[0, 2, 3], [0, 1, 2]]);
        assert_eq!(cut(&kite, &|_, _| true), short);
    }

    #[test]
    fn a_triangle_costs_more_the_worse_its_shape_is() {
        let up = [0.0, 0.0, 1.0];
        let cost = |[x, y]: [f64; 2], size: f64, normal| {
            shape_cost([[0.0; 3], [size, 0.0, 0.0], [x * size, y * size, 0.0]], normal)
        };
        let even = [0.5, 0.75f64.sqrt()];
        for size in [0.01, 1.0, 100.0] {
            assert!((cost(even, size, up).shape - 1.0).abs() < 1e-12);
            // Of the sides' squares, 1 + 1 + 2, a right angle makes half an area.
            assert!((cost([0.0, 1.0], size, up).shape - 2.0 / 3.0f64.sqrt()).abs() < 1e-12);
        }
        let [proper, folded, flat] =
            [cost(even, 1.0, up), cost(even, 1.0, [0.0, 0.0, -1.0]), cost([0.5, 0.0], 1.0, up)];
        assert_eq!([proper, folded, flat].map(|cost| (cost.folded, cost.flat)), [(0, 0), (1, 0), (0, 1)]);
    }

    #[test]
    fn a_straight_corner_is_no_triangle_of_its_own() {
        let points = flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 1.0]]);
        let triangles = cut(&points, &|_, _| false);
        assert!(triangles.iter().all(|t| t.contains(&1) && t.contains(&3)), "{triangles:?}");
    }

    #[test]
    fn triangles_that_list_a_corner_twice_or_leave_a_side_open_are_no_triangulation() {
        assert!(is_triangulation(5, &[[0, 1, 2], [0, 2, 4], [2, 3, 4]]));
        assert!(!is_triangulation(5, &[[0, 1, 2], [0, 2, 4]]));
        assert!(!is_triangulation(5, &[[0, 1, 2], [0, 2, 4], [1, 3, 4]]));
        assert!(!is_triangulation(5, &[[0, 1, 2], [0, 1, 2], [2, 3, 4]]));
        assert!(!is_triangulation(6, &[[0, 0, 2], [0, 0, 3], [1, 1, 4], [1, 1, 5]]));
    }

    #[test]
    fn a_dart_is_cut_at_its_reflex_corner() {
        let dart = flat(&[[0.0, 0.0], [2.0, 2.0], [0.0, 1.0], [-2.0, 2.0]]);
        let triangles = cut(&dart, &|_, _| false);
        assert!(triangles.iter().all(|t| t.contains(&0) && t.contains(&2)), "{triangles:?}");
    }

    #[test]
    fn small_and_large_polygons_give_triangulations_of_positive_area() {
        for count in [4, 7, 64, 65, 1000, 4097, 9000] {
            // A star: every other corner is far out.
            let points: Vec<Point> = (0..count)
                .map(|i| {
                    let (turn, far) =
                        (i as f64 * std::f64::consts::TAU / count as f64, if i % 2 == 0 { 2.0 } else { 1.0 });
                    [far * turn.cos(), far * turn.sin(), 0.0]
                })
                .collect();
            assert_covered_once(&points);
            assert_covered_once(&points.iter().map(|&[x, y, z]| [y, z, x]).collect::<Vec<_>>());
            assert_covered_once(&points.iter().map(|&[x, y, z]| [z, x, y]).collect::<Vec<_>>());
        }
    }

    #[track_caller]
    fn assert_covered_once(points: &[Point]) {
        let count = points.len();
        let mut triangles = cut(points, &|_, _| false);
        triangles.iter_mut().for_each(|t| t.sort_unstable());
        assert!(is_triangulation(count, &triangles), "{count}");
        let size = |area: Point| dot(area, area).sqrt();
        let total = size(area_vector(points.iter().copied()));
        let area = |&[a, b, c]: &Triangle| cross(minus(points[b], points[a]), minus(points[c], points[a]));
        let sum: f64 = triangles.iter().map(|triangle| size(area(triangle))).sum();
        assert!((sum - total).abs() < 1e-9 * total, "{count}: {sum} of {total}");
    }

    #[test]
    fn a_polygon_without_shape_is_cut_all_the_same() {
        for point in [[1.0; 3], [f64::NAN; 3]] {
            for count in [5, 100, 5000] {
                let triangles = cut(&vec![point; count], &|_, _| false);
                assert_eq!(triangles.len(), count - 2);
            }
        }
    }

    #[test]
    fn a_dart_whose_diagonal_is_taken_is_folded_only_if_that_is_asked_for() {
        let points = flat(&[[0.0, 0.0], [2.0, 2.0], [0.0, 1.0], [-2.0, 2.0]]);
        let vertices = [0, 1, 2, 3].map(VertexId);
        let polygon = Polygon { points: &points, vertices: &vertices };
        let is_taken = |one: usize, other: usize| one.min(other) == 0;
        assert_eq!(triangulate_polygon(polygon, Avoid::Folds, &is_taken), cut(&points, &|_, _| false));
        let folded = triangulate_polygon(polygon, Avoid::TakenDiagonals, &is_taken);
        assert!(folded.iter().all(|t| t.contains(&1) && t.contains(&3)), "{folded:?}");
    }

    #[test]
    fn straight_corners_of_a_large_concave_polygon_are_no_reason_for_halves() {
        // A comb with a corner amid each side.
        let teeth = (0..30).flat_map(|i| [[2.0 * f64::from(i), 0.0], [2.0 * f64::from(i) + 1.0, 40.0]]);
        let comb: Vec<[f64; 2]> = teeth.chain([[60.0, -2.0], [0.0, -2.0]]).rev().collect();
        let halved = comb.iter().zip(comb.iter().cycle().skip(1));
        let points: Vec<Point> = halved
            .flat_map(|(p, q)| [[p[0], p[1], 0.0], [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0, 0.0]])
            .collect();
        assert!(points.len() > LARGEST_EXACT);
        assert_covered_once(&points);
    }
}
