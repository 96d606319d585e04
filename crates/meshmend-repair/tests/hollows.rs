//! Which closed shells are turned inward as the walls of hollows: those inside an odd number of others.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::FaceId;
use meshmend_repair::{Context, Duplicates, Orient, Pass, PassKind, Plan, Side};
use meshmend_testkit::Soup;

/// A tetrahedron with outward faces: a corner, and so far along each axis.
fn tetrahedron(corner: [f64; 3], size: f64) -> Soup {
    let mut positions = vec![corner; 4];
    (0..3).for_each(|axis| positions[axis + 1][axis] += size);
    Soup { positions, faces: [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(Vec::from).to_vec() }
}

/// The faces that are turned where nested shells alternate.
fn turned(soup: &Soup) -> Vec<u32> {
    let mut plan = Plan { passes: vec![PassKind::Weld, PassKind::Orient], ..Plan::default() };
    plan.orient.side = Side::OutwardNested;
    let repaired = plan.pipeline().run(&soup.mesh()).unwrap();
    repaired.provenance.flipped.iter().map(|face| face.0).collect()
}

#[test]
fn shells_alternate_wherever_they_are() {
    for far in [0.0, 100.0, -1000.0] {
        let shells = [90.0, 9.0, 0.9].map(|size| tetrahedron([far - size / 9.0; 3], size));
        assert_eq!(turned(&Soup::beside(&shells, 0.0)), [4, 5, 6, 7], "at {far}");
    }
}

#[test]
fn a_shell_beside_another_is_no_hollow_though_the_box_round_that_one_holds_it() {
    let beside = [tetrahedron([0.0; 3], 10.0), tetrahedron([8.0; 3], 1.0)];
    assert_eq!(turned(&Soup::beside(&beside, 0.0)), [0; 0]);
}

/// A tetrahedron, and one on the middle of each of its sides: outside of it, then inside.
#[test]
fn a_shell_that_touches_another_is_a_hollow_if_it_lies_inside() {
    for (deep, expected) in [(-1.0, vec![]), (1.0, vec![4, 5, 6, 7])] {
        for axis in 0..3 {
            for turn in 0..4 {
                let mut small = tetrahedron([1.0; 3], 2.0);
                small.positions.iter_mut().for_each(|p| p[axis] = (p[axis] - 1.0) * deep);
                if deep < 0.0 {
                    small.faces.iter_mut().for_each(|face| face.reverse());
                }
                small.faces.rotate_left(turn);
                let soup = Soup::beside(&[tetrahedron([0.0; 3], 12.0), small], 0.0);
                assert_eq!(turned(&soup), expected, "{deep} {axis} {turn}");
            }
        }
    }
}

/// The double has a face that runs the other way, so that it is found only when both are oriented.
#[test]
fn a_shell_that_was_dropped_as_a_double_holds_nothing() {
    let outer = tetrahedron([0.0; 3], 10.0);
    let mut double = outer.clone();
    double.faces[2].reverse();
    let inner = tetrahedron([1.0; 3], 1.0);
    let mut plan = Plan { passes: vec![PassKind::Weld, PassKind::Orient], ..Plan::default() };
    plan.orient.side = Side::OutwardNested;
    let repaired = plan.pipeline().run(&Soup::beside(&[outer, double, inner], 0.0).mesh()).unwrap();
    let removed: Vec<u32> = repaired.removed_faces.iter().map(|removed| removed.face.0).collect();
    assert_eq!(removed, [4, 5, 6, 7]);
    let faces = |of: &[FaceId]| of.iter().map(|face| face.0).collect::<Vec<_>>();
    assert_eq!(faces(&repaired.provenance.flipped), [4, 5, 6, 7], "by the faces of the result");
}

/// Sides are chosen once more when the wall has gone.
#[test]
fn what_was_turned_outward_stays_so_when_walls_go() {
    let mut soup =
        Soup::beside(&[tetrahedron([0.0; 3], 1.0), Soup::generic(3, [[0, 1, 2], [0, 2, 1]])], 50.0);
    soup.faces[..4].iter_mut().for_each(|face| face.reverse());
    let orient = Orient { side: Side::Outward, duplicates: Duplicates::RemovePair, ..Orient::default() };
    let outcome = orient.apply(&soup.mesh(), &Context::default()).unwrap();
    assert_eq!(outcome.provenance.flipped, [0, 1, 2, 3].map(FaceId));
    assert_eq!(outcome.mesh.counts().faces, 4);
}

/// Two faces back to back: they have no outer side, so that they would be turned in every run.
#[test]
fn a_shell_without_a_volume_stays_as_it_is_inside_another() {
    let mut inside = tetrahedron([1.0; 3], 1.0);
    inside.faces = [[0, 1, 2], [0, 2, 1]].map(Vec::from).to_vec();
    assert_eq!(turned(&Soup::beside(&[tetrahedron([0.0; 3], 10.0), inside], 0.0)), [0; 0]);
}
