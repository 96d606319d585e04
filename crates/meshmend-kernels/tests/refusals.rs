//! The meshes by which structures differ, by name: who refuses each of them, and with which reason.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

use std::sync::Arc;

use meshmend_core::DefectKind::{
    InconsistentEdge, NonManifoldEdge, NonSimpleFace, PinchedVertex, PolygonFace, SingularVertex,
};
use meshmend_core::{Complex, Connectivity, DefectKind, FaceTableBuilder, VertexId};
use meshmend_kernels::{KernelKind, KernelTask};

struct Hold;

impl KernelTask for Hold {
    type Output = ();
    fn run<K: Connectivity>(self, _: &K) {}
}

/// A kernel's reasons against a mesh, each kind once; none where it holds the mesh.
fn reasons(kind: KernelKind, faces: &[&[u32]]) -> Vec<DefectKind> {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    let complex = Complex::of(&Arc::new(builder.build(16).unwrap()));
    let Err(refusal) = kind.run(&complex, Hold) else { return Vec::new() };
    assert_eq!(refusal.kernel, kind.name());
    let mut kinds: Vec<DefectKind> = refusal.defects.iter().map(|defect| defect.kind).collect();
    kinds.dedup();
    kinds
}

/// Asserts which kernels refuse a mesh and why; all others hold it.
#[track_caller]
fn assert_refused(faces: &[&[u32]], refused: &[(KernelKind, &[DefectKind])]) {
    for &kind in KernelKind::ALL {
        let expected = refused.iter().find(|(refuses, _)| *refuses == kind).map_or(&[][..], |(_, why)| why);
        assert_eq!(reasons(kind, faces), expected, "{kind}");
    }
}

use KernelKind::{CornerTable, GeneralisedMap, HalfEdge, QuadEdge, RotationSystem, SimpleRecord, WingedEdge};

#[test]
fn a_disc_is_held_by_all() {
    assert_refused(&[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1]], &[]);
}

#[test]
fn a_moebius_band_is_refused_by_what_has_a_direction() {
    let why: &[DefectKind] = &[InconsistentEdge];
    assert_refused(
        &[&[0, 1, 2], &[1, 2, 3], &[2, 3, 4], &[3, 4, 0], &[4, 0, 1]],
        &[(HalfEdge, why), (WingedEdge, why), (CornerTable, why)],
    );
}

/// A torus of 3 × 3 squares, each cut in two, whose last row is joined to the first the other way round.
#[test]
fn a_klein_bottle_is_refused_by_what_has_a_direction() {
    let place = |row: u32, column: u32| {
        let column = if row == 3 { (3 - column % 3) % 3 } else { column % 3 };
        3 * (row % 3) + column
    };
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for row in 0..3 {
        for column in 0..3 {
            let [a, b] = [place(row, column), place(row, column + 1)];
            let [c, d] = [place(row + 1, column), place(row + 1, column + 1)];
            faces.extend([[a, b, d], [a, d, c]]);
        }
    }
    let faces: Vec<&[u32]> = faces.iter().map(|face| &face[..]).collect();
    let why: &[DefectKind] = &[InconsistentEdge];
    assert_refused(&faces, &[(HalfEdge, why), (WingedEdge, why), (CornerTable, why)]);
}

#[test]
fn a_book_is_refused_by_what_has_two_places_for_the_faces_of_an_edge() {
    let why: &[DefectKind] = &[NonManifoldEdge, SingularVertex];
    let refused = [HalfEdge, QuadEdge, WingedEdge, CornerTable, GeneralisedMap, RotationSystem];
    let mut refused = refused.map(|kind| (kind, why)).to_vec();
    refused.push((SimpleRecord, &[NonManifoldEdge]));
    assert_refused(&[&[0, 1, 2], &[1, 0, 3], &[0, 1, 4]], &refused);
}

#[test]
fn a_bow_tie_is_refused_by_what_reaches_a_star_from_one_pointer() {
    let why: &[DefectKind] = &[PinchedVertex];
    let refused = [HalfEdge, QuadEdge, WingedEdge, CornerTable, GeneralisedMap, RotationSystem];
    let refused = refused.map(|kind| (kind, why));
    assert_refused(&[&[0, 1, 2], &[0, 3, 4]], &refused);
    let two_tetrahedra: [&[u32]; 8] =
        [&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3], &[0, 5, 4], &[0, 4, 6], &[4, 5, 6], &[5, 0, 6]];
    assert_refused(&two_tetrahedra, &refused);
}

#[test]
fn a_square_is_refused_by_what_counts_in_threes() {
    let why: &[DefectKind] = &[PolygonFace];
    assert_refused(&[&[0, 1, 2, 3]], &[(CornerTable, why), (SimpleRecord, why)]);
}

#[test]
fn a_face_that_comes_back_to_a_vertex_is_refused_by_what_asks_where_it_is() {
    let (simple, triangles): (&[DefectKind], &[DefectKind]) =
        (&[NonSimpleFace], &[NonSimpleFace, PolygonFace]);
    let refused =
        [(HalfEdge, simple), (WingedEdge, simple), (CornerTable, triangles), (SimpleRecord, triangles)];
    assert_refused(&[&[0, 1, 2, 3, 2]], &refused);
    // The rim of an annulus with a slit, and a face that fills the ring.
    assert_refused(&[&[0, 1, 2, 0, 3, 4, 5, 3], &[3, 5, 4]], &refused);
}

#[test]
fn two_faces_that_disagree_are_refused_by_what_has_a_direction() {
    let why: &[DefectKind] = &[InconsistentEdge];
    assert_refused(&[&[0, 1, 2], &[0, 1, 3]], &[(HalfEdge, why), (WingedEdge, why), (CornerTable, why)]);
}

/// Two triangles with the same corners enclose nothing, and each of their edges has two sides.
#[test]
fn a_pillow_is_held_by_all_if_its_faces_run_opposite_ways() {
    assert_refused(&[&[0, 1, 2], &[2, 1, 0]], &[]);
    let why: &[DefectKind] = &[InconsistentEdge];
    assert_refused(&[&[0, 1, 2], &[0, 1, 2]], &[(HalfEdge, why), (WingedEdge, why), (CornerTable, why)]);
}
