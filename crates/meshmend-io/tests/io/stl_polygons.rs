//! Polygons in STL: triangles that cover what the face covers, and repeat no edge.

use meshmend_core::{FaceTableBuilder, PolygonMesh, VertexId};
use meshmend_io::{Encoding, Format, LossKind};

use crate::common::{read, written};

/// Faces by the points of their corners, each corner a vertex of its own unless one before it has its point.
fn mesh(faces: &[Vec<[f64; 3]>]) -> PolygonMesh {
    let mut positions: Vec<[f64; 3]> = Vec::new();
    let mut builder = FaceTableBuilder::default();
    for face in faces {
        let vertices: Vec<VertexId> = face
            .iter()
            .map(|point| {
                let known = positions.iter().position(|p| p == point);
                VertexId(known.unwrap_or_else(|| {
                    positions.push(*point);
                    positions.len() - 1
                }) as u32)
            })
            .collect();
        builder.push_face(vertices);
    }
    let table = builder.build(positions.len()).unwrap();
    PolygonMesh::new(positions, table).unwrap()
}

fn flat(corners: &[[f64; 2]]) -> Vec<[f64; 3]> {
    corners.iter().map(|&[x, y]| [x, y, 0.0]).collect()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The points of each triangle that is read again, both encodings giving the same.
fn triangles(mesh: &PolygonMesh) -> Vec<[[f64; 3]; 3]> {
    let read_again = |encoding| -> Vec<[[f64; 3]; 3]> {
        let again = read(Format::Stl, written(mesh, Format::Stl, encoding).0).mesh;
        let corners = again.faces().corner_vertices().chunks_exact(3);
        corners.map(|c| [c[0], c[1], c[2]].map(|v| again.position(v))).collect()
    };
    let found = read_again(Encoding::LittleEndian);
    assert_eq!(found, read_again(Encoding::Ascii));
    found
}

/// The area vector of a triangle.
fn area([a, b, c]: &[[f64; 3]; 3]) -> [f64; 3] {
    let minus = |p: &[f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    cross(minus(b), minus(c)).map(|x| x / 2.0)
}

fn total_area(triangles: &[[[f64; 3]; 3]]) -> f64 {
    triangles.iter().map(|t| area(t).iter().map(|x| x * x).sum::<f64>().sqrt()).sum()
}

/// No edge has more than two sides, and these run opposite ways; no triangle is there twice.
fn assert_manifold(triangles: &[[[f64; 3]; 3]]) {
    let bits = |p: &[f64; 3]| p.map(|x| (x + 0.0).to_bits());
    let mut sides: Vec<[[u64; 3]; 2]> =
        triangles.iter().flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]].map(|side| side.map(bits))).collect();
    sides.sort_unstable();
    assert!(sides.windows(2).all(|pair| pair[0] != pair[1]), "an edge is run twice the same way");
}

/// All triangles face up.
#[track_caller]
fn assert_flat_cover(corners: &[[f64; 2]], size: f64) {
    for shift in 0..corners.len() {
        let begun = [&corners[shift..], &corners[..shift]].concat();
        let found = triangles(&mesh(&[flat(&begun)]));
        assert!(found.iter().all(|triangle| area(triangle)[2] > 0.0), "{found:?}");
        assert!((total_area(&found) - size).abs() < 1e-6 * size, "{} of {size}", total_area(&found));
        assert_manifold(&found);
    }
}

#[test]
fn concave_faces_are_covered_once() {
    let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
    assert_flat_cover(&arrow, 1.5);
    let lower: Vec<[f64; 3]> = flat(&arrow).into_iter().rev().collect();
    let upper: Vec<[f64; 3]> = arrow.iter().map(|&[x, y]| [x, y, 1.0]).collect();
    let walls = (0..4).map(|i| {
        let ([a, b], [c, d]) = (arrow[i], arrow[(i + 1) % 4]);
        vec![[a, b, 0.0], [c, d, 0.0], [c, d, 1.0], [a, b, 1.0]]
    });
    let prism = mesh(&[vec![lower, upper], walls.collect()].concat());
    let found = triangles(&prism);
    assert!((total_area(&found) - 9.7082).abs() < 1e-4, "{}", total_area(&found));
    let volume: f64 =
        found.iter().map(|t| t[0].iter().zip(area(t)).map(|(x, y)| x * y / 3.0).sum::<f64>()).sum();
    assert!((volume - 1.5).abs() < 1e-6, "{volume}");
    assert_manifold(&found);
    let teeth = (0..40).flat_map(|i| [[f64::from(i), 0.0], [f64::from(i) + 0.5, 9.0]]);
    let comb: Vec<[f64; 2]> = teeth.chain([[40.0, -1.0], [0.0, -1.0]]).rev().collect();
    let size =
        comb.iter().zip(comb.iter().cycle().skip(1)).map(|(p, q)| p[0] * q[1] - q[0] * p[1]).sum::<f64>()
            / 2.0;
    assert_flat_cover(&comb, size);
}

#[test]
fn faces_with_holes_stay_open_however_the_bridge_is_written() {
    let rim = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]];
    let hole = [[1.0, 1.0], [1.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0]];
    let ring = [&rim[..], &rim[..1], &hole].concat();
    assert_flat_cover(&ring, 12.0);
    // With vertices of its own for the way back.
    let positions = flat(&ring);
    let mut builder = FaceTableBuilder::default();
    builder.push_face((0..10).map(VertexId));
    let doubled = PolygonMesh::new(positions, builder.build(10).unwrap()).unwrap();
    let found = triangles(&doubled);
    assert_eq!((found.len(), total_area(&found)), (8, 12.0));
    assert_manifold(&found);
    let losses = written(&doubled, Format::Stl, Encoding::Ascii).1;
    let said = losses.iter().find(|loss| loss.kind == LossKind::Polygons).unwrap();
    assert_eq!(
        said.message,
        "1 face of more than three corners: cut into triangles, 1 face with a hole left open"
    );
}

#[test]
fn a_face_that_touches_itself_in_a_vertex_is_split_there() {
    assert_flat_cover(&[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]], 2.0);
}

/// A triangle that lies where half of a square is, and squares on squares, front and back.
#[test]
fn no_edge_and_no_triangle_is_there_twice_by_position() {
    let square = flat(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
    for half in [[0, 1, 2], [1, 2, 3], [0, 2, 3], [0, 1, 3]] {
        let triangle: Vec<[f64; 3]> = half.iter().map(|&i: &usize| square[i]).collect();
        let reversed = triangle.iter().rev().copied().collect();
        for lying in [triangle, reversed] {
            let found = triangles(&mesh(&[lying, square.clone()]));
            let different = |t: &[[f64; 3]; 3]| {
                let mut points = t.map(|p| p.map(f64::to_bits));
                points.sort_unstable();
                points
            };
            let first = different(&found[0]);
            assert!(found[1..].iter().all(|t| different(t) != first), "{found:?}");
        }
    }
    // Both diagonals are taken by the time the third square comes.
    let back: Vec<[f64; 3]> = square.iter().rev().copied().collect();
    let found = mesh(&[square.clone(), back, square]);
    assert_eq!(triangles(&found).len(), 2 + 2 + 4);
    let losses = written(&found, Format::Stl, Encoding::LittleEndian).1;
    assert_eq!(
        losses[0].message,
        "3 faces of more than three corners: cut into triangles, with 1 vertex more"
    );
}
