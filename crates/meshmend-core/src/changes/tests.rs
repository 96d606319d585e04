//! Drafts, and the meshes that they make.

use crate::*;

/// A square of two triangles, each corner and vertex with a number of its own.
fn square() -> PolygonMesh {
    let corners = [0, 1, 2, 2, 1, 3].map(VertexId).to_vec();
    let faces = FaceTable::triangles(4, corners).unwrap();
    let layer = |domain, carry, values| Layer::direct("number", domain, 1, carry, values);
    PolygonMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]], faces)
        .unwrap()
        .with_layers(vec![
            layer(Domain::Corner, Carry::Interpolate, Values::F64((0..6).map(f64::from).collect())),
            layer(Domain::Vertex, Carry::Interpolate, Values::F32((0..4u8).map(f32::from).collect())),
            layer(Domain::Face, Carry::Copy, Values::Text(vec![b"a".to_vec(), b"b".to_vec()])),
        ])
        .unwrap()
}

fn value(layer: &Layer, element: usize) -> Option<f64> {
    let at = layer.value_of(element)?;
    if let Values::F64(values) = layer.values() {
        return Some(values[at]);
    }
    let Values::F32(values) = layer.values() else { panic!("no layer of a square is of this type") };
    Some(f64::from(values[at]))
}

#[test]
fn created_corners_and_vertices_get_what_lies_between() {
    let mesh = square();
    let place = Blend::Along { from: CornerId(1), to: CornerId(2), numerator: 1, denominator: 4 };
    let mut builder = FaceTableBuilder::default();
    builder.push_face([0, 1, 4, 2].map(VertexId));
    let corners = [Some(0), Some(1), None, Some(2)].map(|c| c.map(CornerId));
    let draft = Draft {
        vertex_sources: Sources::listed([0, 1, 2, 3].map(|v| Some(VertexId(v))).into_iter().chain([None])),
        created_vertices: vec![VertexDraft { position: [0.75, 0.25, 0.0], place: Some(place) }],
        created_corners: vec![(CornerId(2), place)],
        ..Draft::of_faces(
            &mesh,
            builder.build(5).unwrap(),
            Sources::listed([Some(FaceId(0))]),
            Sources::listed(corners),
        )
    };
    let (new, record) = mesh.rebuild(draft).unwrap();
    assert_eq!(value(&new.layers()[0], 2), Some(1.25));
    assert_eq!(value(&new.layers()[1], 4), Some(1.25));
    assert_eq!(new.layers()[2].element_count(), 1);
    assert_eq!(record.created, [(VertexId(4), Some(place))]);
    assert_eq!(record.removed_faces(), [FaceId(1)]);
}

#[test]
fn a_vertex_inside_a_face_gets_the_mean_of_its_corners() {
    let mesh = square();
    let place = Blend::Inside { face: FaceId(1) };
    let corners = [2, 1, 4, 1, 3, 4, 3, 2, 4].map(VertexId).to_vec();
    let sources = [Some(3), Some(4), None, Some(4), Some(5), None, Some(5), Some(3), None];
    let draft = Draft {
        vertex_sources: Sources::listed((0..4).map(|v| Some(VertexId(v))).chain([None])),
        created_vertices: vec![VertexDraft { position: [0.6, 0.6, 0.0], place: Some(place) }],
        created_corners: [2, 5, 8].map(|c| (CornerId(c), place)).to_vec(),
        ..Draft::of_faces(
            &mesh,
            FaceTable::triangles(5, corners).unwrap(),
            Sources::listed([Some(FaceId(1)); 3]),
            Sources::listed(sources.map(|c| c.map(CornerId))),
        )
    };
    let (new, _) = mesh.rebuild(draft).unwrap();
    let is_about = |found: Option<f64>, mean: f64| found.is_some_and(|x| (x - mean).abs() < 1e-9);
    assert!([2, 5, 8].iter().all(|&c| is_about(value(&new.layers()[0], c), 4.0)));
    assert!(is_about(value(&new.layers()[1], 4), 2.0));
    assert_eq!([0, 1, 2].map(|f| new.layers()[2].value_of(f)), [Some(1); 3]);
}

#[test]
fn a_draft_that_changes_nothing_shares_all_layers() {
    let mesh = square();
    let same = Draft::of_faces(&mesh, mesh.faces().clone(), Sources::same(2), Sources::same(6));
    let (same, record) = mesh.rebuild(same).unwrap();
    assert!(record.is_same());
    assert_eq!(same.layers(), mesh.layers());
    for (new, old) in same.layers().iter().zip(mesh.layers()) {
        assert!(new.is_direct() && std::ptr::eq(new.values(), old.values()), "{:?}", new.domain());
    }
}

#[test]
fn a_vertex_layer_moves_to_the_corners_and_comes_back() {
    let mesh = square();
    let joined = FaceTable::triangles(3, [0, 1, 2, 2, 1, 0].map(VertexId).to_vec()).unwrap();
    let draft = Draft {
        vertex_sources: Sources::listed([0, 1, 2].map(|v| Some(VertexId(v)))),
        merged_into: Some([0, 1, 2, 0].map(VertexId).to_vec()),
        ..Draft::of_faces(&mesh, joined, Sources::same(2), Sources::same(6))
    };
    let (joined, _) = mesh.rebuild(draft).unwrap();
    let layer = &joined.layers()[1];
    assert_eq!((layer.domain(), layer.home()), (Domain::Corner, Domain::Vertex));
    let at_corners: Vec<_> = (0..6).map(|c| value(layer, c)).collect();
    assert_eq!(at_corners, [0.0, 1.0, 2.0, 2.0, 1.0, 3.0].map(Some));
    let parted = FaceTable::triangles(4, [0, 1, 2, 2, 1, 3].map(VertexId).to_vec()).unwrap();
    let draft = Draft {
        vertex_sources: Sources::listed([0, 1, 2, 0].map(|v| Some(VertexId(v)))),
        ..Draft::of_faces(&joined, parted, Sources::same(2), Sources::same(6))
    };
    let (parted, _) = joined.rebuild(draft).unwrap();
    let layer = &parted.layers()[1];
    assert_eq!(layer.domain(), Domain::Vertex);
    assert_eq!((0..4).map(|v| value(layer, v)).collect::<Vec<_>>(), [0.0, 1.0, 2.0, 3.0].map(Some));
}

/// Vertices 0 and 3 of a square joined, a corner created between two that stay.
#[test]
fn a_created_corner_of_a_layer_that_moves_has_its_vertex_value() {
    let mesh = square();
    let place = Blend::Along { from: CornerId(1), to: CornerId(2), numerator: 1, denominator: 2 };
    let mut builder = FaceTableBuilder::default();
    builder.push_face([0, 1, 3, 2].map(VertexId));
    builder.push_face([2, 1, 0].map(VertexId));
    let corners = [Some(0), Some(1), None, Some(2), Some(3), Some(4), Some(5)];
    let draft = Draft {
        vertex_sources: Sources::listed([Some(0), Some(1), Some(2), None].map(|v| v.map(VertexId))),
        created_vertices: vec![VertexDraft { position: [0.5, 0.5, 0.0], place: Some(place) }],
        created_corners: vec![(CornerId(2), place)],
        ..Draft::of_faces(
            &mesh,
            builder.build(4).unwrap(),
            Sources::same(2),
            Sources::listed(corners.map(|c| c.map(CornerId))),
        )
    };
    let (new, _) = mesh.rebuild(draft).unwrap();
    let layer = &new.layers()[1];
    assert_eq!(layer.domain(), Domain::Corner);
    let at_corners: Vec<_> = (0..7).map(|c| value(layer, c)).collect();
    assert_eq!(at_corners, [0.0, 1.0, 1.5, 2.0, 2.0, 1.0, 3.0].map(Some));
}

/// The square, skinned: a vertex created between two has the joints of both.
#[test]
fn a_created_vertex_is_moved_by_the_joints_of_all_that_it_lies_between() {
    let joints = Values::U8([[1, 2, 0, 0], [1, 2, 0, 0], [3, 2, 0, 0], [1, 0, 0, 0]].concat());
    let weights = Values::F32(
        [[0.5, 0.5, 0.0, 0.0], [0.75, 0.25, 0.0, 0.0], [0.5, 0.5, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]].concat(),
    );
    let layer = |name: &str, role, values| {
        Layer::direct(name, Domain::Vertex, 4, Carry::Copy, values).with_role(role)
    };
    let skin = vec![layer("joints", Role::Joints(0), joints), layer("weights", Role::Weights(0), weights)];
    let mesh = square().with_layers(skin).unwrap();
    let place = Blend::Along { from: CornerId(1), to: CornerId(2), numerator: 1, denominator: 2 };
    let mut builder = FaceTableBuilder::default();
    builder.push_face([0, 1, 4, 2].map(VertexId));
    builder.push_face([2, 4, 1, 3].map(VertexId));
    let corners = [Some(0), Some(1), None, Some(2), Some(3), None, Some(4), Some(5)];
    let draft = Draft {
        vertex_sources: Sources::listed([Some(0), Some(1), Some(2), Some(3), None].map(|v| v.map(VertexId))),
        created_vertices: vec![VertexDraft { position: [0.5, 0.5, 0.0], place: Some(place) }],
        created_corners: vec![(CornerId(2), place), (CornerId(5), place)],
        ..Draft::of_faces(
            &mesh,
            builder.build(5).unwrap(),
            Sources::same(2),
            Sources::listed(corners.map(|c| c.map(CornerId))),
        )
    };
    let (new, _) = mesh.rebuild(draft).unwrap();
    let row = |layer: &Layer, vertex: usize| -> Vec<f64> {
        let value = layer.value_of(vertex).unwrap();
        (value * 4..value * 4 + 4).filter_map(|place| layer.values().number(place)).collect()
    };
    let [joints, weights] = [&new.layers()[0], &new.layers()[1]];
    assert_eq!((joints.domain(), weights.domain()), (Domain::Vertex, Domain::Vertex));
    assert_eq!((row(joints, 4), row(weights, 4)), (vec![1.0, 2.0, 3.0, 0.0], vec![0.375, 0.375, 0.25, 0.0]));
    assert_eq!((row(joints, 1), row(weights, 1)), (vec![1.0, 2.0, 0.0, 0.0], vec![0.75, 0.25, 0.0, 0.0]));
}

#[test]
fn a_vertex_layer_stays_at_the_corners_while_some_of_a_vertex_differ() {
    let mesh = square();
    let joined = FaceTable::triangles(3, [0, 1, 2, 2, 1, 0].map(VertexId).to_vec()).unwrap();
    let draft = Draft {
        vertex_sources: Sources::same(3),
        merged_into: Some([0, 1, 2, 0].map(VertexId).to_vec()),
        ..Draft::of_faces(&mesh, joined, Sources::same(2), Sources::same(6))
    };
    let (joined, _) = mesh.rebuild(draft).unwrap();
    let again = Draft::of_faces(&joined, joined.faces().clone(), Sources::same(2), Sources::same(6));
    let (again, _) = joined.rebuild(again).unwrap();
    assert_eq!(again.layers()[1], joined.layers()[1]);
    assert_eq!(again.layers()[1].domain(), Domain::Corner);
}

#[test]
fn a_draft_that_does_not_fit_is_an_error() {
    let mesh = square();
    let draft = |faces, corners| {
        Draft::of_faces(&mesh, mesh.faces().clone(), Sources::same(faces), Sources::same(corners))
    };
    let wrong = mesh.rebuild(draft(3, 6)).unwrap_err();
    assert_eq!(wrong, DraftError::Count { what: "face source", found: 3, expected: 2 });
    assert!(mesh.rebuild(draft(2, 5)).is_err());
    let loose = square().with_loose(Vec::new(), vec![VertexId(3)]).unwrap();
    let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
    let draft = Draft {
        vertex_sources: Sources::same(3),
        ..Draft::of_faces(&loose, faces, Sources::same(1), Sources::same(3))
    };
    assert_eq!(loose.rebuild(draft).unwrap_err(), DraftError::LooseVertex(VertexId(3)));
}

#[test]
fn layers_of_loose_elements_stay_with_them_or_go_with_them() {
    let layer = |domain, count| {
        Layer::direct("object", domain, 1, Carry::Copy, Values::Text(vec![b"a".to_vec(); count]))
    };
    let layers = vec![layer(Domain::LooseEdge, 2), layer(Domain::LoosePoint, 1)];
    let edges = vec![[VertexId(0), VertexId(1)], [VertexId(1), VertexId(2)]];
    let mesh = square().with_loose(edges, vec![VertexId(3)]).unwrap().with_layers(layers).unwrap();
    let rebuilt = |drop_loose| {
        let (faces, corners) = (Sources::same(2), Sources::same(6));
        let draft = Draft { drop_loose, ..Draft::of_faces(&mesh, mesh.faces().clone(), faces, corners) };
        let layers = mesh.rebuild(draft).unwrap().0.layers().to_vec();
        [layers[0].element_count(), layers[1].element_count()]
    };
    assert_eq!(rebuilt(Loose::default()), [2, 1]);
    assert_eq!(rebuilt(Loose { edges: true, points: false }), [0, 1]);
    assert_eq!(rebuilt(Loose { edges: false, points: true }), [2, 0]);
}

#[test]
fn created_values_that_are_the_same_are_one_value() {
    // Three triangles round a new vertex inside the first face; its middle is a value that is there already.
    let corner = |values: Vec<f64>| {
        Layer::direct("texcoord", Domain::Corner, 1, Carry::Interpolate, Values::F64(values))
    };
    let centred = |values: Vec<f64>| {
        let faces = FaceTable::triangles(3, [0, 1, 2].map(VertexId).to_vec()).unwrap();
        let mesh = PolygonMesh::new(square().positions()[..3].to_vec(), faces).unwrap();
        let mesh = mesh.with_layers(vec![corner(values)]).unwrap();
        let faces = FaceTable::triangles(4, [0, 1, 3, 1, 2, 3, 2, 0, 3].map(VertexId).to_vec()).unwrap();
        let place = Blend::Inside { face: FaceId(0) };
        let c = |corner| Some(CornerId(corner));
        let corners = [c(0), c(1), None, c(1), c(2), None, c(2), c(0), None];
        let draft = Draft {
            vertex_sources: Sources::listed([0, 1, 2].map(|v| Some(VertexId(v))).into_iter().chain([None])),
            created_vertices: vec![VertexDraft { position: [0.1; 3], place: Some(place) }],
            created_corners: [2, 5, 8].map(|corner| (CornerId(corner), place)).to_vec(),
            ..Draft::of_faces(&mesh, faces, Sources::listed([Some(FaceId(0)); 3]), Sources::listed(corners))
        };
        let layer = mesh.rebuild(draft).unwrap().0.layers()[0].clone();
        (layer.values().len(), [2, 5, 8].map(|corner| layer.value_of(corner)))
    };
    assert_eq!(centred(vec![0.0, 3.0, 9.0]), (4, [Some(3); 3]));
    assert_eq!(centred(vec![0.0, 1.0, 0.5]), (3, [Some(2); 3]));
}
