//! The schemes of subdivision that are examples of the operators are what they are by tables.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]
#![allow(clippy::duplicate_mod, reason = "each example has what is common to them by itself")]

#[path = "../examples/catmull_clark.rs"]
#[allow(dead_code, reason = "an example has a main function of its own")]
mod catmull_clark;
#[path = "../examples/loop_scheme.rs"]
#[allow(dead_code, reason = "an example has a main function of its own")]
mod loop_scheme;
#[path = "../examples/sqrt3.rs"]
#[allow(dead_code, reason = "an example has a main function of its own")]
mod sqrt3;

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use meshmend_core::PolygonMesh;
use meshmend_edit::Editor;
use meshmend_testkit::Soup;
use meshmend_testkit::shapes::catalogue;
use meshmend_testkit::worlds::damaged_grid;
use proptest::prelude::*;

type Point = [f64; 3];

/// The tables of a scheme: for each edge by its ends, ascending, the faces along it; and the neighbours of each vertex.
struct Tables {
    points: Vec<Point>,
    faces: Vec<Vec<u32>>,
    edges: BTreeMap<[u32; 2], Vec<usize>>,
}

impl Tables {
    fn of(mesh: &PolygonMesh) -> Self {
        let Soup { positions: points, faces } = Soup::of_mesh(mesh);
        let mut edges: BTreeMap<[u32; 2], Vec<usize>> = BTreeMap::new();
        for (at, face) in faces.iter().enumerate() {
            sides(face).for_each(|side| edges.entry(sorted(side)).or_default().push(at));
        }
        Tables { points, faces, edges }
    }

    fn middle(&self, side: [u32; 2]) -> u32 {
        (self.points.len() + self.edges.keys().position(|&edge| edge == sorted(side)).unwrap()) as u32
    }

    fn point(&self, vertex: u32) -> Point {
        self.points[vertex as usize]
    }

    fn face_point(&self, face: usize) -> Point {
        mean(self.faces[face].iter().map(|&vertex| self.point(vertex)))
    }

    fn neighbours(&self, vertex: u32, along: usize) -> Vec<Point> {
        let at = self.edges.iter().filter(|(ends, faces)| ends.contains(&vertex) && faces.len() <= along);
        at.map(|(&[a, b], _)| self.point(if a == vertex { b } else { a })).collect()
    }

    fn is_on_rim(&self, vertex: u32) -> bool {
        !self.neighbours(vertex, 1).is_empty()
    }

    /// Three quarters of the vertex and a quarter of its neighbours along the boundary.
    fn rim_point(&self, vertex: u32) -> Point {
        blend(&[(0.75, self.point(vertex)), (0.25, mean(self.neighbours(vertex, 1)))])
    }

    fn vertex_points(
        &self,
        inside: impl Fn(u32, f64, Point) -> Point,
        rim: impl Fn(u32) -> Point,
    ) -> Vec<Point> {
        let new = |vertex: u32| {
            let ring = self.neighbours(vertex, 2);
            match (ring.is_empty(), self.is_on_rim(vertex)) {
                (true, _) => self.point(vertex),
                (_, true) => rim(vertex),
                _ => inside(vertex, ring.len() as f64, mean(ring.iter().copied())),
            }
        };
        (0..self.points.len() as u32).map(new).collect()
    }
}

fn sides(face: &[u32]) -> impl Iterator<Item = [u32; 2]> {
    (0..face.len()).map(|at| [face[at], face[(at + 1) % face.len()]])
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

fn mean(points: impl IntoIterator<Item = Point>) -> Point {
    let points: Vec<Point> = points.into_iter().collect();
    [0, 1, 2].map(|axis| points.iter().map(|point| point[axis]).sum::<f64>() / points.len() as f64)
}

fn blend(terms: &[(f64, Point)]) -> Point {
    [0, 1, 2].map(|axis| terms.iter().map(|(weight, point)| weight * point[axis]).sum())
}

fn catmull_clark_by_tables(mesh: &PolygonMesh) -> Soup {
    let tables = Tables::of(mesh);
    let inside = |vertex: u32, n: f64, ring: Point| {
        let at = tables.faces.iter().enumerate().filter(|(_, face)| face.contains(&vertex));
        let around = mean(at.map(|(face, _)| tables.face_point(face)));
        let halfway = blend(&[(0.5, ring), (0.5, tables.point(vertex))]);
        blend(&[(1.0 / n, around), (2.0 / n, halfway), ((n - 3.0) / n, tables.point(vertex))])
    };
    let mut points = tables.vertex_points(inside, |vertex| tables.rim_point(vertex));
    points.extend(tables.edges.iter().map(|(&[a, b], faces)| {
        let ends = [tables.point(a), tables.point(b)];
        let inner = faces.iter().map(|&face| tables.face_point(face));
        if faces.len() == 2 { mean(ends.into_iter().chain(inner)) } else { mean(ends) }
    }));
    let first_centre = points.len() as u32;
    points.extend((0..tables.faces.len()).map(|face| tables.face_point(face)));
    let quads = tables.faces.iter().zip(first_centre..).flat_map(|(face, centre)| {
        let before = |at: usize| face[(at + face.len() - 1) % face.len()];
        let quad = |(at, [a, b]): (usize, [u32; 2])| {
            vec![a, tables.middle([a, b]), centre, tables.middle([before(at), a])]
        };
        sides(face).enumerate().map(quad).collect::<Vec<_>>()
    });
    Soup { faces: quads.collect(), positions: points }
}

fn loop_by_tables(mesh: &PolygonMesh) -> Soup {
    let tables = Tables::of(mesh);
    let inside = |vertex: u32, n: f64, ring: Point| {
        let beta = (0.625 - (0.375 + (TAU / n).cos() / 4.0).powi(2)) / n;
        blend(&[(1.0 - n * beta, tables.point(vertex)), (n * beta, ring)])
    };
    let mut points = tables.vertex_points(inside, |vertex| tables.rim_point(vertex));
    points.extend(tables.edges.iter().map(|(&[a, b], faces)| {
        let tip = |&face: &usize| tables.faces[face].iter().copied().find(|&v| v != a && v != b).unwrap();
        let (ends, tips) =
            (mean([tables.point(a), tables.point(b)]), faces.iter().map(|face| tables.point(tip(face))));
        if faces.len() == 2 { blend(&[(0.75, ends), (0.25, mean(tips))]) } else { ends }
    }));
    let triangles = tables.faces.iter().flat_map(|face| {
        let [a, b, c] = face[..].try_into().unwrap();
        let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|side| tables.middle(side));
        [vec![a, ab, ca], vec![ab, b, bc], vec![ca, bc, c], vec![ab, bc, ca]]
    });
    Soup { faces: triangles.collect(), positions: points }
}

fn sqrt3_by_tables(mesh: &PolygonMesh) -> Soup {
    let tables = Tables::of(mesh);
    let inside = |vertex: u32, n: f64, ring: Point| {
        let alpha = (4.0 - 2.0 * (TAU / n).cos()) / 9.0;
        blend(&[(1.0 - alpha, tables.point(vertex)), (alpha, ring)])
    };
    let mut points = tables.vertex_points(inside, |vertex| tables.point(vertex));
    let centre = |face: usize| (tables.points.len() + face) as u32;
    points.extend((0..tables.faces.len()).map(|face| tables.face_point(face)));
    let triangles = tables.faces.iter().enumerate().flat_map(|(at, face)| {
        let triangle = |side: [u32; 2]| match tables.edges[&sorted(side)][..] {
            [one, other] => vec![side[0], centre(if one == at { other } else { one }), centre(at)],
            _ => vec![side[0], side[1], centre(at)],
        };
        sides(face).map(triangle).collect::<Vec<_>>()
    });
    Soup { faces: triangles.collect(), positions: points }
}

/// The same faces, begun anywhere and in any order, over vertices at the same points.
fn assert_same(found: &PolygonMesh, expected: &Soup) {
    let canonical = |faces: &[Vec<u32>]| {
        let mut faces = faces.to_vec();
        for face in &mut faces {
            let lowest = (0..face.len()).min_by_key(|&at| face[at]).unwrap();
            face.rotate_left(lowest);
        }
        faces.sort();
        faces
    };
    let found = Soup::of_mesh(found);
    assert_eq!(canonical(&found.faces), canonical(&expected.faces));
    for (one, other) in found.positions.iter().zip(&expected.positions) {
        for axis in 0..3 {
            assert!(
                (one[axis] - other[axis]).abs() <= 1e-12 * (1.0 + other[axis].abs()),
                "{one:?} {other:?}"
            );
        }
    }
    assert_eq!(found.positions.len(), expected.positions.len());
}

fn assert_all_schemes(mesh: &PolygonMesh) {
    assert_same(&catmull_clark::catmull_clark(mesh).unwrap(), &catmull_clark_by_tables(mesh));
    if mesh.faces().is_all_triangles() {
        assert_same(&loop_scheme::loop_scheme(mesh).unwrap(), &loop_by_tables(mesh));
        assert_same(&sqrt3::sqrt3(mesh).unwrap(), &sqrt3_by_tables(mesh));
    }
}

#[test]
fn shapes_are_subdivided_as_by_tables() {
    let mut count = 0;
    for shape in catalogue() {
        let mesh = shape.soup.mesh();
        if Editor::new(&mesh).is_ok() && mesh.counts().faces < 500 {
            assert_all_schemes(&mesh);
            count += 1;
        }
    }
    assert!(count > 10, "{count} shapes");
}

proptest! {
    #[test]
    fn surfaces_with_boundary_are_subdivided_as_by_tables(soup in damaged_grid()) {
        if Editor::new(&soup.mesh()).is_ok() {
            let mesh = soup.mesh();
            assert_all_schemes(&mesh);
            // What Catmull and Clark make has four sides a face: cut in two, it is for the other schemes.
            let quads = Soup::of_mesh(&mesh);
            let halves = quads.faces.iter().flat_map(|face| [vec![face[0], face[1], face[2]], vec![face[0], face[2], face[3]]]);
            assert_all_schemes(&Soup { faces: halves.collect(), positions: quads.positions }.mesh());
        }
    }
}

#[test]
fn texture_coordinates_go_with_a_subdivision() {
    use meshmend_core::{Carry, Domain, Layer, Values};
    let square = Soup {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
        faces: vec![vec![0, 1, 2, 3]],
    };
    let numbers = vec![0.0, 0.0, 8.0, 0.0, 8.0, 8.0, 0.0, 8.0];
    let uv = Layer::direct("texcoord", Domain::Corner, 2, Carry::Interpolate, Values::F64(numbers));
    let mesh = square.mesh().with_layers(vec![uv]).unwrap();
    let finer = catmull_clark::catmull_clark(&mesh).unwrap();
    let uv = finer.layer("texcoord", Domain::Corner).unwrap();
    let first = finer.faces().faces().next().unwrap();
    let values = uv.corner_values(finer.faces()).take(4).map(|value| {
        let value = value.unwrap();
        [uv.values().number(2 * value).unwrap(), uv.values().number(2 * value + 1).unwrap()]
    });
    let values: Vec<[f64; 2]> = values.collect();
    assert_eq!(finer.faces().face_vertices(first)[0].0, 0);
    assert_eq!(values, [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]);
}
