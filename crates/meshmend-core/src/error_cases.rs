//! Every variant of every error of this crate, with its message. Within the crate a new variant does not compile until it is
//! listed here.

use meshmend_testkit::assert_every_variant;

use crate::*;

fn ids<const N: usize>(vertices: [u32; N]) -> Vec<VertexId> {
    vertices.map(VertexId).to_vec()
}

fn triangle() -> PolygonMesh {
    let faces = FaceTable::triangles(3, ids([0, 1, 2])).unwrap();
    PolygonMesh::new(vec![[0.0; 3]; 3], faces).unwrap()
}

#[test]
fn a_list_that_is_no_face_table() {
    let cases = vec![
        (
            FaceTable::polygons(3, vec![0, 0, 3], ids([0, 1, 3])).unwrap_err(),
            "corner 2 of face 1 names vertex 3, but there are 3 vertices",
        ),
        (
            FaceTable::triangles(MAX_CORNERS, Vec::new()).unwrap_err(),
            "2147483648 vertices are more than the 2147483648 that a table holds",
        ),
        (FaceTable::triangles(3, ids([0, 1])).unwrap_err(), "2 corners can't be cut into triangles of three"),
        (
            triangle().faces().over(3, ids([0])).unwrap_err(),
            "the faces have 3 corners, but there is 1 corner",
        ),
        (
            FaceTable::polygons(3, vec![], ids([0])).unwrap_err(),
            "the starts of the faces are empty; without a face they are [0]",
        ),
        (FaceTable::polygons(3, vec![1], ids([0])).unwrap_err(), "the first of the starts is 1, not 0"),
        (
            FaceTable::polygons(3, vec![0, 1, 0], ids([0])).unwrap_err(),
            "face 1 begins at corner 1 and ends before it, at corner 0",
        ),
        (
            FaceTable::polygons(3, vec![0, 2], ids([0])).unwrap_err(),
            "the last of the starts is 2, but there is 1 corner",
        ),
    ];
    assert_every_variant!(
        cases,
        FaceTableError {
            NoSuchVertex,
            TooLarge,
            NotTriangles,
            CornerCount,
            NoStarts,
            FirstStart,
            Descending,
            LastStart
        }
    );
}

#[test]
fn parts_that_are_no_mesh() {
    let layer = |uses| Layer::indexed("quality", Domain::Face, 1, Carry::Copy, Values::U8(vec![7]), uses);
    let cases = vec![
        (
            PolygonMesh::new(vec![[0.0; 3]], FaceTable::empty(2)).unwrap_err(),
            "the faces are over 2 vertices, but there is 1 position",
        ),
        (
            triangle().with_positions(Vec::new()).unwrap_err(),
            "the faces are over 3 vertices, but there are 0 positions",
        ),
        (
            triangle().with_loose(Vec::new(), ids([2, 3])).unwrap_err(),
            "loose point 1 names vertex 3, but there are 3 vertices",
        ),
        (
            triangle().with_layers(vec![layer(vec![0, 0])]).unwrap_err(),
            "the layer `quality` is for 2 elements, but the mesh has 1",
        ),
        (
            triangle().with_layers(vec![layer(vec![1])]).unwrap_err(),
            "the layer `quality` uses values that it does not have",
        ),
    ];
    assert_every_variant!(cases, MeshError { VertexCount, NoSuchVertex, LayerSize, LayerValues });
}

#[test]
fn a_draft_that_makes_no_mesh() {
    let mesh = triangle().with_loose(Vec::new(), ids([2])).unwrap();
    let draft = || Draft::of_faces(&mesh, mesh.faces().clone(), Sources::same(1), Sources::same(3));
    let dropped = Draft {
        vertex_sources: Sources::same(2),
        ..Draft::of_faces(&mesh, FaceTable::empty(2), Sources::same(0), Sources::same(0))
    };
    let astray = Draft { merged_into: Some(ids([0, 1, 9])), ..draft() };
    let cases = vec![
        (
            mesh.rebuild(Draft { face_sources: Sources::same(3), ..draft() }).unwrap_err(),
            "a draft has 3 face sources, but needs 1",
        ),
        (mesh.rebuild(dropped).unwrap_err(), "a draft drops v2, which a loose element uses"),
        (mesh.rebuild(astray).unwrap_err(), "loose point 0 names vertex 9, but there are 3 vertices"),
        (
            FaceTable::triangles(MAX_CORNERS, Vec::new()).unwrap_err().into(),
            "2147483648 vertices are more than the 2147483648 that a table holds",
        ),
    ];
    assert_every_variant!(cases, DraftError { Count, LooseVertex, Mesh, Table });
}
