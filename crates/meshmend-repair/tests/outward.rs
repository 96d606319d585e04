//! Which components are turned so that they show their front, what goes, and what is said of it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{Carry, DefectKind, Domain, FaceId, Layer, PolygonMesh, Values};
use meshmend_repair::{Context, Outcome, Outward, Pass, PassKind, Plan, Turn};
use meshmend_testkit::Soup;

/// A tetrahedron with outward faces, or inward ones: a corner, and so far along each axis.
fn tetrahedron(corner: f64, size: f64, looks_outward: bool) -> Soup {
    let mut positions = vec![[corner; 3]; 4];
    (0..3).for_each(|axis| positions[axis + 1][axis] += size);
    let mut faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]].map(Vec::from).to_vec();
    if !looks_outward {
        faces.iter_mut().for_each(|face| face.reverse());
    }
    Soup { positions, faces }
}

/// Shells round one another, the outer one first, each outward or inward.
fn shells(look: &[bool]) -> Soup {
    let sizes = [90.0, 9.0, 0.9, 0.09];
    let shells = look.iter().zip(sizes).map(|(&outward, size)| tetrahedron(-size / 9.0, size, outward));
    Soup::beside(&shells.collect::<Vec<_>>(), 0.0)
}

fn outcome(mesh: &PolygonMesh, turn: Turn) -> Outcome {
    let pass = Outward { turn, ..Outward::default() };
    let outcome = pass.apply(mesh, &Context::default()).unwrap();
    let again = pass.apply(&outcome.mesh, &Context::default()).unwrap();
    assert!(again.provenance.is_same() && again.fixed.is_empty(), "once is enough");
    outcome
}

/// Which of the shells, of four faces each, are turned.
fn turned(outcome: &Outcome) -> Vec<u32> {
    let mut shells: Vec<u32> = outcome.provenance.flipped.iter().map(|face| face.0 / 4).collect();
    shells.dedup();
    shells
}

fn fixed(outcome: &Outcome) -> Vec<(DefectKind, u32)> {
    outcome.fixed.iter().map(|defect| (defect.kind(), defect.at.face().unwrap().0 / 4)).collect()
}

fn left(outcome: &Outcome) -> Vec<(DefectKind, u32)> {
    outcome.left.iter().map(|defect| (defect.kind(), defect.at.face().unwrap().0 / 4)).collect()
}

#[test]
fn solids_enclose_positive_volumes_wherever_they_are() {
    let outcome = outcome(&shells(&[false, false, true, true]).mesh(), Turn::Solids);
    assert_eq!(turned(&outcome), [0, 1]);
    assert_eq!(fixed(&outcome), [(DefectKind::InsideOutComponent, 0)], "the second was the wall of a hollow");
    assert_eq!(left(&outcome), [(DefectKind::SolidWithin, 1), (DefectKind::SolidWithin, 3)]);
}

#[test]
fn nested_shells_alternate() {
    let outcome = outcome(&shells(&[false, true, true, false]).mesh(), Turn::Nested);
    assert_eq!(turned(&outcome), [0, 1]);
    assert_eq!(fixed(&outcome), [(DefectKind::InsideOutComponent, 0), (DefectKind::SolidWithin, 1)]);
    assert_eq!(left(&outcome), []);
}

#[test]
fn what_has_no_volume_stays_and_is_named() {
    let pillow = Soup {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        faces: vec![vec![0, 1, 2], vec![0, 2, 1]],
    };
    let outcome = outcome(&pillow.mesh(), Turn::Visible);
    assert!(outcome.provenance.is_same());
    assert_eq!(left(&outcome), [(DefectKind::NoVolume, 0)]);
}

#[test]
fn an_open_component_is_turned_by_sight() {
    let mut cup = tetrahedron(0.0, 1.0, false);
    cup.faces.pop();
    let seen = outcome(&cup.mesh(), Turn::Visible);
    assert_eq!((turned(&seen), fixed(&seen)), (vec![0], vec![(DefectKind::InsideOutComponent, 0)]));
    assert!(outcome(&cup.mesh(), Turn::Nested).provenance.is_same());
    let lone = Soup { positions: cup.positions[..3].to_vec(), faces: vec![vec![0, 1, 2]] };
    assert_eq!(left(&outcome(&lone.mesh(), Turn::Visible)), [(DefectKind::UndecidedComponent, 0)]);
}

/// Two solids in one place, of which one looks inward, each perhaps with a material.
fn twice(materials: Option<[u32; 2]>) -> PolygonMesh {
    let both = [tetrahedron(0.0, 1.0, true), tetrahedron(0.0, 1.0, false)];
    let mesh = Soup::beside(&both, 0.0).mesh();
    match materials {
        None => mesh,
        Some([one, other]) => {
            let names = Values::Text(vec![b"red".to_vec(), b"blue".to_vec()]);
            let uses = [[one; 4], [other; 4]].concat();
            let layer = Layer::indexed("material", Domain::Face, 1, Carry::Copy, names, uses);
            mesh.with_layers(vec![layer]).unwrap()
        }
    }
}

#[test]
fn a_component_that_repeats_another_once_it_is_turned_goes() {
    for materials in [None, Some([1, 1])] {
        let outcome = outcome(&twice(materials), Turn::Nested);
        assert_eq!(outcome.mesh.counts().faces, 4);
        assert_eq!(outcome.provenance.removed_faces(), [4, 5, 6, 7].map(FaceId));
        let named = outcome.fixed.iter().filter(|defect| defect.kind() == DefectKind::DuplicateFace);
        let named: Vec<u32> = named.map(|defect| defect.beside.unwrap().face().unwrap().0).collect();
        assert_eq!(named, [0, 1, 2, 3]);
    }
    let outcome = outcome(&twice(Some([0, 1])), Turn::Nested);
    assert_eq!((outcome.mesh.counts().faces, turned(&outcome)), (8, vec![1]), "told apart by their material");
}

#[test]
fn the_pass_runs_where_it_is_asked_for_after_faces_are_cut() {
    let plan = Plan::from_toml("[outward]\nturn = 'nested'").unwrap();
    assert_eq!(plan.passes, Plan::default().passes);
    let plan = plan.with(PassKind::Outward);
    let place = plan.passes.iter().position(|&kind| kind == PassKind::Outward).unwrap();
    assert_eq!((plan.passes[place - 1], plan.passes[place + 1]), (PassKind::Triangulate, PassKind::Compact));
    let repaired = plan.pipeline().run(&shells(&[false, true]).mesh()).unwrap();
    assert_eq!(repaired.provenance.flipped.len(), 8);
    let again = plan.pipeline().run(&repaired.mesh).unwrap();
    assert!(again.provenance.is_same());
}
