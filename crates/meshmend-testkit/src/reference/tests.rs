//! The port of the reference pipeline on meshes whose repair is known.

use super::*;
use crate::shapes::{catalogue, duplicate_chain, two_boxes_on_an_edge};

/// The faces as sets of cycles, so that rotation and order don't matter.
fn cycles(faces: &[Vec<u32>]) -> Vec<Vec<u32>> {
    let mut cycles: Vec<_> = faces.iter().map(|face| corners::canonical(face)).collect();
    cycles.sort_unstable();
    cycles
}

#[test]
fn every_shape_is_mended_and_a_second_repair_changes_nothing() {
    for shape in catalogue() {
        for split in [Split::Sheets, Split::Cut] {
            let once = repair_soup(&shape.soup, split);
            assert_eq!(broken_postconditions(once.positions.len(), &once.faces), [""; 0], "{}", shape.name);
            let twice = repair(once.positions.clone(), &once.faces, split);
            assert_eq!((twice.faces, twice.positions), (once.faces, once.positions), "{}", shape.name);
        }
    }
}

#[test]
fn touching_boxes_come_apart() {
    let shape = two_boxes_on_an_edge();
    let repaired = repair_soup(&shape.soup, Split::Sheets);
    assert_eq!(repaired.positions.len(), 16);
    assert_eq!(repaired.source_face, (0..12).collect::<Vec<_>>());
    assert!(repaired.flipped.iter().all(|flipped| !flipped));
}

#[test]
fn a_chain_of_duplicates_falls_link_by_link() {
    for n in 0..5 {
        let chain = duplicate_chain(n);
        let repaired = repair_soup(&chain.soup, Split::Sheets);
        let kept: Vec<u32> =
            (0..chain.soup.faces.len() as u32).filter(|f| !chain.dropped.contains(f)).collect();
        assert_eq!(repaired.source_face, kept);
        let flipped = kept.iter().zip(&repaired.flipped).filter(|(_, flipped)| **flipped);
        assert_eq!(flipped.map(|(f, _)| *f).collect::<Vec<_>>(), chain.flipped);
    }
}

#[test]
fn each_link_of_the_chain_waits_for_the_one_before() {
    let chain = duplicate_chain(4);
    let mut pipeline = Pipeline::new(exact_positions(&chain.soup), &chain.soup.faces, Split::Cut);
    pipeline.match_stored();
    pipeline.find_patches();
    let mut rounds = Vec::new();
    let mut before = pipeline.faces.len();
    while pipeline.drop_duplicate_patches() {
        rounds.push(before - pipeline.faces.len());
        before = pipeline.faces.len();
        pipeline.match_stored();
        pipeline.match_welded();
        pipeline.orient();
    }
    assert_eq!(rounds, [1; 5]);
}

#[test]
fn faces_with_a_corner_that_is_not_finite_are_dropped() {
    let mut soup = Soup::generic(4, [[0, 1, 2], [0, 2, 3]]);
    soup.positions[1][2] = f64::NAN;
    let repaired = repair_soup(&soup, Split::Sheets);
    assert_eq!(repaired.source_face, [1]);
    assert_eq!(repaired.source_vertex, [Some(0), Some(2), Some(3)]);
}

#[test]
fn postconditions_name_what_they_find() {
    let broken = broken_postconditions(6, &[vec![0, 1, 2], vec![1, 2, 0], vec![0, 1, 3], vec![0, 4, 0]]);
    let expected = ["face 1 is a duplicate", "face 3 is not simple: [0, 4, 0]", "edge [0, 1] has degree 3"];
    assert!(expected.iter().all(|e| broken.iter().any(|b| b == e)), "{broken:?}");
    assert_eq!(broken.last().map(String::as_str), Some("an unreferenced vertex is left"));
    assert_eq!(cycles(&[vec![2, 0, 1], vec![0, 1, 2]])[0], [0, 1, 2]);
}
