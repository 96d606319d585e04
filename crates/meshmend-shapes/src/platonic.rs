//! The five Platonic solids, faces outward.
//!
//! | solid | V | E | F |
//! |---|--:|--:|--:|
//! | tetrahedron | 4 | 6 | 4 |
//! | cube | 8 | 12 | 6 |
//! | octahedron | 6 | 12 | 8 |
//! | dodecahedron | 20 | 30 | 12 |
//! | icosahedron | 12 | 30 | 20 |

use crate::mesh_builder::MeshBuilder;
use crate::{Closed, Shape, ShapeError};

/// Four triangles. V = 4, E = 6, F = 4.
///
/// # Errors
/// None: it is small.
pub fn tetrahedron() -> Result<Shape, ShapeError> {
    solid("tetrahedron", tetrahedron_sketch(), [4, 6, 4])
}

/// Six squares; corners at 0 and 1. V = 8, E = 12, F = 6.
///
/// # Errors
/// None: it is small.
pub fn cube() -> Result<Shape, ShapeError> {
    solid("cube", unit_box(), [8, 12, 6])
}

/// Eight triangles. V = 6, E = 12, F = 8.
///
/// # Errors
/// None: it is small.
pub fn octahedron() -> Result<Shape, ShapeError> {
    let positions = [[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]];
    let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    solid("octahedron", builder(positions, faces), [6, 12, 8])
}

/// Twelve pentagons: the dual of the icosahedron. V = 20, E = 30, F = 12.
///
/// # Errors
/// None: it is small.
pub fn dodecahedron() -> Result<Shape, ShapeError> {
    let (points, triangles) = icosahedron_parts();
    let sum = |axis: usize, face: &[u32; 3]| face.iter().map(|&v| points[v as usize][axis]).sum::<f64>();
    let mut dual = MeshBuilder::default();
    dual.points(triangles.iter().map(|face| [0, 1, 2].map(|axis| sum(axis, face))));
    for v in 0..points.len() as u32 {
        dual.face(&round(&triangles, v));
    }
    solid("dodecahedron", dual, [20, 30, 12])
}

/// Twenty triangles. V = 12, E = 30, F = 20.
///
/// # Errors
/// None: it is small.
pub fn icosahedron() -> Result<Shape, ShapeError> {
    let (points, triangles) = icosahedron_parts();
    solid("icosahedron", builder(points, triangles), [12, 30, 20])
}

pub(crate) fn tetrahedron_sketch() -> MeshBuilder {
    let positions = [[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]];
    builder(positions, [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
}

/// The cube between the corners (0, 0, 0) and (1, 1, 1), six squares outward; vertex 4x + 2y + z.
pub(crate) fn unit_box() -> MeshBuilder {
    let positions = (0..8).map(|i| [f64::from(i / 4), f64::from(i / 2 % 2), f64::from(i % 2)]);
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    builder(positions, faces)
}

fn icosahedron_parts() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let mut points = Vec::new();
    for axis in 0..3 {
        for [one, phi] in [[1.0, golden], [-1.0, golden], [1.0, -golden], [-1.0, -golden]] {
            let mut point = [0.0; 3];
            point[(axis + 1) % 3] = one;
            point[(axis + 2) % 3] = phi;
            points.push(point);
        }
    }
    // Edges have length 2: the faces are the triples that are that far apart, turned outward.
    let near = |a: u32, b: u32| (distance_squared(&points, a, b) - 4.0).abs() < 1e-9;
    let pairs = (0..12u32).flat_map(|a| (a + 1..12).map(move |b| [a, b])).filter(|&[a, b]| near(a, b));
    let thirds = |[a, b]: [u32; 2]| (b + 1..12).map(move |c| [a, b, c]);
    let faces = pairs.flat_map(thirds).filter(|&[a, b, c]| near(b, c) && near(c, a));
    let outward = |[a, b, c]: [u32; 3]| if volume(&points, [a, b, c]) > 0.0 { [a, b, c] } else { [a, c, b] };
    let triangles = faces.map(outward).collect();
    (points, triangles)
}

/// The triangles round a vertex of a closed, oriented surface, in order.
fn round(triangles: &[[u32; 3]], vertex: u32) -> Vec<u32> {
    let ends = |face: &[u32; 3]| {
        let at = face.iter().position(|&v| v == vertex)?;
        Some([face[(at + 1) % 3], face[(at + 2) % 3]])
    };
    let star: Vec<(u32, [u32; 2])> =
        (0..).zip(triangles).filter_map(|(f, face)| Some((f, ends(face)?))).collect();
    let next =
        |&(_, [_, last]): &(u32, [u32; 2])| star.iter().find(|(_, [first, _])| *first == last).copied();
    std::iter::successors(star.first().copied(), next).take(star.len()).map(|(face, _)| face).collect()
}

fn solid(name: &str, builder: MeshBuilder, counts: [usize; 3]) -> Result<Shape, ShapeError> {
    builder.surface(name, Closed::Handles(0), 0, counts)
}

fn builder<const N: usize>(
    points: impl IntoIterator<Item = [f64; 3]>,
    faces: impl IntoIterator<Item = [u32; N]>,
) -> MeshBuilder {
    let mut builder = MeshBuilder::default();
    builder.points(points);
    faces.into_iter().for_each(|face| builder.face(&face));
    builder
}

fn distance_squared(points: &[[f64; 3]], a: u32, b: u32) -> f64 {
    (0..3).map(|axis| (points[a as usize][axis] - points[b as usize][axis]).powi(2)).sum()
}

fn volume(points: &[[f64; 3]], face: [u32; 3]) -> f64 {
    let [a, b, c] = face.map(|v| points[v as usize]);
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}
