//! Every way in which parts make no table, no mesh or no draft, and every defect, each with what it says.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_core::{
    Aspect, Carry, Defect, Domain, Draft, DraftError, EdgeId, FaceId, FaceTable, FaceTableError, Layer,
    MAX_CORNERS, MeshError, PolygonMesh, Sources, Unjudged, Values, VertexId,
};
use meshmend_testkit::assert_every_variant;

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
            "face 1 names vertex 3, but there are 3 vertices",
        ),
        (
            FaceTable::triangles(MAX_CORNERS, Vec::new()).unwrap_err(),
            "2147483648 vertices are more than the 2147483648 that a table holds",
        ),
        (
            FaceTable::triangles(3, ids([0, 1])).unwrap_err(),
            "the starts of the faces do not ascend from 0 to 2",
        ),
    ];
    assert_every_variant!(cases, FaceTableError { NoSuchVertex, TooLarge, BadStarts });
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

#[test]
fn every_defect_says_where_it_is() {
    let (face, edge, vertex, ends) = (FaceId(1), EdgeId(2), VertexId(3), [VertexId(3), VertexId(4)]);
    let pinched = |boundary_only| Defect::pinched_vertex(vertex, 2, boundary_only);
    let cases = vec![
        (Defect::degenerate_face(face), "f1 has fewer than three different vertices"),
        (Defect::non_simple_face(face, vertex), "f1 comes back to v3"),
        (Defect::face_with_hole(face, vertex), "f1 comes back to v3 round a hole"),
        (Defect::crossing_face(face, vertex), "f1 comes back to v3 and crosses itself"),
        (Defect::repeated_corner(face, vertex), "f1 repeats v3"),
        (Defect::duplicate_face(face, FaceId(0)), "f1 is f0 again"),
        (Defect::opposite_face(face, FaceId(0)), "f1 is f0 the other way round"),
        (
            Defect::differing_face(
                face,
                FaceId(0),
                [Aspect::TexCoord, Aspect::Material].into_iter().collect(),
            ),
            "f1 is f0 again, but for material and texcoord",
        ),
        (Defect::polygon_face(face, 4), "f1 has 4 corners"),
        (Defect::non_finite_face(face, vertex), "f1 uses v3, which is not finite"),
        (Defect::boundary_edge(edge, ends), "e2 v3-v4 has one side"),
        (Defect::non_manifold_edge(edge, ends, 3), "e2 v3-v4 has 3 sides"),
        (Defect::inconsistent_edge(edge, ends), "e2 v3-v4 has both sides running the same way"),
        (Defect::seam_edge(edge, ends), "e2 v3-v4 is cut open"),
        (Defect::coincident_edges(ends), "several edges would join v3-v4"),
        (pinched(true), "v3 joins 2 umbrellas, all open"),
        (pinched(false), "v3 joins 2 umbrellas"),
        (Defect::singular_vertex(vertex), "v3 is on a non-manifold edge"),
        (Defect::non_finite_vertex(vertex), "v3 is not finite"),
        (Defect::unreferenced_vertex(vertex), "v3 is in no face"),
        (Defect::coincident_vertex(vertex, VertexId(0)), "v3 is where v0 is"),
        (Defect::loose_edge(5, ends), "loose edge 5 joins v3-v4"),
        (Defect::loose_point(6, vertex), "loose point 6 at v3"),
        (
            Defect::non_orientable_patch(vec![face; 2], vec![edge; 2]),
            "a strip of 2 faces from f1 comes back reversed",
        ),
        (
            Defect::non_orientable_patch(vec![face], Vec::new()),
            "a strip of 1 face from f1 comes back reversed",
        ),
        (Defect::unjudged_patch(face, 1, Unjudged::Open), "the patch of f1, 1 face in all, is open"),
        (
            Defect::unjudged_patch(face, 2, Unjudged::NoVolume),
            "the patch of f1, 2 faces in all, encloses no volume",
        ),
        (Defect::turned_cavity(face, 12), "the closed patch of f1, 12 faces in all, is inside another"),
    ];
    for (defect, text) in cases {
        assert_eq!(defect.to_string(), text);
    }
}
