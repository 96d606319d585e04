//! Every reason to refuse, where it arises and what it says.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

use meshmend_core::{DefectKind, VertexId};
use meshmend_edit::{Edit, EditRefusal, Editor, HalfKey, Opening, Refused, StaleKey, VertexKey};
use meshmend_testkit::Soup;

fn editor(faces: &[&[u32]]) -> Editor {
    let vertices = faces.iter().copied().flatten().max().map_or(0, |&most| most as usize + 1);
    Editor::new(&Soup::generic(vertices, faces).mesh()).unwrap()
}

fn vertex(editor: &Editor, vertex: u32) -> VertexKey {
    editor.vertex_of(VertexId(vertex)).unwrap()
}

fn half(editor: &Editor, from: u32, to: u32) -> HalfKey {
    editor.half_between(vertex(editor, from), vertex(editor, to)).unwrap().unwrap()
}

fn codes<T: std::fmt::Debug>(refused: Result<T, Refused>) -> Vec<&'static str> {
    refused.unwrap_err().reasons.iter().map(EditRefusal::code).collect()
}

const TETRAHEDRON: [&[u32]; 4] = [&[0, 1, 2], &[0, 2, 3], &[0, 3, 1], &[1, 3, 2]];
const SQUARE: [&[u32]; 2] = [&[0, 1, 2], &[0, 2, 3]];

#[test]
fn a_mesh_that_half_edges_do_not_hold_is_refused_with_every_reason() {
    let bow_tie = Soup::generic(5, [[0, 1, 2], [0, 3, 4]]).mesh();
    let refusal = Editor::new(&bow_tie).unwrap_err();
    assert_eq!(refusal.kernel, "half-edge");
    assert_eq!(refusal.defects[0].kind(), DefectKind::PinchedVertex);
}

#[test]
fn edges_are_split_between_their_ends_and_joined_at_two() {
    let mut square = editor(&SQUARE);
    let edge = square.edge(half(&square, 0, 1)).unwrap();
    for at in [0.0, 1.0, -0.5, 2.0, f64::NAN, f64::INFINITY] {
        assert_eq!(codes(square.split_edge(edge, at)), ["not-between"], "{at}");
    }
    let v0 = vertex(&square, 0);
    assert_eq!(codes(square.join_edges(v0)), ["degree"]);
    let v1 = vertex(&square, 1);
    assert_eq!(codes(square.join_edges(v1)), ["triangle", "already-joined"]);
}

#[test]
fn faces_are_split_at_corners_apart_and_joined_along_all_that_they_share() {
    let mut cap = editor(&[&[0, 1, 2, 3], &[2, 1, 0, 4]]);
    let [h01, h12, h04] = [[0, 1], [1, 2], [0, 4]].map(|[a, b]| half(&cap, a, b));
    assert_eq!(codes(cap.split_face(h01, h12)), ["adjacent"]);
    assert_eq!(codes(cap.split_face(h01, h01)), ["adjacent"]);
    assert_eq!(codes(cap.split_face(h01, h04)), ["two-faces"]);
    let shared = cap.edge(h01).unwrap();
    assert_eq!(codes(cap.join_faces(shared)), ["shares-more"]);

    let mut square = editor(&[&[0, 1, 2, 3]]);
    let [one, other] = [half(&square, 1, 2), half(&square, 3, 0)];
    square.split_face(one, other).unwrap();
    let hole = square.twin(other).unwrap();
    assert_eq!(codes(square.split_face(hole, one)), ["boundary", "two-faces"]);
    let rim = square.edge(other).unwrap();
    assert_eq!(codes(square.join_faces(rim)), ["boundary"]);

    let mut joined = editor(&[&[0, 1, 2, 3], &[1, 0, 2], &[2, 0, 3]]);
    let [one, other] = [half(&joined, 0, 1), half(&joined, 2, 3)];
    assert_eq!(codes(joined.split_face(one, other)), ["already-joined"]);
}

#[test]
fn vertices_go_with_a_fan_of_triangles() {
    let mut square = editor(&SQUARE);
    let v1 = vertex(&square, 1);
    assert_eq!(codes(square.remove_vertex(v1)), ["boundary", "degree"]);
    let mut cube =
        editor(&[&[0, 3, 2, 1], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]);
    let v0 = vertex(&cube, 0);
    assert_eq!(codes(cube.remove_vertex(v0)), ["not-a-triangle"; 3]);
}

#[test]
fn flips_need_two_triangles_whose_tips_are_apart() {
    let mut tetrahedron = editor(&TETRAHEDRON);
    let edge = tetrahedron.edge(half(&tetrahedron, 0, 1)).unwrap();
    assert_eq!(codes(tetrahedron.flip(edge)), ["already-joined", "degree", "degree"]);
    let mut mixed = editor(&[&[0, 1, 2], &[1, 0, 3, 4]]);
    let edge = mixed.edge(half(&mixed, 0, 1)).unwrap();
    assert_eq!(codes(mixed.flip(edge)), ["not-a-triangle"]);
}

#[test]
fn collapses_keep_the_link_condition() {
    let mut tetrahedron = editor(&TETRAHEDRON);
    let side = half(&tetrahedron, 0, 1);
    let refused = tetrahedron.collapse(side, [0.0; 3]).unwrap_err();
    let opposite = tetrahedron.edge(half(&tetrahedron, 2, 3)).unwrap();
    let (vertices, faces) = (Vec::new(), Vec::new());
    assert_eq!(refused.reasons, [EditRefusal::LinkCondition { vertices, edges: vec![opposite], faces }]);

    let mut strip = editor(&[&[0, 1, 2], &[2, 1, 3]]);
    let bridge = half(&strip, 1, 2);
    assert_eq!(codes(strip.collapse(bridge, [0.0; 3])), ["bridge"]);
    let mut triangle = editor(&[&[0, 1, 2]]);
    let side = half(&triangle, 0, 1);
    assert_eq!(codes(triangle.collapse(side, [0.0; 3])), ["would-close"]);
    let mut pillow = editor(&[&[0, 1, 2], &[0, 2, 1]]);
    let side = half(&pillow, 0, 1);
    assert_eq!(codes(pillow.collapse(side, [0.0; 3])), ["link-condition"]);
    // v0 and v1 are also opposite each other in the third face.
    let mut cap = editor(&[&[0, 1, 2], &[1, 0, 3], &[2, 1, 3, 0]]);
    let side = half(&cap, 0, 1);
    let third = cap.face(half(&cap, 2, 1)).unwrap().unwrap();
    let refused = cap.collapse(side, [0.0; 3]).unwrap_err();
    let link = EditRefusal::LinkCondition { vertices: Vec::new(), edges: Vec::new(), faces: vec![third] };
    assert_eq!(refused.reasons, [link]);
}

#[test]
fn vertices_are_split_between_two_places_of_their_own() {
    let mut square = editor(&SQUARE);
    let [one, other] = [half(&square, 0, 1), half(&square, 2, 3)];
    let split = square.split_vertex(Opening::Edge(one), Opening::Edge(other), [0.0; 3]);
    assert_eq!(codes(split), ["not-one-vertex"]);
    let split = square.split_vertex(Opening::Edge(one), Opening::Edge(one), [0.0; 3]);
    assert_eq!(codes(split), ["same-half"]);
    let mut pillow = editor(&[&[0, 1, 2], &[0, 2, 1]]);
    let [one, other] = [half(&pillow, 0, 1), half(&pillow, 0, 2)];
    let split = pillow.split_vertex(Opening::Edge(one), Opening::Edge(other), [0.0; 3]);
    assert_eq!(codes(split), ["link-condition"]);
}

#[test]
fn holes_stay_apart() {
    let mut square = editor(&SQUARE);
    let side = half(&square, 0, 1);
    let face = square.face(side).unwrap().unwrap();
    assert_eq!(codes(square.open_face(face)), ["would-pinch"; 3]);
    assert_eq!(codes(square.close_hole(side)), ["not-a-hole"]);
}

#[test]
fn cuts_go_along_simple_walks_inside() {
    let mut tetrahedron = editor(&TETRAHEDRON);
    let [a, b, c] = [[0, 1], [1, 2], [2, 0]].map(|[from, to]| half(&tetrahedron, from, to));
    for walk in [&[][..], &[a], &[a, b], &[a, c, b], &[a, b, c, a, b, c]] {
        assert_eq!(codes(tetrahedron.cut_loop(walk)), ["not-a-loop"], "{walk:?}");
    }
    let face = tetrahedron.face(half(&tetrahedron, 1, 3)).unwrap().unwrap();
    tetrahedron.open_face(face).unwrap();
    assert_eq!(codes(tetrahedron.cut_loop(&[a, b, c])), ["touches-hole"; 2]);
}

#[test]
fn zips_need_two_holes_that_fit() {
    let mut parts = editor(&[&[0, 1, 2], &[3, 4, 5], &[6, 7, 8, 9]]);
    let side = half(&parts, 0, 1);
    let [one, same, other] = [[1, 0], [0, 2], [7, 6]].map(|[from, to]| half(&parts, from, to));
    assert_eq!(codes(parts.zip_holes(side, one)), ["not-a-hole"]);
    assert_eq!(codes(parts.zip_holes(one, same)), ["same-hole"]);
    assert_eq!(codes(parts.zip_holes(one, other)), ["different-lengths"]);
    // A ring of three faces: its two holes are joined by edges, and lie in the same faces.
    let mut ring = editor(&[&[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]]);
    let [inner, outer] = [half(&ring, 1, 0), half(&ring, 3, 4)];
    let refused = codes(ring.zip_holes(inner, outer));
    assert!(refused.contains(&"vertex-twice") && refused.contains(&"already-joined"), "{refused:?}");
}

#[test]
fn a_stale_key_names_itself_whatever_is_asked() {
    let mut square = editor(&SQUARE);
    let side = half(&square, 2, 0);
    let v1 = vertex(&square, 1);
    let rim = half(&square, 1, 2);
    let (edge, face) = (square.edge(rim).unwrap(), square.face(rim).unwrap().unwrap());
    square.collapse(half(&square, 1, 2), [0.0; 3]).unwrap();
    let fresh = square.halves().next().unwrap();
    let point = [0.0; 3];
    let edits = [
        (Edit::SplitEdge { edge, at: 0.5 }, vec![edge.into()]),
        (Edit::JoinEdges { vertex: v1 }, vec![v1.into()]),
        (Edit::SplitFace { from: rim, to: side }, vec![rim.into(), side.into()]),
        (Edit::JoinFaces { edge }, vec![edge.into()]),
        (Edit::Poke { face, point }, vec![face.into()]),
        (Edit::RemoveVertex { vertex: v1 }, vec![v1.into()]),
        (Edit::Flip { edge }, vec![edge.into()]),
        (Edit::Collapse { half: rim, point }, vec![rim.into()]),
        (Edit::SplitVertex { from: Opening::Edge(fresh), to: Opening::Corner(rim), point }, vec![rim.into()]),
        (Edit::OpenFace { face }, vec![face.into()]),
        (Edit::CloseHole { half: rim }, vec![rim.into()]),
        (Edit::CutLoop { halves: vec![fresh, rim, side] }, vec![rim.into(), side.into()]),
        (Edit::ZipHoles { half: rim, other: fresh }, vec![rim.into()]),
    ];
    for (edit, stale) in edits {
        let refused = square.apply(&edit).unwrap_err();
        let expected: Vec<EditRefusal> = stale.into_iter().map(EditRefusal::Stale).collect();
        assert_eq!(refused.reasons, expected, "{edit:?}");
        assert_eq!(square.can(&edit), Err(refused), "{edit:?}");
    }
    assert_eq!(square.next(rim), Err(StaleKey(rim.into())));
    assert_eq!(square.position(v1), Err(StaleKey(v1.into())));
    assert_eq!(square.set_position(v1, point), Err(StaleKey(v1.into())));
    assert!(square.face_halves(face).is_err() && square.edge_halves(edge).is_err());
    assert!(
        square.vertex_halves(v1).is_err() && square.half_between(square.origin(fresh).unwrap(), v1).is_err()
    );
    // The places are taken again, and the keys stay stale.
    let loops: Vec<HalfKey> = square.halves().filter(|&half| square.face(half).unwrap().is_none()).collect();
    square.close_hole(loops[0]).unwrap();
    let edges: Vec<_> = square.edges().collect();
    edges.into_iter().for_each(|edge| _ = square.split_edge(edge, 0.5).unwrap());
    assert!(square.position(v1).is_err() && square.face_halves(face).is_err() && square.next(rim).is_err());
}

#[test]
fn every_reason_says_what_is_wrong() {
    let square = editor(&SQUARE);
    let (v, h) = (vertex(&square, 0), half(&square, 0, 1));
    let (e, f) = (square.edge(h).unwrap(), square.face(h).unwrap().unwrap());
    let link = EditRefusal::LinkCondition { vertices: vec![v], edges: vec![e], faces: vec![f] };
    let cases = vec![
        (EditRefusal::Stale(f.into()), "face 1v1 is gone"),
        (EditRefusal::Full, "there would be more elements than a mesh can number"),
        (EditRefusal::NotBetween, "the fraction is not between 0 and 1"),
        (
            EditRefusal::Degree { vertex: v, found: 1, needed: "exactly 2" },
            "vertex 1v1 has 1 edge, and exactly 2 are needed",
        ),
        (EditRefusal::Triangle(f), "face 1v1 has 3 sides, and would lose one"),
        (EditRefusal::NotATriangle(f), "face 1v1 is not a triangle"),
        (EditRefusal::AlreadyJoined([v, v]), "vertex 1v1 and vertex 1v1 would be joined twice"),
        (EditRefusal::TwoFaces([h, h]), "half-edge 1v1 and half-edge 1v1 are not of one face"),
        (
            EditRefusal::Adjacent([h, h]),
            "the corners of half-edge 1v1 and half-edge 1v1 are neighbours or the same",
        ),
        (EditRefusal::Boundary(e.into()), "edge 1v1 is on the boundary"),
        (
            EditRefusal::SharesMore { faces: [f, f], vertex: v },
            "face 1v1 and face 1v1 share vertex 1v1 as well",
        ),
        (link, "the link condition fails at vertex 1v1, edge 1v1, face 1v1"),
        (EditRefusal::Bridge(e), "edge 1v1 is inside and joins two vertices of the boundary"),
        (EditRefusal::WouldClose(h), "the hole at half-edge 1v1 has 3 sides, and would close"),
        (EditRefusal::WouldPinch(v), "vertex 1v1 is on a hole, and would be on two"),
        (EditRefusal::NotAHole(h), "half-edge 1v1 is not along a hole"),
        (EditRefusal::NotOneVertex([h, h]), "half-edge 1v1 and half-edge 1v1 leave different vertices"),
        (EditRefusal::SameHalf(h), "both ends of the arc are at half-edge 1v1"),
        (EditRefusal::NotALoop, "the half-edges do not make a closed walk of 3 or more different vertices"),
        (EditRefusal::TouchesHole(v), "the loop meets a hole at vertex 1v1"),
        (EditRefusal::DifferentLengths([1, 4]), "one hole has 1 side, the other has 4"),
        (EditRefusal::SameHole([h, h]), "half-edge 1v1 and half-edge 1v1 are along the same hole"),
        (EditRefusal::VertexTwice(f), "face 1v1 would come back to a vertex"),
    ];
    for (reason, message) in &cases {
        assert_eq!(&reason.to_string(), message, "{}", reason.code());
    }
    let both = Refused { reasons: vec![EditRefusal::NotALoop, EditRefusal::NotBetween] };
    let text = "the half-edges do not make a closed walk of 3 or more different vertices; the fraction is not between 0 and 1";
    assert_eq!(both.to_string(), text);
    assert_eq!(Refused::from(StaleKey(f.into())).reasons, [EditRefusal::Stale(f.into())]);
    assert_eq!(StaleKey(f.into()).to_string(), "face 1v1 is gone");
}
