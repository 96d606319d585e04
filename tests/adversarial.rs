//! Meshes on which careless code is quadratic, overflows the stack or gets the answer wrong, with what must be found
//! in them and what must come out of a repair. Results are asserted, not times: a quadratic step shows by never
//! ending.

use std::fmt::Write;

use meshmend_core::{Connectivity, DefectKind, Domain, Id, PolygonMesh, Values};
use meshmend_io::{ReadOptions, read_bytes};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_repair::{Emptying, Pipeline, Repaired};
use meshmend_testkit::shapes::{
    Shape, book, duplicate_chain, fan, nested_pages, out_and_back, polygon, strip, umbrellas,
};
use meshmend_topology::{TopologyReport, topology};

/// How large each family is.
const SIZE: usize = 20_000;

struct Report<'a>(&'a PolygonMesh);

impl KernelTask for Report<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology(kernel, self.0)
    }
}

/// What a check finds is what is known of the shape, through every kernel that holds it; gives the repaired mesh.
#[track_caller]
fn checked_and_repaired(shape: &Shape) -> Repaired {
    let (mesh, truth) = (shape.soup.mesh(), &shape.truth);
    for &kind in KernelKind::ALL {
        let Ok(report) = kind.run(mesh.complex(), Report(&mesh)) else {
            assert!(!kind.capabilities().is_permissive(), "{kind} refuses {}", shape.name);
            continue;
        };
        let found = [report.vertices, report.edges, report.faces, report.components];
        let known = [truth.vertices, truth.edges, truth.faces, truth.components].map(|n| n as u64);
        assert_eq!(found, known, "{kind}: {}", shape.name);
        assert_eq!(report.manifold, truth.manifold, "{kind}: {}", shape.name);
        assert_eq!(report.orientable, truth.orientable, "{kind}: {}", shape.name);
        assert_eq!(report.betti.z2, Some(truth.betti_z2.map(|n| n as u64)), "{kind}: {}", shape.name);
        assert_eq!(report.boundary_loops, truth.boundary_loops.map(|n| n as u64), "{kind}: {}", shape.name);
    }
    repaired(&mesh)
}

/// The repaired mesh, after the promises that hold for any.
#[track_caller]
fn repaired(mesh: &PolygonMesh) -> Repaired {
    let repaired = Pipeline::default().on_emptying(Emptying::Allow).run(mesh).unwrap();
    let report = repaired.topology.as_ref().unwrap();
    assert!(report.manifold && report.orientable && report.consistently_oriented);
    let survivors = repaired.provenance.faces.survivors(mesh.counts().faces);
    let lost = survivors.iter().filter(|survives| !**survives).count();
    assert_eq!(lost, repaired.removed_faces.len());
    repaired
}

/// The kinds of surface in a repaired mesh, with how many there are of each.
fn surfaces(repaired: &Repaired) -> Vec<(u64, &str)> {
    let kinds = &repaired.topology.as_ref().unwrap().component_kinds;
    kinds.iter().map(|kind| (kind.count, kind.name.as_deref().unwrap())).collect()
}

#[track_caller]
fn assert_unchanged(shape: &Shape) {
    let repaired = checked_and_repaired(shape);
    let mesh = shape.soup.mesh();
    assert!(repaired.provenance.is_same(), "{}", shape.name);
    assert!(repaired.mesh.faces() == mesh.faces(), "{}", shape.name);
}

#[test]
fn good_meshes_of_extreme_shape_come_out_as_they_went_in() {
    assert_unchanged(&fan(SIZE));
    assert_unchanged(&strip(SIZE));
    assert_unchanged(&polygon(SIZE));
}

#[test]
fn a_book_falls_into_its_pages() {
    // All pages run through the spine the same way, so that no two of them go on in each other.
    let repaired = checked_and_repaired(&book(SIZE));
    assert_eq!(surfaces(&repaired), [(SIZE as u64, "disc")]);
    assert_eq!(repaired.mesh.counts().vertices, 3 * SIZE);
}

#[test]
fn nested_pages_stay_whole() {
    let repaired = checked_and_repaired(&nested_pages(SIZE));
    assert_eq!(surfaces(&repaired), [(SIZE as u64, "annulus")]);
    assert_eq!(repaired.mesh.counts().vertices, 6 * SIZE);
}

#[test]
fn umbrellas_come_apart() {
    let repaired = checked_and_repaired(&umbrellas(SIZE));
    assert_eq!(surfaces(&repaired), [(SIZE as u64, "sphere")]);
    assert_eq!(repaired.mesh.counts().vertices, 4 * SIZE);
}

#[test]
fn a_face_walked_out_and_back_bounds_nothing() {
    let repaired = checked_and_repaired(&out_and_back(SIZE));
    let reasons: Vec<DefectKind> = repaired.removed_faces.iter().map(|removed| removed.reason).collect();
    assert_eq!(reasons, [DefectKind::DegenerateFace]);
    assert_eq!(repaired.mesh.counts().vertices, 0);
}

#[test]
fn a_chain_of_duplicates_goes_link_by_link() {
    let chain = duplicate_chain(SIZE / 4);
    let repaired = repaired(&chain.soup.mesh());
    let removed: Vec<u32> = repaired.removed_faces.iter().map(|removed| removed.face.0).collect();
    let mut dropped = chain.dropped.clone();
    dropped.sort_unstable();
    assert_eq!(removed, dropped);
    assert!(repaired.removed_faces.iter().all(|removed| removed.reason == DefectKind::DuplicateFace));
    let sources = &repaired.provenance.faces;
    let flipped: Vec<u32> =
        repaired.provenance.flipped.iter().map(|&face| sources.of(face).unwrap().index() as u32).collect();
    assert_eq!(flipped, chain.flipped);
}

#[test]
fn every_one_of_many_groups_is_kept() {
    let mut text = String::from("v 0 0 0\n");
    for corner in 0..=SIZE {
        writeln!(text, "v {corner} 1 0").unwrap();
    }
    for face in 0..SIZE {
        // The corners run backwards every other time, so that faces are flipped and groups have to follow.
        let (from, to) = if face % 3 == 0 { (face + 3, face + 2) } else { (face + 2, face + 3) };
        writeln!(text, "g group{face}\nusemtl material{}\nf 1 {from} {to}", face % 7).unwrap();
    }
    let mesh = read_bytes(text.as_bytes(), "groups.obj", &ReadOptions::default()).unwrap().mesh;
    let repaired = repaired(&mesh);
    assert_eq!(repaired.provenance.flipped.len(), SIZE.div_ceil(3));
    for face in repaired.mesh.faces().faces() {
        let name = |layer| name_of(&repaired.mesh, layer, face.index());
        assert_eq!(name("group"), format!("group{}", face.index()));
        assert_eq!(name("material"), format!("material{}", face.index() % 7));
    }
}

fn name_of(mesh: &PolygonMesh, layer: &str, face: usize) -> String {
    let layer = mesh.layer(layer, Domain::Face).unwrap();
    let Values::Text(names) = layer.values() else { panic!("names are text") };
    String::from_utf8(names[layer.value_of(face).unwrap()].clone()).unwrap()
}
