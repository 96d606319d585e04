//! The search against the naive way: every point against every shell, by the angles that its triangles fill.

use super::super::crossing::{Triangle, solid_angle};
use super::*;
use meshmend_geometry::vector::minus;

/// Pseudo-random numbers.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }

    fn part(&mut self) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}

/// A shell of triangles, with a point on each of up to 16 of them.
#[derive(Clone)]
struct Body {
    triangles: Vec<Triangle>,
    points: Vec<Point>,
}

impl Body {
    fn of(triangles: Vec<Triangle>) -> Self {
        let middle = |t: &Triangle| std::array::from_fn(|i| (t[0][i] + t[1][i] + t[2][i]) / 3.0);
        let points = triangles.iter().step_by(triangles.len() / MOST_POINTS + 1).map(middle).collect();
        Body { triangles, points }
    }

    fn moved(&self, size: [f64; 3], by: Point) -> Self {
        let place = |p: Point| std::array::from_fn(|i| p[i] * size[i] + by[i]);
        Body::of(self.triangles.iter().map(|t| t.map(place)).collect())
    }
}

fn tetrahedron() -> Body {
    let [a, b, c, d] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    Body::of(vec![[a, c, b], [a, b, d], [a, d, c], [b, c, d]])
}

/// A cube of n × n squares a side, each in two triangles.
fn cube(n: usize) -> Body {
    let mut triangles = Vec::new();
    let at = |k: usize| k as f64 / n as f64;
    for (axis, side) in (0..3).flat_map(|axis| [(axis, 0.0), (axis, 1.0)]) {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let corner = |i: usize, j: usize| {
                let mut point = [side; 3];
                (point[u], point[v]) = (at(i), at(j));
                point
            };
            let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            triangles.extend(if side > 0.0 { [[a, b, c], [a, c, d]] } else { [[a, c, b], [a, d, c]] });
        }
    }
    Body::of(triangles)
}

/// What the shells answer for.
fn found(bodies: &[Body]) -> Vec<bool> {
    let shells: Vec<Shell> = bodies.iter().map(|body| Shell::of(body.triangles.clone())).collect();
    let points: Vec<Vec<Point>> = bodies.iter().map(|body| body.points.clone()).collect();
    are_inside_oddly_many(&shells, &points)
}

fn naive(bodies: &[Body]) -> Vec<bool> {
    let holds = |outer: &Body, point: Point| {
        let corners = || outer.triangles.iter().flatten();
        let is_in = |i: usize| {
            let low = corners().fold(f64::INFINITY, |low, p| low.min(p[i]));
            let high = corners().fold(f64::NEG_INFINITY, |high, p| high.max(p[i]));
            low <= point[i] && point[i] <= high
        };
        if !(0..3).all(is_in) {
            return Some(false);
        }
        let mut angle = 0.0;
        for triangle in &outer.triangles {
            let [a, b, c] = triangle.map(|corner| minus(corner, point));
            angle += solid_angle(a, b, c)?;
        }
        Some((angle / (4.0 * std::f64::consts::PI)).abs() > 0.5)
    };
    let lies_in = |inner: &Body, outer: &Body| {
        inner.points.iter().find_map(|&point| holds(outer, point)).unwrap_or(false)
    };
    let depth = |place: usize| {
        let others = (0..bodies.len()).filter(|&other| other != place);
        others.filter(|&other| lies_in(&bodies[place], &bodies[other])).count()
    };
    (0..bodies.len()).map(|place| depth(place) % 2 == 1).collect()
}

/// Bodies of whole sizes at whole places touch along faces, edges and vertices, and pass through each other.
#[test]
fn bodies_on_a_grid_are_nested_as_the_naive_way_has_it() {
    let mut random = Random(1);
    let kinds = [tetrahedron(), cube(1), cube(3)];
    let mut hollows = 0;
    for case in 0..400 {
        let (count, room) = (2 + random.below(14), 2 + random.below(8));
        let body = |random: &mut Random| {
            let size = (1 + random.below(room)) as f64;
            let by = std::array::from_fn(|_| random.below(room) as f64);
            let turn = if random.below(4) == 0 { [-size, size, -size] } else { [size; 3] };
            kinds[random.below(3) as usize].moved(turn, by)
        };
        let bodies: Vec<Body> = (0..count).map(|_| body(&mut random)).collect();
        let expected = naive(&bodies);
        hollows += expected.iter().filter(|is_hollow| **is_hollow).count();
        assert_eq!(found(&bodies), expected, "case {case}");
    }
    assert!(hollows > 500, "{hollows}");
}

#[test]
fn bodies_anywhere_and_of_any_size_are_nested_as_the_naive_way_has_it() {
    let mut random = Random(2);
    let kinds = [tetrahedron(), cube(1), cube(2)];
    for case in 0..200 {
        let far = [0.0, 1.0, 1e6, -1e9][random.below(4) as usize];
        let body = |random: &mut Random| {
            let size = 10.0_f64.powf(random.part() * 3.0);
            let by = std::array::from_fn(|_| far + 100.0 * random.part());
            kinds[random.below(3) as usize].moved([size, size * (0.2 + random.part()), size], by)
        };
        let bodies: Vec<Body> = (0..2 + random.below(30)).map(|_| body(&mut random)).collect();
        assert_eq!(found(&bodies), naive(&bodies), "case {case}");
    }
}

#[test]
fn bodies_one_in_the_other_alternate() {
    for (kind, middle) in [(cube(1), 0.5), (tetrahedron(), 0.2)] {
        let doll = |k: usize| kind.moved([k as f64; 3], [-(k as f64) * middle; 3]);
        let bodies: Vec<Body> = (1..=101).map(doll).collect();
        let expected: Vec<bool> = (1..=101).map(|k| k % 2 == 0).collect();
        assert_eq!(found(&bodies), expected);
        assert_eq!(naive(&bodies), expected);
    }
}

/// A point beside its own shell, as the middle of a face that is not plane is.
#[test]
fn no_shell_lies_in_itself() {
    let outer = cube(1).moved([10.0; 3], [0.0; 3]);
    let mut bodies = vec![outer];
    for k in 0..40 {
        let mut body = cube(1).moved([0.1; 3], [1.0 + 0.2 * f64::from(k), 5.0, 5.0]);
        let inside = body.triangles[0][0].map(|x| x + 0.05);
        body.points.insert(0, inside);
        bodies.push(body);
    }
    let found = found(&bodies);
    assert!(!found[0] && found[1..].iter().all(|is_hollow| *is_hollow));
}

#[test]
fn what_has_no_volume_that_can_be_computed_holds_nothing() {
    for odd in [f64::NAN, f64::INFINITY, 1e200] {
        let mut outer = cube(1).moved([10.0; 3], [0.0; 3]);
        outer.triangles[0][0][1] = odd;
        let inner = tetrahedron().moved([1.0; 3], [2.0; 3]);
        let mut lost = inner.clone();
        lost.points[0][2] = odd;
        let bodies = [outer, inner, lost];
        assert_eq!(found(&bodies), [false; 3]);
        assert!(!naive(&bodies)[1]);
    }
}
