//! What a repair promises, on meshes of any kind, judged by the oracle that shares nothing with the library.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use std::collections::BTreeSet;

use meshmend_core::{Carry, Connectivity, CornerId, Domain, FaceId, Layer, PolygonMesh, Values, VertexId};
use meshmend_kernels::KernelKind;
use meshmend_repair::{
    Clean, Compact, Context, Distance, Duplicates, LooseElements, NonFinite, NonOrientable, Orient, Pass,
    PassError, PassKind, Pipeline, Plan, Repaired, Side, Split, SplitEdges, Triangulate, TriangulateFaces,
    Weld,
};
use meshmend_testkit::{Soup, oracle, worlds};
use proptest::prelude::*;

/// A mesh each of whose vertices, corners and faces carries its own number.
fn numbered(soup: &Soup) -> PolygonMesh {
    let mesh = soup.mesh();
    let counts = mesh.counts();
    let layer = |name, domain, count: usize| {
        Layer::direct(name, domain, 1, Carry::Clear, Values::U32((0..count as u32).collect()))
    };
    mesh.with_layers(vec![
        layer("corner number", Domain::Corner, counts.corners),
        layer("face number", Domain::Face, counts.faces),
    ])
    .unwrap()
}

/// Every position with its bits, so that NaN equals itself.
fn bits(mesh: &PolygonMesh) -> Vec<[u64; 3]> {
    mesh.positions().iter().map(|p| p.map(f64::to_bits)).collect()
}

fn assert_same_mesh(one: &PolygonMesh, other: &PolygonMesh) {
    assert_eq!(bits(one), bits(other));
    assert_eq!(one.faces(), other.faces());
}

fn assert_clean(repaired: &Repaired) {
    let report = oracle::report(&Soup::of_mesh(&repaired.mesh));
    assert!(report.manifold, "{report:?}");
    assert_eq!(report.degenerate_faces + report.non_simple_faces + report.duplicate_faces.same, 0);
    assert_eq!(report.unreferenced_vertices, 0);
    assert!(report.consistently_oriented || !report.orientable, "{report:?}");
    assert_eq!(report.non_finite_vertices, 0);
}

/// Each new face and corner is the old one that the record says, and all that is gone is named.
fn assert_truthful(old: &PolygonMesh, repaired: &Repaired) {
    let (new, record) = (&repaired.mesh, &repaired.provenance);
    let corner_numbers = new.layer("corner number", Domain::Corner).unwrap();
    let flipped: BTreeSet<FaceId> = record.flipped.iter().copied().collect();
    for face in new.faces().faces() {
        let source = record.faces.of(face).expect("no pass adds faces");
        assert_eq!(
            new.layer("face number", Domain::Face).unwrap().value_of(face.0 as usize),
            Some(source.0 as usize)
        );
        let mut places = Vec::new();
        for corner in new.faces().face_corners(face) {
            let old_corner = record.corners.of(corner);
            assert_eq!(corner_numbers.value_of(corner.0 as usize), old_corner.map(|c| c.0 as usize));
            let Some(old_corner) = old_corner else { continue };
            assert_eq!(old.faces().corner_face(old_corner), source);
            let (here, there) = (new.faces().corner_vertex(corner), old.faces().corner_vertex(old_corner));
            assert_eq!(new.position(here), old.position(there), "{corner} moved");
            places.push(old_corner);
        }
        assert_runs_round(&places, flipped.contains(&face));
    }
    for (vertex, source) in record.vertices.iter() {
        let created = record.created.iter().any(|(v, _)| *v == vertex);
        assert_eq!(source.is_none(), created);
        if let Some(source) = source {
            assert_eq!(new.position(vertex).map(f64::to_bits), old.position(source).map(f64::to_bits));
        }
    }
    let survivors: BTreeSet<FaceId> = record.faces.iter().filter_map(|(_, old)| old).collect();
    let removed: BTreeSet<FaceId> = repaired.removed_faces.iter().map(|r| r.face).collect();
    assert!(survivors.is_disjoint(&removed));
    assert_eq!(survivors.len() + removed.len(), old.counts().faces, "a face went without a word");
}

/// Corners of a face, kept or reversed, ascend but for one step round the end.
fn assert_runs_round(places: &[CornerId], is_flipped: bool) {
    let mut places = places.to_vec();
    if is_flipped {
        places.reverse();
    }
    let descents = (0..places.len()).filter(|&i| places[i] >= places[(i + 1) % places.len()]).count();
    assert!(descents <= 1, "{places:?}");
}

fn plans() -> impl Strategy<Value = Plan> {
    let sides = prop_oneof![Just(Side::Majority), Just(Side::Outward), Just(Side::OutwardNested)];
    let twisted = prop_oneof![Just(NonOrientable::Report), Just(NonOrientable::Cut)];
    let doubles =
        prop_oneof![Just(Duplicates::Keep), Just(Duplicates::RemovePair), Just(Duplicates::KeepFirst)];
    let edges = prop_oneof![Just(SplitEdges::Sheets), Just(SplitEdges::Cut), Just(SplitEdges::PinchOnly)];
    let faces = prop_oneof![Just(TriangulateFaces::Auto), Just(TriangulateFaces::All)];
    let distances =
        prop_oneof![Just(Distance::Exact), Just(Distance::Absolute(1.0)), Just(Distance::Relative(0.3))];
    let finite = prop_oneof![Just(NonFinite::Drop), Just(NonFinite::Keep)];
    let loose = prop_oneof![Just(LooseElements::Remove), Just(LooseElements::Keep)];
    let passes = prop_oneof![
        Just(PassKind::ALL.to_vec()),
        proptest::collection::vec(proptest::sample::select(PassKind::ALL), 0..8)
    ];
    ((sides, twisted, doubles), (edges, faces), (distances, finite, loose), passes).prop_map(
        |((side, non_orientable, duplicates), (edges, faces), (distance, non_finite, loose), passes)| Plan {
            passes,
            weld: Weld { distance },
            clean: Clean { non_finite },
            orient: Orient { side, non_orientable, duplicates },
            split: Split { edges, ..Split::default() },
            triangulate: Triangulate { faces },
            compact: Compact { loose_edges: loose, loose_points: loose },
            ..Plan::default()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_default_pipeline_keeps_its_promises(soup in worlds::any_table(12)) {
        let mesh = numbered(&soup);
        let repaired = Pipeline::default().run(&mesh).unwrap();
        assert_clean(&repaired);
        assert_truthful(&mesh, &repaired);
        let again = Pipeline::default().run(&repaired.mesh).unwrap();
        assert_same_mesh(&again.mesh, &repaired.mesh);
        prop_assert!(again.provenance.is_same());
    }

    #[test]
    fn damaged_shapes_come_out_clean((_, _, soup) in worlds::damaged_shape()) {
        let mesh = numbered(&soup);
        let repaired = Pipeline::default().run(&mesh).unwrap();
        assert_clean(&repaired);
        assert_truthful(&mesh, &repaired);
        let again = Pipeline::default().run(&repaired.mesh).unwrap();
        assert_same_mesh(&again.mesh, &repaired.mesh);
    }

    #[test]
    fn any_plan_runs_and_is_the_same_on_every_kernel_and_thread_count(
        soup in worlds::any_table(10),
        plan in plans(),
    ) {
        let mesh = numbered(&soup);
        let first = plan.pipeline().run(&mesh);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        for kernel in KernelKind::ALL {
            let other = pool.install(|| plan.pipeline().on_kernel(*kernel).run(&mesh));
            match (&first, &other) {
                (_, Err(PassError::Refused(_))) if !kernel.capabilities().is_permissive() => {}
                (Ok(one), Ok(other)) => {
                    assert_same_mesh(&one.mesh, &other.mesh);
                    prop_assert_eq!(&one.provenance, &other.provenance);
                }
                (Err(one), Err(other)) => prop_assert_eq!(one.to_string(), other.to_string()),
                _ => prop_assert!(false, "one kernel repairs and {} does not", kernel),
            }
        }
        prop_assert!(!matches!(first, Err(PassError::Promise { .. } | PassError::Draft(_))), "{:?}", first.err());
    }

    #[test]
    fn strict_kernels_repair_what_they_hold_just_the_same(
        (_, _, soup) in worlds::damaged_shape(),
        plan in plans(),
    ) {
        let mesh = numbered(&soup);
        let Ok(first) = plan.pipeline().run(&mesh) else { return Ok(()) };
        for kernel in KernelKind::ALL.iter().filter(|k| !k.capabilities().is_permissive()) {
            match plan.pipeline().on_kernel(*kernel).run(&mesh) {
                Ok(other) => {
                    assert_same_mesh(&first.mesh, &other.mesh);
                    prop_assert_eq!(&first.provenance, &other.provenance);
                }
                Err(error) => prop_assert!(matches!(error, PassError::Refused(_)), "{}: {}", kernel, error),
            }
        }
    }

    #[test]
    fn cutting_makes_everything_orientable(soup in worlds::any_table(12)) {
        let mut plan = Plan::default();
        plan.orient.non_orientable = NonOrientable::Cut;
        let mesh = numbered(&soup);
        let repaired = plan.pipeline().run(&mesh).unwrap();
        assert_clean(&repaired);
        assert_truthful(&mesh, &repaired);
        let report = oracle::report(&Soup::of_mesh(&repaired.mesh));
        prop_assert!(report.orientable && report.consistently_oriented);
        assert_same_mesh(&plan.pipeline().run(&repaired.mesh).unwrap().mesh, &repaired.mesh);
    }

    #[test]
    fn no_closed_patch_is_left_inside_out(
        soup in worlds::any_table(14),
        non_orientable in prop_oneof![Just(NonOrientable::Report), Just(NonOrientable::Cut)],
    ) {
        let mut plan = Plan::default();
        (plan.orient.side, plan.orient.non_orientable) = (Side::Outward, non_orientable);
        let repaired = plan.pipeline().run(&numbered(&soup)).unwrap();
        assert_clean(&repaired);
        let again = plan.orient.apply(&repaired.mesh, &Context::default()).unwrap();
        prop_assert!(again.provenance.is_same());
    }

    #[test]
    fn pinch_only_leaves_edges_and_splits_vertices(soup in worlds::generic_table(12)) {
        let mut plan = Plan::default();
        plan.split.edges = SplitEdges::PinchOnly;
        let before = oracle::report(&soup);
        let repaired = plan.pipeline().run(&numbered(&soup)).unwrap();
        let after = oracle::report(&Soup::of_mesh(&repaired.mesh));
        prop_assert_eq!(after.non_manifold_vertices.pinched, 0);
        prop_assert!(repaired.provenance.created.is_empty());
        if before.manifold && before.degenerate_faces + before.non_simple_faces + before.duplicate_faces.same == 0 {
            prop_assert!(after.manifold);
        }
    }

    #[test]
    fn what_is_clean_comes_out_as_it_went_in(shape in worlds::any_shape()) {
        let soup = shape.soup;
        let report = oracle::report(&soup);
        prop_assume!(report.manifold && report.consistently_oriented && report.unreferenced_vertices == 0);
        prop_assume!(report.degenerate_faces + report.non_simple_faces + report.duplicate_faces.same == 0);
        let mesh = soup.mesh();
        let repaired = Pipeline::default().run(&mesh).unwrap();
        let coincident = meshmend_repair::coincident_vertices(&mesh).iter().zip(0..).any(|(low, v)| low.0 != v);
        if !coincident {
            assert_same_mesh(&mesh, &repaired.mesh);
            prop_assert!(repaired.provenance.is_same() && repaired.passes.iter().all(|p| !p.is_changed));
        }
    }

    #[test]
    fn triangulating_everything_gives_triangles_and_keeps_the_topology(soup in worlds::any_table(10)) {
        let mut plan = Plan::default();
        plan.triangulate.faces = TriangulateFaces::All;
        let mesh = numbered(&soup);
        let repaired = plan.pipeline().run(&mesh).unwrap();
        prop_assert!(repaired.mesh.faces().is_all_triangles());
        assert_clean(&repaired);
        let whole = Pipeline::new(Plan::default().without(PassKind::Triangulate).pipeline().passes().to_vec());
        let uncut = whole.run(&mesh).unwrap();
        let [one, other] = [&repaired, &uncut].map(|r| oracle::report(&Soup::of_mesh(&r.mesh)));
        prop_assert_eq!(one.euler_characteristic, other.euler_characteristic);
        prop_assert_eq!(
            (one.components, one.boundary_loops, one.genus, one.cross_caps),
            (other.components, other.boundary_loops, other.genus, other.cross_caps)
        );
    }
}

/// Two closed tetrahedra, one inside the other, both inside out, and an open square.
#[test]
fn outward_turns_closed_patches_alternating_if_asked_and_leaves_others_to_the_majority() {
    let tetrahedron = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
    let mut positions = Vec::new();
    for size in [9.0, 1.0] {
        positions.extend(
            [[-1.0, -1.0, -1.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0]]
                .map(|p: [f64; 3]| p.map(|x| x * size)),
        );
    }
    positions.extend([[50.0, 0.0, 0.0], [51.0, 0.0, 0.0], [50.0, 1.0, 0.0], [51.0, 1.0, 0.0]]);
    let mut faces: Vec<Vec<u32>> = tetrahedron.iter().map(|f| f.to_vec()).collect();
    faces.extend(tetrahedron.iter().map(|f| f.iter().map(|v| v + 4).collect()));
    faces.extend([vec![8, 9, 10], vec![9, 10, 11]]);
    let soup = Soup { positions, faces };
    let run = |side| {
        let mut plan = Plan::default();
        plan.orient.side = side;
        plan.pipeline().run(&soup.mesh()).unwrap()
    };
    let volume = |repaired: &Repaired, range: std::ops::Range<usize>| -> f64 {
        let soup = Soup::of_mesh(&repaired.mesh);
        let point = |v: u32| soup.positions[v as usize];
        let triple = |f: &Vec<u32>| {
            let [a, b, c] = [point(f[0]), point(f[1]), point(f[2])];
            a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        soup.faces[range].iter().map(triple).sum()
    };
    let repaired = run(Side::Outward);
    assert!(volume(&repaired, 0..4) > 0.0 && volume(&repaired, 4..8) > 0.0);
    let nested = run(Side::OutwardNested);
    assert!(volume(&nested, 0..4) > 0.0 && volume(&nested, 4..8) < 0.0);
    assert_eq!(repaired.provenance.flipped.iter().filter(|f| f.0 >= 8).count(), 1);
}

/// Two boxes that share an edge, all faces inward: only when `split` has taken them apart is each of them closed.
#[test]
fn solids_that_touch_are_turned_outward_too() {
    let mut boxes = meshmend_testkit::shapes::two_boxes_on_an_edge().soup;
    boxes.faces.iter_mut().for_each(|face| face[1..].reverse());
    let mut plan = Plan::default();
    plan.orient.side = Side::Outward;
    let faces = boxes.faces.len();
    let [inward, outward] = [true, false].map(|is_reversed| {
        let mut soup = boxes.clone();
        if !is_reversed {
            soup.faces.iter_mut().for_each(|face| face[1..].reverse());
        }
        plan.pipeline().run(&soup.mesh()).unwrap()
    });
    let flips = [inward.provenance.flipped.len(), outward.provenance.flipped.len()];
    assert_eq!(flips.iter().sum::<usize>(), faces, "one of the two was outward before");
    assert!(flips.contains(&0));
    let again = plan.pipeline().run(&inward.mesh).unwrap();
    assert_same_mesh(&again.mesh, &inward.mesh);
}

#[test]
fn opposite_duplicates_stay_unless_told_otherwise() {
    let soup = Soup::generic(3, [[0, 1, 2], [0, 2, 1]]);
    let run = |duplicates| {
        let mut plan = Plan::default();
        plan.orient.duplicates = duplicates;
        plan.pipeline().run(&soup.mesh()).unwrap()
    };
    assert_eq!(run(Duplicates::Keep).mesh.counts().faces, 2);
    let first = run(Duplicates::KeepFirst);
    assert_eq!(first.removed_faces.iter().map(|r| r.face).collect::<Vec<_>>(), [FaceId(1)]);
    assert_eq!(run(Duplicates::RemovePair).mesh.counts().faces, 0);
}

#[test]
fn a_chain_of_duplicates_is_followed_to_its_end() {
    for links in [1, 2, 7, 300] {
        let chain = meshmend_testkit::shapes::duplicate_chain(links);
        let repaired = Pipeline::default().run(&chain.soup.mesh()).unwrap();
        let removed: BTreeSet<u32> = repaired.removed_faces.iter().map(|r| r.face.0).collect();
        assert_eq!(removed, chain.dropped.iter().copied().collect(), "{links} links");
    }
}

/// Three squares over the same four vertices: no diagonal is free, and the centres of all three are one point.
#[test]
fn created_vertices_do_not_coincide() {
    let positions = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| [f64::from(x), f64::from(y), 0.0]).to_vec();
    let hemicube = Soup { positions, faces: vec![vec![0, 1, 2, 3], vec![0, 2, 1, 3], vec![0, 1, 3, 2]] };
    let mut plan = Plan::default();
    plan.triangulate.faces = TriangulateFaces::All;
    let repaired = plan.pipeline().run(&hemicube.mesh()).unwrap();
    assert_eq!((repaired.provenance.created.len(), repaired.mesh.counts().faces), (3, 12));
    let lowest = meshmend_repair::coincident_vertices(&repaired.mesh);
    assert!(lowest.iter().zip(0..).all(|(low, v)| low.0 == v));
}

#[test]
fn a_policy_of_fail_names_what_it_found() {
    let band = meshmend_testkit::shapes::moebius_band(6, 2, meshmend_testkit::shapes::Tiles::Quads).soup;
    let mut plan = Plan::default();
    plan.orient.non_orientable = NonOrientable::Fail;
    let Err(PassError::Policy { pass: "orient", defects, .. }) = plan.pipeline().run(&band.mesh()) else {
        panic!("a Möbius band was accepted")
    };
    let meshmend_core::Defect::NonOrientablePatch { faces, edges } = &defects[0] else {
        panic!("{defects:?}")
    };
    let ids = |list: Vec<u32>| list;
    let result = oracle::check_witness(
        &band,
        &ids(faces.iter().map(|f| f.0).collect()),
        &ids(edges.iter().map(|e| e.0).collect()),
    );
    assert_eq!(result, Ok(()));
    let mut plan = Plan::default();
    plan.clean.non_finite = NonFinite::Fail;
    let soup = Soup { positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [f64::NAN; 3]], faces: vec![vec![0, 1, 2]] };
    assert!(matches!(plan.pipeline().run(&soup.mesh()), Err(PassError::Policy { pass: "clean", .. })));
}

#[test]
fn a_strict_kernel_refuses_with_every_reason() {
    let soup = meshmend_testkit::shapes::two_tetrahedra_on_a_vertex().soup;
    let Err(PassError::Refused(refusal)) =
        Pipeline::default().on_kernel(KernelKind::HalfEdge).run(&soup.mesh())
    else {
        panic!("half-edge took a pinched vertex")
    };
    assert_eq!(refusal.defects.len(), 1);
}

/// Colours on the vertices of a square of two triangles that share no vertex; the seam's colours differ.
#[test]
fn attributes_of_welded_vertices_move_to_the_corners() {
    let positions =
        [[0, 0], [1, 0], [0, 1], [0, 1], [1, 0], [1, 1]].map(|[x, y]| [f64::from(x), f64::from(y), 0.0]);
    let soup = Soup { positions: positions.to_vec(), faces: vec![vec![0, 1, 2], vec![3, 4, 5]] };
    for (values, domain) in [([1, 2, 3, 4, 5, 6], Domain::Corner), ([1, 2, 3, 3, 2, 6], Domain::Vertex)] {
        let colours = Layer::direct("color", Domain::Vertex, 1, Carry::Copy, Values::U8(values.to_vec()));
        let mesh = soup.mesh().with_layers(vec![colours]).unwrap();
        let repaired = Pipeline::default().run(&mesh).unwrap().mesh;
        assert_eq!(repaired.positions().len(), 4);
        let layer = &repaired.layers()[0];
        assert_eq!(layer.domain(), domain);
        let Values::U8(pool) = layer.values() else { panic!("another type") };
        let at_corners: Vec<u8> = repaired
            .faces()
            .corners()
            .map(|c| {
                let element =
                    if domain == Domain::Corner { c.0 } else { repaired.faces().corner_vertex(c).0 };
                pool[layer.value_of(element as usize).unwrap()]
            })
            .collect();
        assert_eq!(at_corners, values);
    }
}

#[test]
fn loose_elements_follow_their_vertices_or_are_named() {
    let soup = Soup {
        positions: vec![[9.0; 3], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [5.0; 3]],
        faces: vec![vec![1, 2, 3]],
    };
    let loose = (vec![[VertexId(4), VertexId(5)]], vec![VertexId(0)]);
    let mesh = soup.mesh().with_loose(loose.0, loose.1).unwrap();
    let mut plan = Plan::default();
    (plan.compact.loose_edges, plan.compact.loose_points) = (LooseElements::Keep, LooseElements::Keep);
    let kept = plan.pipeline().run(&mesh).unwrap().mesh;
    assert_eq!(
        kept.loose_edges().iter().map(|e| e.map(|v| kept.position(v))).collect::<Vec<_>>(),
        [[[1.0, 0.0, 0.0], [5.0; 3]]]
    );
    assert_eq!(kept.position(kept.loose_points()[0]), [9.0; 3]);
    let removed = Pipeline::default().run(&mesh).unwrap();
    assert!(removed.mesh.loose_edges().is_empty() && removed.mesh.counts().vertices == 3);
    let compact = removed.passes.iter().find(|p| p.pass == PassKind::Compact).unwrap();
    assert_eq!(compact.mended.len(), 2 + 2);
}

/// One face becomes two while another goes: the counts are those of before, the faces are not.
#[test]
fn counts_alone_do_not_say_that_nothing_changed() {
    let soup = Soup::generic(4, [vec![], vec![1, 2, 3, 1, 2, 0]]);
    assert_clean(&Pipeline::default().run(&soup.mesh()).unwrap());
}

#[test]
fn a_cancelled_pipeline_stops() {
    let cancel = std::sync::atomic::AtomicBool::new(true);
    let soup = Soup::generic(3, [[0, 1, 2]]);
    let result = Pipeline::default().run_watched(&soup.mesh(), Some(&cancel), |_| {});
    assert!(matches!(result, Err(PassError::Cancelled)));
}

#[test]
fn every_kernel_has_the_permissive_flag_that_its_capabilities_say() {
    struct Count;
    impl meshmend_kernels::KernelTask for Count {
        type Output = usize;
        fn run<K: Connectivity>(self, kernel: &K) -> usize {
            kernel.edge_count()
        }
    }
    let book = meshmend_testkit::shapes::book(3).soup.complex();
    for kind in KernelKind::ALL {
        assert_eq!(kind.run(&book, Count).is_ok(), kind.capabilities().is_permissive(), "{kind}");
    }
}
