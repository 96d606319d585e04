//! Winged edges of small meshes: the record of the picture, the boundary, and the step that lecture notes leave out.

use std::sync::Arc;

use meshmend_core::{Build, FaceTable};

use super::*;

fn build(faces: &[[u32; 3]]) -> WingedEdge {
    let corners = faces.iter().flatten().copied().map(VertexId).collect();
    WingedEdge::build(&Complex::of(&Arc::new(FaceTable::triangles(9, corners).unwrap()))).unwrap()
}

fn fields(kernel: &WingedEdge, of: impl Into<Cell>) -> Vec<(&'static str, String)> {
    kernel.pointers(of.into()).iter().map(|pointer| (pointer.field, pointer.to.to_string())).collect()
}

#[test]
fn the_record_is_that_of_the_picture() {
    // Two triangles on either side of v0-v1, which is e0; e1 v0-v2, e2 v0-v3, e3 v1-v2, e4 v1-v3.
    let kernel = build(&[[0, 1, 2], [1, 0, 3]]);
    let expected = [
        ("v0", "v0"),
        ("v1", "v1"),
        ("left face", "f0"),
        ("right face", "f1"),
        ("wing v0 cw", "e2"),
        ("wing v0 ccw", "e1"),
        ("wing v1 cw", "e3"),
        ("wing v1 ccw", "e4"),
        ("left corner", "c0"),
        ("right corner", "c3"),
    ];
    assert_eq!(fields(&kernel, EdgeId(0)), expected.map(|(field, to)| (field, to.to_owned())));
    assert_eq!(fields(&kernel, CornerId(3)), [("right side of", "e0".to_owned())]);
    assert_eq!(fields(&kernel, FaceId(1)), [("right side of", "e0".to_owned())]);
    assert_eq!(fields(&kernel, VertexId(8)), [("first edge", "–".to_owned())]);
    assert!(fields(&kernel, EdgeId(1)).contains(&("left face", "a hole".to_owned())));
}

#[test]
fn wings_go_on_round_the_hole() {
    let kernel = build(&[[0, 1, 2], [1, 0, 3]]);
    let next = |edge, at| kernel.next_boundary_edge(EdgeId(edge), VertexId(at)).map(|e| e.0);
    assert_eq!([next(1, 0), next(2, 0), next(2, 3), next(3, 1)], [Some(2), Some(1), Some(4), Some(4)]);
    assert_eq!([next(0, 0), next(1, 3)], [None, None], "an edge inside, and a vertex elsewhere");
}

/// The walk of the lecture without the test at which end a vertex is: always on over the wing of the same place.
#[test]
fn two_neighbouring_records_that_run_against_each_other_need_the_test() {
    let kernel = build(&[[0, 2, 1]]);
    let first = kernel.corner_side[CornerId(0)];
    let literal = iter::successors(Some(first), |&side| {
        let wing = kernel.record(side).wings[side.other().place()][CLOCKWISE];
        Some(Side::new(wing, side.place()))
    });
    let walked: Vec<u32> = literal.take(3).map(|side| side.edge().0).collect();
    let right: Vec<u32> = kernel.face_corners(FaceId(0)).map(|corner| kernel.corner_edge(corner).0).collect();
    assert_eq!(right, [1, 2, 0]);
    assert_ne!(walked, right);
}
