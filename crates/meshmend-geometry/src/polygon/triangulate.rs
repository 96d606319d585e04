//! Cuts a polygon in space into triangles, by the first strategy of several that leads to proper ones.

use std::cmp::Ordering;

use earcut::Earcut;
use meshmend_core::distinct_count;

use super::best::best_of_all;
use super::corners::{Polygon, Triangle, are_neighbours};
use super::cost::{Avoid, Cost, Costs};
use super::projection::{seen_along_an_axis, seen_along_the_normal};
use super::sweep::by_sweep;
use crate::vector::{Point, area_vector};

const LARGEST_EXACT: usize = 64;
/// Ears of a comb or of a polygon that crosses itself take n² steps: at this size some tenths of a second.
const LARGEST_BY_EARS: usize = 4096;

/// The triangles of a polygon: two fewer than it has corners, which all of its sides bound once and all diagonals
/// twice.
///
/// They join two corners at one vertex, lie the wrong way round or take a diagonal that is taken only where every
/// other choice that was tried is worse.
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
pub(super) fn least_cost(
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
    for strategy in [by_ears, by_sweep_along_an_axis, by_sweep_along_the_normal, by_halves] {
        let Some(triangles) = strategy(polygon, costs.normal).filter(|found| is_triangulation(count, found))
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

/// Ears in the plane in which the polygon's area vector is largest; `None` for those that are too large, or in which
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
    by_sweep(&seen_along_an_axis(polygon, normal)?, polygon.vertices)
}

fn by_sweep_along_the_normal(polygon: Polygon<'_>, normal: Point) -> Option<Vec<Triangle>> {
    by_sweep(&seen_along_the_normal(polygon, normal)?, polygon.vertices)
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
    use meshmend_core::VertexId;

    use super::*;
    use crate::vector::{cross, dot, minus};

    fn flat(points: &[[f64; 2]]) -> Vec<Point> {
        points.iter().map(|p| [p[0], p[1], 0.0]).collect()
    }

    fn cut(points: &[Point], is_taken: &dyn Fn(usize, usize) -> bool) -> Vec<Triangle> {
        let vertices: Vec<VertexId> = (0..points.len() as u32).map(VertexId).collect();
        triangulate_polygon(Polygon { points, vertices: &vertices }, Avoid::Folds, is_taken)
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
