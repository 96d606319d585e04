//! Rotation systems of small meshes, and the law of rotations and signs on random ones: what they trace is the surface.

use std::sync::Arc;

use meshmend_core::{Build, FaceTableBuilder};
use meshmend_testkit::oracle;
use meshmend_testkit::worlds::{damaged_grid, self_touching};
use proptest::prelude::*;

use super::*;

fn build(faces: &[&[u32]]) -> RotationSystem {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    RotationSystem::build(&Complex::of(&Arc::new(builder.build(9).unwrap()))).unwrap()
}

fn rotation(system: &RotationSystem, vertex: u32) -> Vec<String> {
    let fields = system.pointers(Cell::Vertex(VertexId(vertex)));
    fields.iter().map(|field| field.to.to_string()).collect()
}

fn twisted(system: &RotationSystem) -> usize {
    system.signs.values().iter().filter(|&&sign| sign == Sign::Minus).count()
}

#[test]
fn a_tetrahedron_has_four_rotations_of_three_and_traces_four_faces() {
    // e0 v0-v1, e1 v0-v2, e2 v0-v3, e3 v1-v2, e4 v1-v3, e5 v2-v3.
    let system = build(&[&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]]);
    assert_eq!(rotation(&system, 0), ["e1", "e0", "e2"]);
    assert_eq!(rotation(&system, 3), ["e2", "e4", "e5"]);
    assert_eq!((twisted(&system), system.traced_faces()), (0, 4));
}

#[test]
fn a_fan_has_its_gap_last_and_the_hole_is_traced_too() {
    let system = build(&[&[0, 1, 2], &[0, 2, 3]]);
    assert_eq!(rotation(&system, 0), ["e0", "e1", "e2"]);
    assert_eq!(system.corner_after[Dart(2)], NO_CORNER);
    assert_eq!(system.traced_faces(), 3);
    let next = |edge| system.next_boundary_edge(EdgeId(edge), VertexId(0)).map(|edge| edge.0);
    assert_eq!([next(0), next(2), next(1)], [Some(2), Some(0), None]);
    assert_eq!(system.next_boundary_edge(EdgeId(0), VertexId(8)), None, "a vertex in no face");
}

#[test]
fn a_moebius_band_has_a_sign_that_no_choice_of_turns_removes() {
    let system = build(&[&[0, 1, 2], &[1, 2, 3], &[2, 3, 4], &[3, 4, 0], &[4, 0, 1]]);
    assert_eq!(twisted(&system) % 2, 1);
    assert_eq!(system.traced_faces(), 6, "five faces and one hole: V − E + F = 5 − 10 + 6 = 1");
}

#[test]
fn a_spike_and_a_face_glued_to_itself_are_traced() {
    let spike = build(&[&[0, 1, 2, 3, 2]]);
    assert!(spike.vertex_corners(VertexId(2)).eq([4, 2].map(CornerId)));
    assert_eq!((spike.traced_faces(), spike.across(CornerId(2))), (2, Some(CornerId(3))));
    let band = build(&[&[0, 1, 2, 0, 1, 3]]);
    assert_eq!((band.traced_faces(), band.across(CornerId(0))), (2, Some(CornerId(3))));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: if cfg!(miri) { 4 } else { 500 }, ..Default::default() })]

    #[test]
    fn rotations_and_signs_trace_the_faces_and_the_holes(
        soup in prop_oneof![damaged_grid(), self_touching()],
    ) {
        if let Ok(system) = RotationSystem::build(&soup.complex()) {
            let found = oracle::report(&soup);
            let holes = found.boundary_loops.expect("a surface has loops");
            prop_assert_eq!(system.traced_faces() as u64, found.faces as u64 + holes as u64);
            assert_involutions(&system);
        }
    }
}

/// The three steps on flags are those of a generalised map.
fn assert_involutions(system: &RotationSystem) {
    for dart in (0..system.rotation.len()).map(Dart::new) {
        for flag in [Hand::Left, Hand::Right].map(|hand| (dart, hand)) {
            assert_eq!(system.cross(system.cross(flag)), flag);
            assert_eq!(system.beyond(system.beyond(flag)), flag);
            let turned = |(dart, hand): Flag| system.cross((dart, hand.other()));
            assert_eq!(turned(turned(flag)), flag);
        }
    }
}
