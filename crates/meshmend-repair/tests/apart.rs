//! What was taken apart stays apart in a format without indices.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::PolygonMesh;
use meshmend_core::{Build, EdgeUse};
use meshmend_repair::{
    ApartFate, ApartRecord, Context, FaceStorage, KeepApart, NotMoved, Pass, Pipeline, Precision, Repaired,
    Weld,
};
use meshmend_topology::TopologyReport;

/// Boxes of two triangles a side over shared vertices.
fn boxes(all: &[[[i32; 3]; 2]]) -> PolygonMesh {
    let mut points: Vec<[i32; 3]> = Vec::new();
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for [low, high] in all {
        let ends = [low, high];
        let corner = |code: usize| [ends[code >> 2][0], ends[code >> 1 & 1][1], ends[code & 1][2]];
        let ids: Vec<u32> = (0..8)
            .map(|code| {
                let place = points.iter().position(|point| *point == corner(code));
                place.unwrap_or_else(|| {
                    points.push(corner(code));
                    points.len() - 1
                }) as u32
            })
            .collect();
        for side in [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]] {
            let [a, b, c, d] = side.map(|corner: usize| ids[corner]);
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    PolygonMesh::from_triangles(&points, &faces).unwrap()
}

/// Two boxes that touch along an edge, and one that touches a corner of the second.
fn touching() -> PolygonMesh {
    boxes(&[[[0; 3], [1, 1, 1]], [[1, 1, 0], [2, 2, 1]], [[2, 2, 1], [3, 3, 3]]])
}

fn pipeline(storage: FaceStorage) -> Pipeline {
    Pipeline::default().with(KeepApart::default()).in_precision(Precision::Single).storing(storage)
}

fn records(repaired: &Repaired) -> Vec<&ApartRecord> {
    repaired.passes.iter().flat_map(|pass| &pass.apart).collect()
}

/// A mesh as a file without indices has it, welded when it is read.
fn read_again(mesh: &PolygonMesh) -> PolygonMesh {
    let points: Vec<[f32; 3]> = mesh
        .faces()
        .corner_vertices()
        .iter()
        .map(|&vertex| mesh.position(vertex).map(|x| x as f32))
        .collect();
    let faces: Vec<[u32; 3]> =
        (0..points.len() as u32 / 3).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    let soup = PolygonMesh::from_triangles(&points, &faces).unwrap();
    Weld::default().apply(&soup, &Context::default()).unwrap().mesh
}

fn topology(mesh: &PolygonMesh) -> TopologyReport {
    meshmend_topology::topology(&EdgeUse::build(mesh.complex()).unwrap(), mesh)
}

#[test]
fn what_split_took_apart_is_apart_when_it_is_read_again() {
    let plain = Pipeline::default()
        .in_precision(Precision::Single)
        .storing(FaceStorage::apart())
        .run(&touching())
        .unwrap();
    assert!(!topology(&read_again(&plain.mesh)).manifold, "without the pass it is one again");
    let repaired = pipeline(FaceStorage::apart()).run(&touching()).unwrap();
    let again = topology(&read_again(&repaired.mesh));
    assert_eq!((again.manifold, again.components, again.vertices), (true, 3, 24));
    let moved = records(&repaired);
    assert_eq!(moved.len(), 3, "two of the edge, and the corner: {moved:?}");
    for record in &moved {
        let ApartFate::Moved { length, steps } = record.fate else { panic!("{record}") };
        assert!(steps == 1 && length > 0.0 && length < 1e-6, "{record}");
    }
    let text = moved[0].to_string();
    assert!(text.ends_with("1 step of single precision") && text.contains("moved by"), "{text}");
    let second = pipeline(FaceStorage::apart()).run(&read_again(&repaired.mesh)).unwrap();
    assert!(!second.is_changed());
}

#[test]
fn a_format_with_indices_needs_no_move() {
    let repaired = pipeline(FaceStorage::default()).run(&touching()).unwrap();
    assert!(records(&repaired).is_empty());
    assert!(repaired.mesh.positions().iter().flatten().all(|x| x.fract() == 0.0));
}

#[test]
fn a_vertex_without_room_is_named() {
    // Two tetrahedra of the least numbers of single precision, which touch in a corner.
    let tiny = f64::from(f32::from_bits(1));
    let corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [-1, 0, 0], [0, -1, 0], [0, 0, -1]];
    let points = corners.map(|point: [i32; 3]| point.map(|x| f64::from(x) * tiny));
    let faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [0, 4, 5], [0, 5, 6], [0, 6, 4], [4, 6, 5]];
    let mesh = PolygonMesh::from_triangles(&points, &faces).unwrap();
    let repaired = pipeline(FaceStorage::apart()).run(&mesh).unwrap();
    let left: Vec<ApartFate> = records(&repaired).iter().map(|record| record.fate).collect();
    assert_eq!(left, [ApartFate::Left { left: NotMoved::NoRoom }]);
}
