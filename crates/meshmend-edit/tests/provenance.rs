//! What comes of edits: the record is true, attributes follow, and what was not touched is as it was.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{Blend, CornerId, FaceId, FaceTableBuilder, Id, PolygonMesh, Provenance, VertexId};
use meshmend_edit::{EdgeKey, Editor, HalfKey, Opening};
use meshmend_testkit::Soup;
use meshmend_testkit::edits::{Draw, Editing, Indexed};
use meshmend_testkit::laws::Change;
use meshmend_testkit::shapes::catalogue;
use meshmend_testkit::worlds::damaged_grid;
use proptest::collection::vec;
use proptest::prelude::*;

fn draws() -> impl Strategy<Value = Vec<Draw>> {
    vec((any::<u64>(), any::<[u64; 3]>()).prop_map(|(kind, at)| Draw::new(kind, at)), 0..60)
}

/// The mesh after random operators, none of which moves a vertex.
fn edited(mesh: &PolygonMesh, draws: &[Draw]) -> (PolygonMesh, Provenance) {
    let mut indexed = Indexed::of(mesh);
    for draw in draws {
        if let Some(operator) = draw.operator(&indexed.faces()) {
            let _ = indexed.apply(&operator);
        }
    }
    indexed.editor.finish().unwrap()
}

/// A small surface that an editor takes: a piece of a torus or Klein bottle, or where that is none a whole shape.
fn surface() -> impl Strategy<Value = PolygonMesh> {
    let is_small = |mesh: &PolygonMesh| mesh.counts().faces < 60 && Editor::new(mesh).is_ok();
    let shapes: Vec<PolygonMesh> =
        catalogue().into_iter().map(|shape| shape.soup.numbered()).filter(is_small).collect();
    (damaged_grid(), any::<prop::sample::Index>()).prop_map(move |(soup, at)| {
        let mesh = soup.numbered();
        if is_small(&mesh) && mesh.counts().faces > 0 { mesh } else { shapes[at.index(shapes.len())].clone() }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..Default::default() })]

    #[test]
    fn the_record_is_true_and_attributes_follow(
        before in prop_oneof![surface(), dressed()],
        draws in draws(),
    ) {
        let (after, record) = edited(&before, &draws);
        let change = Change { before: &before, after: &after, record: &record };
        prop_assert_eq!(change.record_law(), Ok(()));
        // The point of a poke lies anywhere; all other vertices lie where the record says.
        let kept_places = record.created.iter().all(|(_, place)| !matches!(place, Some(Blend::Inside { .. })));
        if kept_places {
            prop_assert_eq!(change.place_law(|_, _| false), Ok(()));
        }
        prop_assert_eq!(change.bit_law(), Ok(()));
        prop_assert_eq!(change.attribute_law(), Ok(()));
        prop_assert_eq!(Editor::new(&after).map(|_| ()), Ok(()), "{:?} {:?}", Soup::of_mesh(&before).faces, Soup::of_mesh(&after).faces);
    }

    #[test]
    fn nothing_done_is_the_very_mesh(before in dressed()) {
        let (after, record) = Editor::new(&before).unwrap().finish().unwrap();
        let change = Change { before: &before, after: &after, record: &record };
        prop_assert!(change.is_none());
    }

    #[test]
    fn what_is_split_and_joined_again_is_the_very_mesh(before in surface(), at in any::<prop::sample::Index>()) {
        let mut editor = Editor::new(&before).unwrap();
        let edges: Vec<EdgeKey> = editor.edges().collect();
        let edge = edges[at.index(edges.len())];
        let face = editor.edge_halves(edge).unwrap().into_iter().find_map(|half| editor.face(half).unwrap()).unwrap();
        for undo in [editor.split_edge(edge, 0.5).unwrap().undo, editor.poke(face, [0.0; 3]).unwrap().undo].iter().rev() {
            editor.apply(undo).unwrap();
        }
        let (after, record) = editor.finish().unwrap();
        let change = Change { before: &before, after: &after, record: &record };
        prop_assert!(change.is_none());
    }
}

/// A surface some of whose faces repeat a corner, with degenerate faces and loose elements beside it.
fn dressed() -> impl Strategy<Value = PolygonMesh> {
    (surface(), vec(any::<prop::sample::Index>(), 0..8)).prop_map(|(mesh, places)| {
        let Soup { positions, mut faces } = Soup::of_mesh(&mesh);
        let vertices = positions.len();
        for (kind, place) in places.iter().enumerate() {
            let (face, vertex) = (place.index(faces.len()), place.index(vertices) as u32);
            match (kind % 4, faces[face].first().copied()) {
                (0, Some(first)) => faces[face].insert(0, first),
                (1, Some(first)) => faces[face].push(first),
                (2, _) => faces.insert(face, vec![vertex, 0, vertex]),
                _ => faces.push(Vec::new()),
            }
        }
        let ends = places.iter().map(|place| VertexId::new(place.index(vertices)));
        let (edges, points) = (ends.clone().map(|end| [end, VertexId(0)]).collect(), ends.collect());
        Soup { positions, faces }.numbered().with_loose(edges, points).unwrap()
    })
}

/// Two triangles that make a square with the diagonal from v0 to v2, and numbers on all elements.
fn square() -> PolygonMesh {
    let positions = vec![[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 3.0, 0.0], [0.0, 3.0, 0.0]];
    Soup { positions, faces: vec![vec![0, 1, 2], vec![0, 2, 3]] }.numbered()
}

fn half(editor: &Editor, from: u32, to: u32) -> HalfKey {
    let [from, to] = [from, to].map(|vertex| editor.vertex_of(VertexId(vertex)).unwrap());
    editor.half_between(from, to).unwrap().unwrap()
}

fn faces(mesh: &PolygonMesh) -> Vec<Vec<u32>> {
    Soup::of_mesh(mesh).faces
}

fn corners(record: &Provenance) -> Vec<Option<u32>> {
    record.corners.iter().map(|(_, old)| old.map(|corner| corner.0)).collect()
}

#[test]
fn fractions_of_an_old_side_are_composed_exactly() {
    let mut editor = Editor::new(&square()).unwrap();
    let side = half(&editor, 0, 1);
    let edge = editor.edge(side).unwrap();
    let third = editor.split_edge(edge, 1.0 / 3.0).unwrap();
    let second = editor.split_edge(third.edges[0], 0.5).unwrap();
    assert_eq!(editor.position(second.vertices[0]).unwrap(), [2.0, 0.0, 0.0]);
    let (mesh, record) = editor.finish().unwrap();
    let along =
        |numerator| Some(Blend::Along { from: CornerId(0), to: CornerId(1), numerator, denominator: 3 });
    assert_eq!(record.created, [(VertexId(4), along(1)), (VertexId(5), along(2))]);
    assert_eq!(faces(&mesh), [vec![0, 4, 5, 1, 2], vec![0, 2, 3]]);
    assert_eq!(corners(&record), [Some(0), None, None, Some(1), Some(2), Some(3), Some(4), Some(5)]);
}

#[test]
fn a_fraction_beyond_32_bits_is_within_the_face() {
    let mut editor = Editor::new(&square()).unwrap();
    let mut edge = editor.edge(half(&editor, 0, 1)).unwrap();
    for at in [1.0 / 65_537.0, 1.0 / 65_539.0] {
        edge = editor.split_edge(edge, at).unwrap().edges[0];
    }
    let (_, record) = editor.finish().unwrap();
    assert_eq!(record.created[1].1, Some(Blend::Inside { face: FaceId(0) }));
}

#[test]
fn a_flip_keeps_the_corners_that_stay_in_their_faces() {
    let mut editor = Editor::new(&square()).unwrap();
    let edge = editor.edge(half(&editor, 0, 2)).unwrap();
    editor.flip(edge).unwrap();
    let (mesh, record) = editor.finish().unwrap();
    assert_eq!(faces(&mesh), [[1, 2, 3], [0, 1, 3]]);
    assert_eq!(corners(&record), [Some(1), Some(2), None, Some(3), None, Some(5)]);
    // The corner that a face gets has what the other face had there: here that is not a number, which is cleared.
    assert_eq!(
        record.faces.iter().map(|(_, old)| old).collect::<Vec<_>>(),
        [Some(FaceId(0)), Some(FaceId(1))]
    );
}

#[test]
fn a_corner_that_a_face_gets_has_the_values_of_the_corner_that_it_comes_from() {
    use meshmend_core::{Carry, Domain, Layer, Values};
    let numbers = vec![0.0, 1.0, 2.0, 10.0, 12.0, 13.0];
    let uv = Layer::direct("texcoord", Domain::Corner, 1, Carry::Interpolate, Values::F64(numbers));
    let mesh = square().with_layers(vec![uv]).unwrap();
    let mut editor = Editor::new(&mesh).unwrap();
    let edge = editor.edge(half(&editor, 0, 2)).unwrap();
    editor.flip(edge).unwrap();
    let (after, _) = editor.finish().unwrap();
    let uv = after.layer("texcoord", Domain::Corner).unwrap();
    let values: Vec<Option<f64>> =
        uv.corner_values(after.faces()).map(|value| uv.values().number(value?)).collect();
    assert_eq!(values, [1.0, 2.0, 13.0, 10.0, 1.0, 13.0].map(Some));
}

#[test]
fn faces_that_are_set_aside_and_loose_elements_stay() {
    let mut builder = FaceTableBuilder::default();
    // A face that repeats corners, a degenerate one, a plain one; v5 is in no face.
    for face in [&[0, 0, 1, 2, 2][..], &[1, 3, 1], &[0, 2, 3]] {
        builder.push_face(face.iter().copied().map(VertexId));
    }
    let positions = (0..6).map(|v| [f64::from(v), f64::from(v * v), 0.0]).collect();
    let mesh = PolygonMesh::new(positions, builder.build(6).unwrap()).unwrap();
    let mesh = mesh.with_loose(vec![[VertexId(3), VertexId(4)]], vec![VertexId(5)]).unwrap();
    let (same, record) = Editor::new(&mesh).unwrap().finish().unwrap();
    assert!(same.is_copy_of(&mesh) && record.is_same());

    // v3 goes: the degenerate face and the loose edge keep it.
    let mut editor = Editor::new(&mesh).unwrap();
    assert_eq!((editor.face_count(), editor.face_of(FaceId(1))), (2, None));
    let point = [2.0, 4.0, 0.0];
    editor.collapse(half(&editor, 3, 2), point).unwrap();
    let (after, record) = editor.finish().unwrap();
    assert_eq!(faces(&after), [vec![0, 0, 1, 2, 2], vec![1, 3, 1]]);
    assert_eq!(after.loose_edges(), [[VertexId(3), VertexId(4)]]);
    assert_eq!(after.loose_points(), [VertexId(5)]);
    assert_eq!(after.counts().vertices, 6);
    let change = Change { before: &mesh, after: &after, record: &record };
    assert_eq!((change.record_law(), change.bit_law()), (Ok(()), Ok(())));
}

#[test]
fn the_order_is_that_of_the_mesh_and_then_that_of_the_making() {
    let mut editor = Editor::new(&square()).unwrap();
    let hole = editor.twin(half(&editor, 0, 1)).unwrap();
    let closed = editor.close_hole(hole).unwrap();
    let poked = editor.poke(closed.faces[0], [1.0, 1.0, -1.0]).unwrap();
    // A vertex that is made later in the place of one that is gone still comes last.
    editor.remove_vertex(poked.vertices[0]).unwrap();
    let first = editor.split_edge(editor.edge(half(&editor, 0, 2)).unwrap(), 0.5).unwrap();
    editor.poke(closed.faces[0], [1.0, 1.0, -1.0]).unwrap();
    let (mesh, record) = editor.finish().unwrap();
    assert_eq!(mesh.position(VertexId(4)), [1.5, 1.5, 0.0]);
    assert_eq!(mesh.position(VertexId(5)), [1.0, 1.0, -1.0]);
    assert_eq!(record.created[1], (VertexId(5), None), "it lies in a face that was made");
    assert_eq!(first.faces.len() + mesh.counts().faces, 6);
    let sources: Vec<_> = record.faces.iter().map(|(_, old)| old.map(Id::index)).collect();
    assert_eq!(sources, [Some(0), Some(1), None, None, None, None]);
    assert_eq!(faces(&mesh)[0], [0, 1, 2, 4]);
}

#[test]
fn a_vertex_that_moves_is_kept_and_where_it_was_is_told() {
    let mut editor = Editor::new(&square()).unwrap();
    let done = editor.collapse(half(&editor, 0, 1), [1.5, 0.0, 0.0]).unwrap();
    let v1 = editor.vertex_of(VertexId(1)).unwrap();
    assert_eq!(done.moved, Some((v1, [3.0, 0.0, 0.0])));
    editor.apply(&done.undo).unwrap();
    editor.set_position(v1, [3.0, 0.0, 0.0]).unwrap();
    let (mesh, record) = editor.finish().unwrap();
    // The triangle that had shrunk is made again, after the one that stayed.
    assert_eq!(faces(&mesh), [[2, 3, 1], [1, 0, 2]]);
    assert_eq!(record.removed_faces(), [FaceId(0)]);
}

#[test]
fn both_vertices_of_a_split_come_from_the_one_that_was_split() {
    let mut editor = Editor::new(&square()).unwrap();
    let diagonal = half(&editor, 0, 2);
    let rim = half(&editor, 0, 1);
    let hole = editor.twin(editor.prev(editor.twin(rim).unwrap()).unwrap()).unwrap();
    let _ = hole;
    editor.split_vertex(Opening::Corner(rim), Opening::Edge(diagonal), [0.0; 3]).unwrap();
    let (mesh, record) = editor.finish().unwrap();
    assert_eq!(record.vertices.iter().filter(|(_, old)| *old == Some(VertexId(0))).count(), 2);
    assert!(record.created.is_empty());
    assert_eq!(mesh.counts().faces, 3);
}
