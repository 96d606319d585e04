//! Best fills beside all fills that there are, and large ones beside what triangulating gives.

use meshmend_core::VertexId;
use meshmend_geometry::polygon::{Avoid, Polygon, Triangle, triangulate_polygon};
use meshmend_geometry::vector::{Point, cross, dot, minus};

use super::measure::measure;
use super::scaled::Scaled;
use super::{Fill, FillBy, Opening, best_fill, direction_of_face, fan_cost};

/// A hole with its own lists.
struct Hole {
    points: Vec<Point>,
    vertices: Vec<VertexId>,
    beside: Vec<Point>,
    joined: Vec<[usize; 2]>,
}

impl Hole {
    fn asked<T>(&self, ask: impl FnOnce(&Opening<'_>) -> T) -> T {
        let is_joined = |a: usize, b: usize| self.joined.contains(&[a.min(b), a.max(b)]);
        ask(&Opening {
            points: &self.points,
            vertices: &self.vertices,
            beside: &self.beside,
            is_joined: &is_joined,
            is_there: &|_| false,
        })
    }

    fn best(&self, by: FillBy) -> Option<Fill> {
        self.asked(|opening| best_fill(opening, by))
    }

    /// All admissible fills with their cost, counted naively, and the one that should be the best.
    fn best_of_all(&self, by: FillBy) -> Option<(usize, f64, f64)> {
        let all = triangulations(0, self.points.len() - 1);
        let costs = all.iter().filter_map(|triangles| self.naive_cost(triangles));
        let costs: Vec<(usize, f64, f64)> = match by {
            FillBy::Fold => costs.collect(),
            FillBy::Area => costs.map(|(flat, _, area)| (flat, 0.0, area)).collect(),
        };
        let fewest = costs.iter().map(|cost| cost.0).min()?;
        let least = |costs: &mut dyn Iterator<Item = f64>| costs.fold(f64::INFINITY, f64::min);
        let flat = costs.iter().filter(|cost| cost.0 == fewest);
        let fold = least(&mut flat.clone().map(|cost| cost.1));
        let area = least(&mut flat.filter(|cost| cost.1 <= fold + 1e-12).map(|cost| cost.2));
        Some((fewest, fold, area))
    }

    fn naive_cost(&self, triangles: &[Triangle]) -> Option<(usize, f64, f64)> {
        let count = self.points.len();
        let normal = |[a, b, c]: Triangle| {
            cross(minus(self.points[b], self.points[a]), minus(self.points[c], self.points[a]))
        };
        let (mut flat, mut fold, mut area) = (0, 0.0f64, 0.0);
        for &triangle in triangles {
            let [a, b, c] = triangle;
            let own = normal(triangle);
            flat += usize::from(own == [0.0; 3]);
            area += dot(own, own).sqrt() / 2.0;
            for side in [[a, b], [b, c], [a, c]] {
                let [low, high] = side;
                let on_loop =
                    if high == low + 1 { Some(low) } else { (side == [0, count - 1]).then_some(high) };
                if on_loop.is_none() && self.joined.contains(&side) {
                    return None;
                }
                let others =
                    triangles.iter().filter(|t| **t != triangle && side.iter().all(|v| t.contains(v)));
                let others = others.map(|&t| normal(t)).chain(on_loop.map(|corner| self.beside[corner]));
                fold = others.map(|other| naive_fold(own, other)).fold(fold, f64::max);
            }
        }
        Some((flat, fold, area))
    }
}

fn naive_fold(one: Point, other: Point) -> f64 {
    let size = dot(one, one).sqrt() * dot(other, other).sqrt();
    if size == 0.0 { 0.0 } else { 1.0 - dot(one, other) / size }
}

fn triangulations(low: usize, high: usize) -> Vec<Vec<Triangle>> {
    if high - low < 2 {
        return vec![Vec::new()];
    }
    let with_middle = |middle: usize| {
        let (left, right) = (triangulations(low, middle), triangulations(middle, high));
        let joined = move |left: &Vec<Triangle>| -> Vec<Vec<Triangle>> {
            right.iter().map(|right| [&left[..], &[[low, middle, high]], right].concat()).collect()
        };
        left.iter().flat_map(joined).collect::<Vec<_>>()
    };
    (low + 1..high).flat_map(with_middle).collect()
}

/// Numbers that look random.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }

    fn point(&mut self, size: u64) -> Point {
        std::array::from_fn(|_| self.below(2 * size + 1) as f64 - size as f64)
    }

    /// A hole of small whole coordinates, many of whose triangles lie in one plane or on one line if they are very small.
    fn hole(&mut self, count: usize, size: u64) -> Hole {
        let mut vertices: Vec<VertexId> = (0..count as u32).map(VertexId).collect();
        vertices.rotate_left(self.below(count as u64) as usize);
        let joined = (0..self.below(4)).map(|_| {
            let low = self.below(count as u64 - 2) as usize;
            [low, low + 2 + self.below((count - low - 2) as u64) as usize]
        });
        let joined = joined.filter(|&[low, high]| high - low < count - 1).collect();
        let points = (0..count).map(|_| self.point(size)).collect();
        let beside = (0..count).map(|_| self.point(size)).collect();
        Hole { points, vertices, beside, joined }
    }
}

#[test]
fn a_small_hole_gets_the_best_of_all_its_fills() {
    let mut random = Random(7);
    let (mut filled, mut flat) = (0, 0);
    for round in 0..1500 {
        let hole = random.hole(3 + round % 6, [1, 2, 40][round % 3]);
        for by in [FillBy::Fold, FillBy::Area] {
            let best = hole.best(by);
            let expected = hole.best_of_all(by);
            assert_eq!(best.is_some(), expected.is_some());
            let (Some(best), Some((zero_area, fold, area))) = (best, expected) else { continue };
            let is_as_flat = by == FillBy::Area || (best.cost.fold - fold).abs() < 1e-9;
            assert!(best.cost.zero_area == zero_area && is_as_flat, "{:?} {fold}", best.cost);
            assert!((best.cost.area - area).abs() <= 1e-9 * area, "{:?} {area}", best.cost);
            filled += 1;
            flat += usize::from(zero_area > 0);
        }
    }
    assert!(filled > 2500 && flat > 100, "{filled} {flat}");
}

#[test]
fn of_equal_fills_the_first_list_is_taken() {
    for count in 4..9 {
        let round = |place: usize| (place as f64 / count as f64 * std::f64::consts::TAU).sin_cos();
        let points: Vec<Point> = (0..count).map(round).map(|(y, x)| [x, y, 0.0]).collect();
        let vertices: Vec<VertexId> = (0..count as u32).map(|v| VertexId((v + 3) % count as u32)).collect();
        let hole = Hole { points, beside: vec![[0.0, 0.0, 1.0]; count], joined: vec![[0, 2]], vertices };
        let names = |triangles: &Vec<Triangle>| -> Vec<[VertexId; 3]> {
            triangles.iter().map(|t| t.map(|corner| hole.vertices[corner])).collect()
        };
        let all = triangulations(0, count - 1);
        let first = all.iter().filter(|t| hole.naive_cost(t).is_some()).map(names).min();
        assert_eq!(hole.best(FillBy::Fold).map(|fill| names(&fill.triangles)), first, "{count}");
    }
}

#[test]
fn the_size_of_a_hole_and_where_it_is_do_not_matter() {
    let mut random = Random(3);
    for round in 0..60 {
        let hole = random.hole(5 + round % 6, 9);
        let moved = |factor: f64, by: f64| Hole {
            points: hole.points.iter().map(|point| point.map(|x| x * factor + by)).collect(),
            vertices: hole.vertices.clone(),
            beside: hole.beside.clone(),
            joined: hole.joined.clone(),
        };
        let triangles = |hole: &Hole| hole.best(FillBy::Fold).map(|fill| fill.triangles);
        for (factor, by) in [(2f64.powi(-1050), 0.0), (2f64.powi(1000), 0.0), (1.0, 2f64.powi(40))] {
            assert_eq!(triangles(&moved(factor, by)), triangles(&hole), "{factor} {by}");
        }
    }
}

/// A wavy ring, with what stands upright beside it.
fn ring(count: usize) -> Hole {
    let angle = |place: usize| place as f64 / count as f64 * std::f64::consts::TAU;
    let points = (0..count).map(|place| {
        let (y, x) = angle(place).sin_cos();
        [x, y, 0.2 * (5.0 * angle(place)).sin() + 0.01 * ((place * 7919 % 13) as f64)]
    });
    let beside = (0..count).map(|place| {
        let (y, x) = angle(place).sin_cos();
        [x, y, 0.5]
    });
    Hole {
        points: points.collect(),
        beside: beside.collect(),
        vertices: (0..count as u32).map(VertexId).collect(),
        joined: (0..count / 3).map(|low| [low, low + 2]).collect(),
    }
}

#[test]
fn a_large_hole_is_filled_no_worse_than_by_triangulating_its_polygon() {
    for count in [65, 100, 400] {
        let hole = ring(count);
        let best = hole.best(FillBy::Fold).unwrap();
        assert_eq!(best.triangles.len(), count - 2);
        hole.asked(|opening| {
            let polygon = Polygon { points: opening.points, vertices: opening.vertices };
            for avoid in [Avoid::Folds, Avoid::TakenDiagonals] {
                let mut cut = triangulate_polygon(polygon, avoid, opening.is_joined);
                cut.iter_mut().for_each(|triangle| triangle.sort_unstable());
                let cost = measure(opening, &Scaled::of(opening), &cut);
                assert!(cost.is_none_or(|cost| best.cost.fold <= cost.fold), "{cost:?} {:?}", best.cost);
            }
        });
    }
}

#[test]
fn a_fan_folds_at_all_its_sides() {
    let square = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]];
    let wall = direction_of_face(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [0.0, 0.0, 1.0]]);
    let hole =
        Hole { points: square.to_vec(), vertices: Vec::new(), beside: vec![wall; 4], joined: Vec::new() };
    let cost = hole.asked(|opening| fan_cost(opening, [0.5, 0.5, 0.0]));
    assert_eq!((cost.zero_area, cost.fold, cost.area), (0, 1.0, 1.0));
    let on_side = hole.asked(|opening| fan_cost(opening, [0.5, 0.0, 0.0]));
    assert_eq!((on_side.zero_area, on_side.fold), (1, 1.0));
}
