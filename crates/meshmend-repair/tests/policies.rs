//! What each policy does, on meshes small enough to draw.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use meshmend_core::{Carry, Domain, FaceId, Layer, Values, VertexId, Watch};
use meshmend_kernels::KernelKind;
use meshmend_repair::{
    Duplicates, Emptying, LooseElements, NonFinite, NonOrientable, PassError, PassKind, Pipeline, Plan,
    Repaired, Session, Side, TriangulateFaces,
};
use meshmend_testkit::{Soup, oracle, reference, shapes};

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

/// A tetrahedron inside another one, half of whose faces look the wrong way: whether it winds round the inner one must
/// be asked when they are turned.
#[test]
fn a_shell_is_inside_another_however_the_faces_of_that_one_ran() {
    let tetrahedron = shapes::tetrahedron().soup;
    let mut outer = tetrahedron.clone();
    outer.positions.iter_mut().flatten().for_each(|x| *x *= 9.0);
    let mut nested = Soup::beside(&[outer, tetrahedron], 0.0);
    let mut plan = Plan::default();
    plan.orient.side = Side::OutwardNested;
    let alternating = plan.pipeline().run(&nested.mesh()).unwrap();
    assert_eq!(alternating.provenance.flipped, [4, 5, 6, 7].map(FaceId));
    nested.faces[..2].iter_mut().for_each(|face| face.reverse());
    let repaired = plan.pipeline().run(&nested.mesh()).unwrap();
    assert_eq!(repaired.provenance.flipped, [0, 1, 4, 5, 6, 7].map(FaceId));
}

/// Two boxes that share an edge, all faces inward: only when `split` has taken them apart is each of them closed.
#[test]
fn solids_that_touch_are_turned_outward_too() {
    let mut boxes = shapes::two_boxes_on_an_edge().soup;
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
    assert!(plan.pipeline().run(&inward.mesh).unwrap().provenance.is_same());
}

#[test]
fn opposite_duplicates_stay_unless_told_otherwise() {
    let soup = Soup::generic(3, [[0, 1, 2], [0, 2, 1]]);
    let run = |duplicates| {
        let mut plan = Plan { empty: Emptying::Allow, ..Plan::default() };
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
        let chain = shapes::duplicate_chain(links);
        let repaired = Pipeline::default().run(&chain.soup.mesh()).unwrap();
        let removed: BTreeSet<u32> = repaired.removed_faces.iter().map(|r| r.face.0).collect();
        assert_eq!(removed, chain.dropped.iter().copied().collect(), "{links} links");
    }
}

/// Three squares over the same four vertices: no diagonal is free, so each gets a vertex on one of its diagonals.
#[test]
fn created_vertices_do_not_coincide() {
    let positions = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| [f64::from(x), f64::from(y), 0.0]).to_vec();
    let hemicube = Soup { positions, faces: vec![vec![0, 1, 2, 3], vec![0, 2, 1, 3], vec![0, 1, 3, 2]] };
    let mut plan = Plan::default();
    plan.triangulate.faces = TriangulateFaces::All;
    let repaired = plan.pipeline().run(&hemicube.mesh()).unwrap();
    assert_eq!((repaired.provenance.created.len(), repaired.mesh.counts().faces), (3, 12));
    let created = [[0.5, 0.5, 0.0], [0.5, 1.0, 0.0], [1.0, 0.5, 0.0]];
    assert_eq!(repaired.mesh.positions()[4..], created, "the middle of a diagonal of each");
    let lowest = meshmend_geometry::coincident::coincident_vertices(&repaired.mesh);
    assert!(lowest.iter().zip(0..).all(|(low, v)| low.0 == v));
}

#[test]
fn a_policy_of_fail_names_what_it_found() {
    let band = shapes::moebius_band(6, 2, shapes::Tiles::Quads).soup;
    let mut plan = Plan::default();
    plan.orient.non_orientable = NonOrientable::Fail;
    let Err(PassError::Policy { pass: "orient", defects, .. }) = plan.pipeline().run(&band.mesh()) else {
        panic!("a Möbius band was accepted")
    };
    let meshmend_core::Element::Strip(strip) = &defects[0].at else { panic!("{defects:?}") };
    let faces: Vec<u32> = strip.faces.iter().map(|face| face.0).collect();
    let edges: Vec<u32> = strip.edges.iter().map(|edge| edge.0).collect();
    assert_eq!(oracle::check_witness(&band, &faces, &edges), Ok(()));
    let mut plan = Plan::default();
    plan.clean.non_finite = NonFinite::Fail;
    let soup = Soup { positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [f64::NAN; 3]], faces: vec![vec![0, 1, 2]] };
    assert!(matches!(plan.pipeline().run(&soup.mesh()), Err(PassError::Policy { pass: "clean", .. })));
}

#[test]
fn a_strict_kernel_refuses_with_every_reason() {
    let soup = shapes::two_tetrahedra_on_a_vertex().soup;
    let Err(PassError::Refused(refusal)) =
        Pipeline::default().run_in(Session::begin(&soup.mesh()).with_kernel(KernelKind::HalfEdge))
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
    assert_eq!(compact.fixed.len(), 2 + 2);
}

/// One face becomes two while another goes: the counts are those of before, the faces are not.
#[test]
fn counts_alone_do_not_say_that_nothing_changed() {
    let soup = Soup::generic(4, [vec![], vec![1, 2, 3, 1, 2, 0]]);
    let repaired = Soup::of_mesh(&Pipeline::default().run(&soup.mesh()).unwrap().mesh);
    assert_eq!(reference::broken_postconditions(repaired.vertex_count(), &repaired.faces), [""; 0]);
}

#[test]
fn a_cancelled_pipeline_stops() {
    let stop = Watch::new(|_| ControlFlow::Break(()));
    let soup = Soup::generic(3, [[0, 1, 2]]);
    let result = Pipeline::default().run_in(Session::begin(&soup.mesh()).with_watch(&stop));
    assert!(matches!(result, Err(PassError::Cancelled(_))));
}
