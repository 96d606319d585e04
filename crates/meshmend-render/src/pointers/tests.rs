//! Every element of every kind of mesh is drawn, and what can't be is named.

use meshmend_core::{CornerId, EdgeId, FaceId, FaceTableBuilder, VertexId};
use meshmend_shapes::{cube, moebius_band, tetrahedron};

use super::*;

fn mesh(positions: &[[f64; 3]], faces: &[&[u32]]) -> PolygonMesh {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    PolygonMesh::new(positions.to_vec(), builder.build(positions.len()).unwrap()).unwrap()
}

/// All elements of a mesh.
fn cells(mesh: &PolygonMesh) -> Vec<Cell> {
    let kernel = EdgeUse::assemble(mesh.complex());
    let vertices = kernel.vertices().map(Cell::Vertex);
    let (edges, faces) = (kernel.edges().map(Cell::Edge), kernel.faces().map(Cell::Face));
    vertices.chain(edges).chain(faces).chain(kernel.corners().map(Cell::Corner)).collect()
}

/// The texts of a drawing, which must be well-formed and say nothing that is not a number.
fn texts(svg: &str) -> Vec<String> {
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    let mut reader = quick_xml::Reader::from_str(svg);
    let mut texts = Vec::new();
    loop {
        match reader.read_event().unwrap() {
            quick_xml::events::Event::Text(text) => texts.push(text.xml10_content().trim().to_owned()),
            quick_xml::events::Event::Eof => return texts,
            _ => {}
        }
    }
}

#[test]
fn every_element_of_a_mesh_is_drawn_with_its_arrows() {
    let far = [[0.0; 3], [f64::NAN, 0.0, 0.0], [1e300, 0.0, 0.0], [0.0; 3], [1.0; 3]];
    let meshes = [
        cube().unwrap().mesh,
        tetrahedron().unwrap().mesh,
        moebius_band(5, 1).unwrap().mesh,
        mesh(&far, &[&[0, 1, 2], &[2, 1, 3], &[0, 0, 4]]),
        mesh(&[[0.0; 3]; 9], &[&[0, 1, 2], &[0, 1, 3], &[0, 1, 4], &[0, 5, 6, 7, 6]]),
    ];
    for mesh in &meshes {
        for at in cells(mesh) {
            let all: Vec<Pointer> = cells(mesh)
                .into_iter()
                .take(12)
                .map(|cell| Pointer { field: "to", to: Target::Cell(cell) })
                .collect();
            let outside = [
                Pointer { field: "twin", to: Target::Dart(7) },
                Pointer { field: "right", to: Target::Hole },
                Pointer { field: "none", to: Target::Nothing },
            ];
            let record = [&all[..], &outside].concat();
            let texts = texts(&pointer_picture(mesh, at, &record, "a <record> & more").unwrap());
            assert_eq!(texts.iter().filter(|text| *text == "to").count(), all.len(), "{at}");
            assert!(texts.contains(&"twin".to_owned()) && texts.contains(&"a hole".to_owned()));
            assert!(!texts.contains(&"none".to_owned()));
        }
    }
}

#[test]
fn what_is_too_much_or_not_there_is_named() {
    let mesh = tetrahedron().unwrap().mesh;
    let at = Cell::Edge(EdgeId(2));
    let many = [Pointer::new("to", FaceId(0)); MOST_ARROWS + 1];
    let refused =
        |at, pointers: &[Pointer]| pointer_picture(&mesh, at, pointers, "").unwrap_err().to_string();
    assert_eq!(refused(at, &many), "the record of e2 has 41 pointers, and a picture shows 40 at most");
    assert_eq!(refused(Cell::Edge(EdgeId(6)), &[]), "the mesh has no e6");
    assert_eq!(refused(at, &[Pointer::new("to", CornerId(12))]), "the mesh has no c12");
}
