//! Quad-edges of small meshes, and the axioms of the algebra on random ones.

use std::sync::Arc;

use meshmend_core::{Build, FaceTableBuilder, Refusal};
use meshmend_testkit::worlds::{damaged_grid, self_touching};
use proptest::prelude::*;

use super::algebra::assert_axioms;
use super::*;

fn build(vertices: usize, faces: &[&[u32]]) -> Result<QuadEdge, Refusal> {
    let mut builder = FaceTableBuilder::default();
    faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
    QuadEdge::build(&Complex::of(&Arc::new(builder.build(vertices).unwrap())))
}

fn star(kernel: &QuadEdge, vertex: u32) -> Vec<u32> {
    kernel.vertex_corners(VertexId(vertex)).map(|c| c.0).collect()
}

/// Five triangles on five vertices.
const MOEBIUS: [&[u32]; 5] = [&[0, 1, 2], &[1, 2, 3], &[2, 3, 4], &[3, 4, 0], &[4, 0, 1]];

#[test]
fn a_moebius_band_has_one_hole_with_five_sides() {
    let kernel = build(5, &MOEBIUS).unwrap();
    assert_axioms(&kernel.edges);
    assert_eq!(kernel.hole_count(), 1);
    let rim = kernel.corners().filter(|&c| kernel.hole_beside(c) == Some(0)).count();
    let walked = kernel.boundary_loop(CornerId(2)).count();
    assert_eq!((rim, walked), (5, 5));
    assert_eq!(kernel.boundary_loop(CornerId(0)).count(), 0);
}

#[test]
fn faces_that_run_against_each_other_are_walked_round_alike() {
    let disc = build(4, &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 1]]).unwrap();
    let mixed = build(4, &[&[0, 1, 2], &[0, 3, 2], &[0, 3, 1]]).unwrap();
    assert_eq!(star(&disc, 0), [0, 3, 6]);
    assert_eq!(star(&mixed, 0), [0, 3, 6]);
    // At v2, counter-clockwise as f0 runs: f1 lies on the other side of v2-v0, and the boundary is before it.
    assert_eq!((star(&disc, 2), star(&mixed, 2)), (vec![4, 2], vec![5, 2]));
    assert_eq!((disc.hole_count(), mixed.hole_count()), (1, 1));
    assert_axioms(&mixed.edges);
}

#[test]
fn a_face_may_be_glued_to_itself() {
    // A spike: the only edge at v3 is used twice by the only face there.
    let spike = build(4, &[&[0, 1, 2, 3, 2]]).unwrap();
    assert_axioms(&spike.edges);
    assert_eq!(spike.opposite(CornerId(2)), Some(CornerId(3)));
    assert_eq!((star(&spike, 3), star(&spike, 2)), (vec![3], vec![4, 2]));
    // A Moebius band of one face, which runs along v0-v1 twice the same way.
    let band = build(4, &[&[0, 1, 2, 0, 1, 3]]).unwrap();
    assert_axioms(&band.edges);
    assert_eq!(band.opposite(CornerId(0)), Some(CornerId(3)));
    assert_eq!(band.hole_count(), 1);
}

#[test]
fn holes_are_numbered_by_lowest_edge() {
    let annulus = build(6, &[&[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]]).unwrap();
    assert_eq!(annulus.hole_count(), 2);
    assert_eq!(annulus.hole_beside(CornerId(0)), Some(0));
    assert_eq!(annulus.hole_beside(CornerId(2)), Some(1));
    assert_eq!(annulus.hole_beside(CornerId(1)), None);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: if cfg!(miri) { 4 } else { 500 }, ..Default::default() })]

    #[test]
    fn the_axioms_hold_on_whatever_is_admitted(soup in prop_oneof![damaged_grid(), self_touching()]) {
        if let Ok(kernel) = QuadEdge::build(&soup.complex()) {
            assert_axioms(&kernel.edges);
            assert_rings_are_about_one_vertex_or_face(&kernel);
            assert_loops_partition_the_boundary(&kernel);
        }
    }
}

fn assert_rings_are_about_one_vertex_or_face(kernel: &QuadEdge) {
    let origin = |dart: Dart| kernel.labels(dart).ends[dart.quarter() / 2];
    let face = |dart: Dart| kernel.labels(dart).faces[left(dart)];
    for dart in kernel.edges.darts().filter(|dart| dart.quarter() % 2 == 0) {
        assert_eq!(origin(kernel.edges.onext(dart)), origin(dart));
        assert_eq!(origin(kernel.edges.lnext(dart)), origin(dart.sym()));
        assert_eq!(face(kernel.edges.lnext(dart)), face(dart));
    }
}

/// Each boundary side is on one loop, with those that have the same hole beside them.
fn assert_loops_partition_the_boundary(kernel: &QuadEdge) {
    let mut sizes = vec![0; kernel.hole_count()];
    let boundary: Vec<_> = kernel.corners().filter(|&c| kernel.opposite(c).is_none()).collect();
    for &corner in &boundary {
        sizes[kernel.hole_beside(corner).unwrap()] += 1;
    }
    for &corner in &boundary {
        let hole = kernel.hole_beside(corner);
        let walked: Vec<_> = kernel.boundary_loop(corner).collect();
        assert_eq!((walked[0], walked.len()), (corner, sizes[hole.unwrap()]));
        assert!(walked.iter().all(|&side| kernel.hole_beside(side) == hole));
    }
}
