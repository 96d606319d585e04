//! Each law finds the record that breaks it.

use meshmend_core::{Draft, FaceTableBuilder, Sources};

use super::*;
use crate::Soup;

/// Two triangles over four vertices, and a fifth vertex in no face.
fn square() -> PolygonMesh {
    Soup::generic(5, [[0, 1, 2], [2, 1, 3]]).numbered()
}

/// The square with other faces, as a draft says.
fn changed(
    faces: &[&[u32]],
    sources: [&[u32]; 2],
    change: impl FnOnce(&mut Draft),
) -> (PolygonMesh, Provenance) {
    let mesh = square();
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    let [of_faces, of_corners] = sources;
    let mut draft = Draft::of_faces(
        &mesh,
        builder.build(5).unwrap(),
        Sources::listed(of_faces.iter().map(|&f| Some(FaceId(f)))),
        Sources::listed(of_corners.iter().map(|&c| Some(CornerId(c)))),
    );
    change(&mut draft);
    mesh.rebuild(draft).unwrap()
}

fn all_laws(
    before: &PolygonMesh,
    (after, record): &(PolygonMesh, Provenance),
    fixed: &[Defect],
) -> Result<(), String> {
    let change = Change { before, after, record };
    change.record_law()?;
    change.place_law(|_, _| false)?;
    change.bit_law()?;
    change.attribute_law()?;
    change.naming_law(fixed)
}

#[track_caller]
fn finds(result: Result<(), String>, what: &str) {
    let law = result.unwrap_err();
    assert!(law.contains(what), "{law}");
}

#[test]
fn a_true_record_keeps_all_laws() {
    let same = changed(&[&[0, 1, 2], &[2, 1, 3]], [&[0, 1], &[0, 1, 2, 3, 4, 5]], |_| {});
    assert_eq!(all_laws(&square(), &same, &[]), Ok(()));
    let flipped = changed(&[&[0, 1, 2], &[2, 3, 1]], [&[0, 1], &[0, 1, 2, 3, 5, 4]], |draft| {
        draft.flipped = vec![FaceId(1)];
    });
    assert_eq!(all_laws(&square(), &flipped, &[]), Ok(()));
    let removed = changed(&[&[2, 1, 3]], [&[1], &[3, 4, 5]], |_| {});
    let fixed = [Defect::duplicate_face(FaceId(0), FaceId(1))];
    assert_eq!(all_laws(&square(), &removed, &fixed), Ok(()));
}

#[test]
fn a_flip_that_is_none_and_one_that_is_not_recorded_are_found() {
    let silent = changed(&[&[0, 1, 2], &[2, 3, 1]], [&[0, 1], &[0, 1, 2, 3, 5, 4]], |_| {});
    finds(all_laws(&square(), &silent, &[]), "does not run");
    let claimed = changed(&[&[0, 1, 2], &[2, 1, 3]], [&[0, 1], &[0, 1, 2, 3, 4, 5]], |draft| {
        draft.flipped = vec![FaceId(1)];
    });
    finds(all_laws(&square(), &claimed, &[]), "does not run");
}

#[test]
fn a_corner_of_another_face_or_another_vertex_is_found() {
    let swapped = changed(&[&[0, 1, 2], &[2, 1, 3]], [&[1, 0], &[0, 1, 2, 3, 4, 5]], |_| {});
    finds(all_laws(&square(), &swapped, &[]), "not of f1");
    let moved = changed(&[&[0, 1, 4], &[2, 1, 3]], [&[0, 1], &[0, 1, 2, 3, 4, 5]], |_| {});
    finds(all_laws(&square(), &moved, &[]), "c2 went from v2 to v4");
    let (after, record) = moved;
    let before = square();
    let change = Change { before: &before, after: &after, record: &record };
    assert_eq!(change.place_law(|from, to| (from, to) == (VertexId(2), VertexId(4))), Ok(()));
}

#[test]
fn what_goes_without_a_word_is_found() {
    let removed = changed(&[&[2, 1, 3]], [&[1], &[3, 4, 5]], |_| {});
    finds(all_laws(&square(), &removed, &[]), "removed faces");
    let polygon = [Defect::polygon_face(FaceId(0), 4)];
    finds(all_laws(&square(), &removed, &polygon), "removed faces");
    let cut = changed(&[&[0, 1], &[2, 1, 3]], [&[0, 1], &[0, 1, 3, 4, 5]], |_| {});
    finds(all_laws(&square(), &cut, &[]), "not all of f0");
    let there = [Defect::degenerate_face(FaceId(1))];
    let same = changed(&[&[0, 1, 2], &[2, 1, 3]], [&[0, 1], &[0, 1, 2, 3, 4, 5]], |_| {});
    finds(all_laws(&square(), &same, &there), "is there");
    let unnamed = [Defect::unreferenced_vertex(VertexId(4))];
    finds(all_laws(&square(), &same, &unnamed), "being gone of v4");
}

#[test]
fn a_vertex_that_is_there_twice_needs_a_reason() {
    let parted = |draft: &mut Draft| {
        let sources = [0, 1, 2, 3, 4, 1].map(|v| Some(VertexId(v)));
        draft.vertex_sources = Sources::listed(sources);
    };
    let mesh = square();
    let mut builder = FaceTableBuilder::default();
    [[0, 1, 2], [2, 5, 3]].iter().for_each(|face| builder.push_face(face.map(VertexId)));
    let mut draft = Draft::of_faces(&mesh, builder.build(6).unwrap(), Sources::same(2), Sources::same(6));
    parted(&mut draft);
    let split = mesh.rebuild(draft).unwrap();
    finds(all_laws(&mesh, &split, &[]), "v1 is there 2 times");
    let pinched = Defect::pinched_vertex(VertexId(1), 2, true);
    assert_eq!(all_laws(&mesh, &split, &[pinched]), Ok(()));
}

#[test]
fn a_value_that_stays_behind_is_found() {
    let (after, record) = changed(&[&[2, 1, 3]], [&[1], &[3, 4, 5]], |_| {});
    let before = square();
    let names: Vec<Layer> = after
        .layers()
        .iter()
        .map(|layer| {
            let first = Layer::direct(layer.name(), layer.domain(), 1, layer.carry(), layer.values().clone());
            if layer.domain() == Domain::Vertex { first } else { layer.clone() }
        })
        .collect();
    let same_values = after.clone().with_layers(names).unwrap();
    let law = |after: &PolygonMesh| Change { before: &before, after, record: &record }.attribute_law();
    assert_eq!(law(&same_values), Ok(()));
    let wrong: Vec<Layer> = after
        .layers()
        .iter()
        .map(|layer| {
            let uses = vec![0; layer.element_count()];
            Layer::indexed(layer.name(), layer.domain(), 1, layer.carry(), layer.values().clone(), uses)
        })
        .collect();
    finds(law(&after.with_layers(wrong).unwrap()), "vertex number of c0");
}

#[test]
fn only_the_value_itself_is_no_change() {
    let before = square();
    let record = Provenance::same(before.counts());
    let is_none = |after: &PolygonMesh| Change { before: &before, after, record: &record }.is_none();
    assert!(is_none(&before.clone()));
    assert!(!is_none(&square()), "a copy is another value");
}

#[test]
fn a_vertex_that_moved_is_found_to_the_bit() {
    let before = square();
    let moved = |x: f64| {
        let mut positions = before.positions().to_vec();
        positions[0][0] = x;
        before.clone().with_positions(positions).unwrap()
    };
    let record = Provenance::same(before.counts());
    let (far, near) = (moved(1.0), moved(-0.0));
    let law = |after| Change { before: &before, after, record: &record };
    finds(law(&far).place_law(|_, _| false), "v0 is not where v0 was");
    assert_eq!(law(&near).place_law(|_, _| false), Ok(()));
    finds(law(&near).bit_law(), "the point of v0");
}
