//! Cuts one polygon in space into triangles, by shape, without taken diagonals.
//!
//! Up to 64 corners the best of all triangulations is found: the one whose triangles are best shaped, no triangle lying
//! the wrong way round if that can be had. Larger polygons are cut by ears in the plane of their area vector, and the
//! largest, for which ears may take n² steps, by monotone pieces; what that leaves invalid (a polygon that crosses
//! itself, or a taken diagonal) is cut in halves again and again.
//! *Source*: G. Klincsek, *Minimal triangulations of polygonal domains*, 1980, for the dynamic program.

mod monotone;
mod plane;
mod sides;

use earcut::Earcut;

use crate::vector::{Point, area_vector, cross, dot, minus};

/// Three corners of a polygon, by their places, the way round that the polygon has.
pub type Triangle = [usize; 3];

const LARGEST_EXACT: usize = 64;
/// Ears of a comb or of a polygon that crosses itself take n² steps: at this size some tenths of a second.
const LARGEST_BY_EARS: usize = 4096;

/// What a triangle of no area, or one that lies the wrong way round, costs more than any proper one.
const FOLDED: f64 = 1e9;

/// The triangles of a polygon, or nothing where every choice that was tried takes a diagonal that is taken.
///
/// *Cost*: O(n³) up to 64 corners, O(n²) up to 4096 and mostly n log n, O(n log² n) beyond.
pub fn triangulate_polygon(
    points: &[Point],
    is_taken: &dyn Fn(usize, usize) -> bool,
) -> Option<Vec<Triangle>> {
    if points.len() <= LARGEST_EXACT {
        return best_of_all(points, is_taken);
    }
    let by_shape = if points.len() <= LARGEST_BY_EARS { by_ears(points) } else { by_pieces(points) };
    [by_shape, by_halves(points.len())].into_iter().find(|triangles| {
        is_triangulation(points.len(), triangles) && !takes_a_taken_one(points.len(), triangles, is_taken)
    })
}

/// Whether two places of a polygon are neighbours.
fn are_neighbours(count: usize, one: usize, other: usize) -> bool {
    one.abs_diff(other) == 1 || one.abs_diff(other) == count - 1
}

fn takes_a_taken_one(count: usize, triangles: &[Triangle], is_taken: &dyn Fn(usize, usize) -> bool) -> bool {
    let sides = triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    sides.into_iter().any(|(a, b)| a < b && !are_neighbours(count, a, b) && is_taken(a, b))
}

/// The cheapest triangulation of every range of corners, from short ranges to long ones.
fn best_of_all(points: &[Point], is_taken: &dyn Fn(usize, usize) -> bool) -> Option<Vec<Triangle>> {
    let count = points.len();
    let normal = area_vector(points.iter().copied());
    let mut cost = vec![vec![0.0f64; count]; count];
    let mut apex = vec![vec![0usize; count]; count];
    for length in 2..count {
        for low in 0..count - length {
            let high = low + length;
            let is_forbidden = !are_neighbours(count, low, high) && is_taken(low, high);
            let best = (low + 1..high)
                .map(|middle| {
                    let triangle = [points[low], points[middle], points[high]];
                    (cost[low][middle] + cost[middle][high] + triangle_cost(triangle, normal), middle)
                })
                .min_by(|one, other| one.0.total_cmp(&other.0));
            let (least, middle) = best.unwrap_or((f64::INFINITY, low));
            cost[low][high] = if is_forbidden { f64::INFINITY } else { least };
            apex[low][high] = middle;
        }
    }
    if !cost[0][count - 1].is_finite() {
        return None;
    }
    let (mut triangles, mut ranges) = (Vec::with_capacity(count - 2), vec![(0, count - 1)]);
    while let Some((low, high)) = ranges.pop() {
        if high - low < 2 {
            continue;
        }
        let middle = apex[low][high];
        triangles.push([low, middle, high]);
        ranges.extend([(middle, high), (low, middle)]);
    }
    Some(triangles)
}

/// One over the shape quality (1 for an equilateral triangle), always finite.
fn triangle_cost([a, b, c]: [Point; 3], normal: Point) -> f64 {
    let (u, v, w) = (minus(b, a), minus(c, a), minus(c, b));
    let area = cross(u, v);
    let size = dot(area, area).sqrt();
    let lengths = dot(u, u) + dot(v, v) + dot(w, w);
    let cost = lengths / (size * 2.0 * 3.0f64.sqrt());
    if !cost.is_finite() || size == 0.0 {
        2.0 * FOLDED
    } else if dot(area, normal) <= 0.0 {
        FOLDED + cost.min(FOLDED)
    } else {
        cost.min(FOLDED)
    }
}

/// Ears in the plane in which the polygon's area vector is largest.
fn by_ears(points: &[Point]) -> Vec<Triangle> {
    let normal = area_vector(points.iter().copied());
    let (x, y) = plane_of(normal);
    if points.iter().flatten().any(|value| !value.is_finite()) {
        return Vec::new();
    }
    let mut flat: Vec<u32> = Vec::new();
    Earcut::new().earcut(points.iter().map(|p| [p[x], p[y]]), &[], &mut flat);
    let triangles = flat.chunks_exact(3).map(|t| [t[0] as usize, t[1] as usize, t[2] as usize]);
    triangles.map(in_polygon_order).collect()
}

/// Monotone pieces in the plane in which the polygon's area vector is largest.
fn by_pieces(points: &[Point]) -> Vec<Triangle> {
    let normal = area_vector(points.iter().copied());
    if points.iter().flatten().any(|value| !value.is_finite()) {
        return Vec::new();
    }
    let (x, y) = plane_of(normal);
    let is_seen_from_behind = normal[3 - x - y] < 0.0;
    let (x, y) = if is_seen_from_behind { (y, x) } else { (x, y) };
    monotone::by_monotone_pieces(points.iter().map(|p| [p[x], p[y]]).collect())
}

/// A triangle with its places ascending round: the way round that the polygon has.
fn in_polygon_order(mut triangle: Triangle) -> Triangle {
    triangle.sort_unstable();
    triangle
}

/// The two coordinates that stay when the largest one of a normal is dropped.
fn plane_of(normal: Point) -> (usize, usize) {
    let size = normal.map(f64::abs);
    if size[2] >= size[0] && size[2] >= size[1] {
        (0, 1)
    } else if size[1] >= size[0] {
        (2, 0)
    } else {
        (1, 2)
    }
}

/// Each range of corners is cut at its middle: a valid triangulation whatever the shape.
fn by_halves(count: usize) -> Vec<Triangle> {
    let (mut triangles, mut ranges) = (Vec::with_capacity(count), vec![(0, count - 1)]);
    while let Some((low, high)) = ranges.pop() {
        if high - low < 2 {
            continue;
        }
        let middle = low + (high - low) / 2;
        triangles.push([low, middle, high]);
        ranges.extend([(middle, high), (low, middle)]);
    }
    triangles
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

    #[test]
    fn a_kite_is_cut_along_its_short_diagonal_unless_that_is_taken() {
        let kite = flat(&[[0.0, 0.0], [3.0, -1.0], [6.0, 0.0], [3.0, 1.0]]);
        assert_eq!(triangulate_polygon(&kite, &|_, _| false), Some(vec![[0, 1, 3], [1, 2, 3]]));
        let other = triangulate_polygon(&kite, &|a, b| (a.min(b), a.max(b)) == (1, 3));
        assert_eq!(other, Some(vec![[0, 2, 3], [0, 1, 2]]));
        assert_eq!(triangulate_polygon(&kite, &|_, _| true), None);
    }

    #[test]
    fn a_triangle_costs_more_the_worse_its_shape_is() {
        let up = [0.0, 0.0, 1.0];
        let cost = |[x, y]: [f64; 2], size: f64, normal| {
            triangle_cost([[0.0; 3], [size, 0.0, 0.0], [x * size, y * size, 0.0]], normal)
        };
        let even = [0.5, 0.75f64.sqrt()];
        for size in [0.01, 1.0, 100.0] {
            assert!((cost(even, size, up) - 1.0).abs() < 1e-12);
            // Of the sides' squares, 1 + 1 + 2, a right angle makes half an area.
            assert!((cost([0.0, 1.0], size, up) - 2.0 / 3.0f64.sqrt()).abs() < 1e-12);
        }
        let [proper, folded, flat] =
            [cost(even, 1.0, up), cost(even, 1.0, [0.0, 0.0, -1.0]), cost([0.5, 0.0], 1.0, up)];
        assert!(proper < folded && folded < flat && flat.is_finite());
    }

    #[test]
    fn a_straight_corner_is_no_triangle_of_its_own() {
        let points = flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 1.0]]);
        let triangles = triangulate_polygon(&points, &|_, _| false).unwrap();
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
        let triangles = triangulate_polygon(&dart, &|_, _| false).unwrap();
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
        let mut triangles = triangulate_polygon(points, &|_, _| false).unwrap();
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
                let triangles = triangulate_polygon(&vec![point; count], &|_, _| false).unwrap();
                assert_eq!(triangles.len(), count - 2);
            }
        }
    }
}
