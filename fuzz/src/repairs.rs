//! Repairs: the default pipeline keeps its promises to the letter, and any other keeps those that it makes.

use std::collections::BTreeMap;

use arbitrary::{Arbitrary, Unstructured};
use meshmend_core::{Layer, PolygonMesh};
use meshmend_kernels::KernelKind;
use meshmend_repair::{
    AnyPass, Context, Emptying, PassError, PassKind, Pipeline, Plan, Repaired, Session, SplitEdges,
};
use meshmend_testkit::laws::{Change, DefectCounts, Promise, layer_entries};
use meshmend_testkit::{Soup, oracle, reference};

use crate::compare::{assert_well_formed, position_keys};
use crate::input::{SmallMesh, Work};

/// A small mesh through the default pipeline: its postconditions hold, its record is true, doing it again changes
/// nothing, every kernel gives the same, and without `triangulate` it is what the reference gives, where doubles are
/// exact.
pub fn repair(data: &[u8]) {
    let Ok(SmallMesh(soup)) = SmallMesh::arbitrary(&mut Unstructured::new(data)) else { return };
    let mesh = soup.numbered();
    let pipeline = Pipeline::default().on_emptying(Emptying::Allow);
    let repaired = pipeline.run(&mesh).expect("the default pipeline takes any mesh");
    if soup.faces.is_empty() {
        assert!(repaired.provenance.is_same(), "what has no face is left as it is");
        return;
    }
    assert_clean(&repaired.mesh);
    assert_true_record(&mesh, &repaired);
    assert_corners_kept_their_points(&mesh, &repaired);
    let again = pipeline.run(&repaired.mesh).expect("a repaired mesh can be repaired");
    assert_same_to_see(&again.mesh, &repaired.mesh);
    assert!(again.provenance.is_same() && again.removed_faces.is_empty() && !again.is_changed());
    assert_every_kernel_agrees(&pipeline, &mesh, &Ok(repaired));
    if !is_exact_in_doubles(&soup) {
        return;
    }
    // What faces with holes are cut into is this program's own choice.
    if !reference::faces_with_holes(&reference::exact_positions(&soup), &soup.faces).is_empty() {
        return;
    }
    for (edges, split) in
        [(SplitEdges::Sheets, reference::Split::Sheets), (SplitEdges::Cut, reference::Split::Cut)]
    {
        let mut plan = Plan::default().without(PassKind::Triangulate);
        plan.split.edges = edges;
        let pipeline = plan.pipeline().on_emptying(Emptying::Allow);
        let repaired = pipeline.run(&mesh).expect("the default pipeline takes any mesh");
        assert_is_reference(&repaired, &reference::repair_soup(&soup, split));
    }
}

/// Whether areas and volumes of faces come out the same in doubles and in the reference's fractions.
fn is_exact_in_doubles(soup: &Soup) -> bool {
    let is_small_and_whole = |x: &f64| !x.is_finite() || (x.fract() == 0.0 && x.abs() <= 4096.0);
    soup.positions.iter().flatten().all(is_small_and_whole)
}

/// A small mesh through any passes in any order with any options, and each of these passes alone.
pub fn passes(data: &[u8]) {
    let Ok(Work { mesh: SmallMesh(soup), plan, kernel }) = Work::arbitrary(&mut Unstructured::new(data))
    else {
        return;
    };
    let mesh = soup.numbered();
    let pipeline = plan.pipeline();
    let result = pipeline.run(&mesh);
    assert_honest(&result);
    if let Ok(repaired) = &result {
        assert_well_formed(&repaired.mesh);
        assert_true_record(&mesh, repaired);
        if is_final(&plan) {
            let again = pipeline.run(&repaired.mesh).expect("what was repaired can be repaired");
            assert_same_to_see(&again.mesh, &repaired.mesh);
            assert!(!again.is_changed());
        }
    }
    assert_every_kernel_agrees(&pipeline, &mesh, &result);
    if let Ok(repaired) = pipeline.run_in(Session::begin(&mesh).with_kernel(kernel)) {
        assert_same_mesh(&repaired.mesh, &result.expect("the default kernel holds what another does").mesh);
    }
    let kinds: BTreeMap<PassKind, &AnyPass> =
        pipeline.passes().iter().map(|pass| (pass.kind(), pass)).collect();
    kinds.values().for_each(|pass| assert_promises(pass, &mesh));
}

/// Whether a second run of a plan is known to change nothing: its passes come in the usual order, each once, and none of
/// those that make a mesh manifold is left out. Other plans may subdivide the same faces again in every run.
fn is_final(plan: &Plan) -> bool {
    let needed = [PassKind::Weld, PassKind::Clean, PassKind::Orient, PassKind::Split];
    plan.check_order().is_ok()
        && plan.passes.is_sorted_by(|one, other| one < other)
        && needed.iter().all(|kind| plan.passes.contains(kind))
}

/// The bytes as a plan file: an error, or a plan that is written and read as the same plan, and runs.
pub fn plan(data: &[u8]) {
    let Ok(text) = std::str::from_utf8(data) else { return };
    let Ok(mut plan) = Plan::from_toml(text) else { return };
    let written = toml::to_string(&plan).expect("a plan can be written");
    let again = Plan::from_toml(&written).expect("a written plan can be read");
    assert_eq!(toml::to_string(&again).expect("a plan can be written"), written);
    plan.passes.truncate(16);
    assert_honest(&plan.pipeline().run(&troubled().numbered()));
}

/// Something of everything: a pinch, a book of three pages, faces there twice, coincident and infinite points.
fn troubled() -> Soup {
    let faces: [&[u32]; 9] = [
        &[0, 1, 2],
        &[0, 1, 3],
        &[0, 4, 1],
        &[5, 6, 7],
        &[5, 6, 7],
        &[0, 8, 9, 2, 8],
        &[2, 2, 3],
        &[3, 9, 10],
        &[1, 4],
    ];
    let mut soup = Soup::generic(11, faces);
    (soup.positions[5], soup.positions[10]) = (soup.positions[0], [f64::INFINITY; 3]);
    soup
}

/// No error blames the program itself.
fn assert_honest(result: &Result<Repaired, PassError>) {
    assert!(
        !matches!(result, Err(PassError::Promise { .. } | PassError::Draft(_))),
        "{:?}",
        result.as_ref().err()
    );
}

fn assert_same_mesh(one: &PolygonMesh, other: &PolygonMesh) {
    assert_same_to_see(one, other);
    assert_eq!(one.layers(), other.layers());
}

/// The same but for what a vertex keeps beside its corners' values, which is seen only where no corner is left.
fn assert_same_to_see(one: &PolygonMesh, other: &PolygonMesh) {
    assert_eq!(position_keys(one), position_keys(other));
    assert_eq!(one.faces(), other.faces());
    assert_eq!(one.layers().len(), other.layers().len());
    for (one, other) in one.layers().iter().zip(other.layers()) {
        let kind = |layer: &Layer| (layer.domain(), layer.home(), layer.width(), layer.carry());
        assert_eq!((one.name(), kind(one)), (other.name(), kind(other)));
        assert_eq!(layer_entries(one), layer_entries(other), "{}", one.name());
    }
}

fn assert_clean(mesh: &PolygonMesh) {
    let soup = Soup::of_mesh(mesh);
    assert_eq!(reference::broken_postconditions(soup.vertex_count(), &soup.faces), [""; 0]);
    let report = oracle::report(&soup);
    assert!(report.manifold && report.non_finite_vertices == 0, "{report:?}");
    assert!(report.consistently_oriented || !report.orientable, "{report:?}");
}

/// The record is true, attributes follow it, and each old face is there or named as removed.
fn assert_true_record(old: &PolygonMesh, repaired: &Repaired) {
    let change = Change { before: old, after: &repaired.mesh, record: &repaired.provenance };
    assert_eq!(change.record_law(), Ok(()));
    assert_eq!(change.attribute_law(), Ok(()));
    let removed = repaired.removed_faces.iter().map(|removed| (removed.face, removed.reason));
    assert_eq!(change.removal_law(removed), Ok(()));
}

/// No corner moved, and each vertex has its source's point to the bit.
fn assert_corners_kept_their_points(old: &PolygonMesh, repaired: &Repaired) {
    let change = Change { before: old, after: &repaired.mesh, record: &repaired.provenance };
    assert_eq!(change.place_law(|_, _| false).and(change.bit_law()), Ok(()));
}

/// Every kernel that can hold any mesh gives the same mesh, record and error.
fn assert_every_kernel_agrees(pipeline: &Pipeline, mesh: &PolygonMesh, result: &Result<Repaired, PassError>) {
    for &kernel in KernelKind::ALL.iter().filter(|kind| kind.capabilities().is_permissive()) {
        match (result, &pipeline.run_in(Session::begin(mesh).with_kernel(kernel))) {
            (Ok(one), Ok(other)) => {
                assert_same_mesh(&one.mesh, &other.mesh);
                assert_eq!(one.provenance, other.provenance, "{kernel}");
                assert_eq!(one.removed_faces, other.removed_faces, "{kernel}");
            }
            (Err(one), Err(other)) => assert_eq!(one.to_string(), other.to_string(), "{kernel}"),
            (one, other) => panic!("{kernel}: {:?} became {:?}", one.as_ref().err(), other.as_ref().err()),
        }
    }
}

fn assert_is_reference(repaired: &Repaired, wanted: &reference::Repaired) {
    let (faces, record) = (repaired.mesh.faces(), &repaired.provenance);
    let rotated = |mut face: Vec<u32>| {
        let least = (0..face.len()).min_by_key(|&i| face[i]).unwrap_or(0);
        face.rotate_left(least);
        face
    };
    let list: Vec<Vec<u32>> =
        faces.faces().map(|f| rotated(faces.face_vertices(f).iter().map(|v| v.0).collect())).collect();
    assert_eq!(list, wanted.faces.iter().cloned().map(rotated).collect::<Vec<_>>());
    let sources: Vec<Option<u32>> = record.vertices.iter().map(|(_, source)| source.map(|v| v.0)).collect();
    assert_eq!(sources, wanted.source_vertex);
    let sources: Vec<Option<u32>> = record.faces.iter().map(|(_, source)| source.map(|f| f.0)).collect();
    assert_eq!(sources, wanted.source_face.iter().copied().map(Some).collect::<Vec<_>>());
    let flipped: Vec<u32> =
        (0..).zip(&wanted.flipped).filter(|(_, flip)| **flip).map(|(face, _)| face).collect();
    assert_eq!(record.flipped.iter().map(|f| f.0).collect::<Vec<_>>(), flipped);
    assert_eq!(record.created.len(), wanted.inserted.len());
    let report = repaired.topology.as_ref().expect("the pipeline ends with verify");
    assert_eq!(report.non_orientable_patches, wanted.non_orientable.len() as u64);
}

/// A pass alone, where what it requires is there, removes what it says and introduces only what it says.
fn assert_promises(pass: &AnyPass, mesh: &PolygonMesh) {
    let pass = pass.as_pass();
    let Ok(outcome) = pass.apply(mesh, &Context::default()) else { return };
    if mesh.counts().faces == 0 {
        return;
    }
    let promise =
        Promise { removes: pass.removes(), requires: pass.requires(), may_introduce: pass.may_introduce() };
    let [before, after] = [mesh, &outcome.mesh].map(DefectCounts::of);
    assert_eq!(promise.law(&before, &after), Ok(()), "{}", pass.name());
}
