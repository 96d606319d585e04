//! Non-orientable patches cut open: along few edges, at the same place whatever is done again, and with a record.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_core::{DefectKind, PolygonMesh};
use meshmend_kernels::KernelKind;
use meshmend_repair::{Emptying, NonOrientable, PassKind, Pipeline, Plan, Repaired, SeamFigures, Session};
use meshmend_testkit::shapes::{self, Closed, Shape, Tiles};
use meshmend_testkit::{Soup, oracle, worlds};
use proptest::prelude::*;

fn cutting() -> Pipeline {
    let mut plan = Plan { empty: Emptying::Allow, ..Plan::default() };
    plan.orient.non_orientable = NonOrientable::Cut;
    plan.pipeline()
}

fn cut_open(mesh: &PolygonMesh) -> Repaired {
    cutting().run(mesh).unwrap()
}

fn seam(repaired: &Repaired) -> Option<SeamFigures> {
    repaired.passes.iter().find_map(|record| record.seam)
}

/// How many edges and vertices the mesh has more than before, beside the faces that stay.
fn growth(before: &PolygonMesh, after: &PolygonMesh) -> [u64; 2] {
    let counts = |mesh: &PolygonMesh| [mesh.complex().edges().edge_count(), mesh.counts().vertices];
    let (before, after) = (counts(before), counts(after));
    [0, 1].map(|i| (after[i] - before[i]) as u64)
}

#[track_caller]
fn assert_seam(shape: &Shape, edges: u64, vertices: u64) {
    let mesh = shape.soup.mesh();
    let repaired = cut_open(&mesh);
    let found = seam(&repaired).unwrap();
    assert_eq!((found.edges, found.edges_added, found.vertices_added), (edges, edges, vertices));
    assert_eq!(growth(&mesh, &repaired.mesh), [edges, vertices], "the record is what was added");
    let split = repaired.passes.iter().find(|record| record.pass == PassKind::Split).unwrap();
    let named: Vec<_> = split.fixed.iter().filter(|d| d.kind() == DefectKind::SeamEdge).collect();
    assert_eq!(named.len() as u64, edges);
    let report = oracle::report(&Soup::of_mesh(&repaired.mesh));
    assert!(report.orientable && report.consistently_oriented && report.manifold);
    assert_eq!(report.components, 1);
}

#[test]
fn closed_forms() {
    for tiles in [Tiles::Quads, Tiles::Triangles] {
        // A circle across, along which nothing is mirrored: an annulus is left.
        assert_seam(&shapes::klein_bottle(8, 8, tiles), 8, 8);
        assert_seam(&shapes::klein_bottle(20, 5, tiles), 5, 5);
        // From border to border.
        assert_seam(&shapes::moebius_band(8, 1, tiles), 1, 2);
        assert_seam(&shapes::moebius_band(12, 3, tiles), 3, 4);
        assert_seam(&shapes::moebius_band(40, 6, tiles), 6, 7);
    }
    // A closed path that comes back mirrored: a disc is left.
    assert_seam(&shapes::projective_plane(), 3, 3);
}

#[test]
fn the_length_is_that_of_the_seam() {
    let mut band = shapes::moebius_band(12, 3, Tiles::Quads).soup;
    let across = seam(&cut_open(&band.mesh())).unwrap().length.unwrap();
    assert!((across - 1.0).abs() < 1e-12, "{across}");
    let stretched = band.positions.iter().map(|p| p.map(|x| 2.0 * x)).collect();
    band.positions = stretched;
    assert_eq!(seam(&cut_open(&band.mesh())).unwrap().length, Some(2.0 * across));
}

#[test]
fn what_is_orientable_is_not_cut() {
    let torus = shapes::torus(5, 4, Tiles::Triangles).soup.mesh();
    let repaired = cut_open(&torus);
    assert!(seam(&repaired).is_none() && repaired.provenance.is_same());
}

/// A band that is joined by position alone along a crooked line is cut there, though straight across is shorter.
#[test]
fn what_is_joined_by_index_stays_joined() {
    let (round, across) = (10, 4);
    let mut band = shapes::moebius_band(round, across, Tiles::Quads).soup;
    let line = [(1, 0), (1, 1), (1, 2), (2, 2), (2, 3), (2, 4)].map(|(i, j)| (i * (across + 1) + j) as u32);
    let copies = band.positions.len() as u32;
    band.positions.extend(line.map(|vertex| band.positions[vertex as usize]));
    for (face, corners) in band.faces.iter_mut().enumerate() {
        let (i, j) = (face / across, face % across);
        let is_behind = (i == 1 && j < 2) || (2..5).contains(&i);
        for corner in corners.iter_mut().filter(|_| is_behind) {
            if let Some(place) = line.iter().position(|vertex| vertex == corner) {
                *corner = copies + place as u32;
            }
        }
    }
    let repaired = cut_open(&band.mesh());
    assert_eq!(seam(&repaired).unwrap().edges, 5);
    let result = Soup::of_mesh(&repaired.mesh);
    let same_vertices = |(one, other): (&Vec<u32>, &Vec<u32>)| {
        let [mut one, mut other] = [one.clone(), other.clone()];
        one.sort_unstable();
        other.sort_unstable();
        one == other
    };
    assert!(result.positions == band.positions && result.faces.iter().zip(&band.faces).all(same_vertices));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn cutting_again_changes_nothing(
        caps in 1..5usize,
        holes in 0..3usize,
        (turned, soup) in (any::<u64>(), worlds::any_table(12)),
        is_soup in any::<bool>(),
    ) {
        let mut given = if is_soup { soup } else { shapes::surface(Closed::CrossCaps(caps), holes, 0).soup };
        let flips = given.faces.iter_mut().enumerate().filter(|(i, _)| turned >> (i % 64) & 1 == 1);
        flips.for_each(|(_, face)| face.reverse());
        prop_assume!(!given.faces.is_empty());
        let first = cut_open(&given.mesh());
        let report = oracle::report(&Soup::of_mesh(&first.mesh));
        prop_assert!(report.orientable && report.consistently_oriented && report.manifold);
        let again = cut_open(&first.mesh);
        prop_assert!(again.provenance.is_same());
        for &kernel in KernelKind::ALL.iter().filter(|kernel| kernel.capabilities().is_permissive()) {
            let other = cutting().run_in(Session::begin(&given.mesh()).with_kernel(kernel)).unwrap();
            prop_assert_eq!(seam(&other), seam(&first));
            prop_assert_eq!(Soup::of_mesh(&other.mesh), Soup::of_mesh(&first.mesh));
        }
    }
}
