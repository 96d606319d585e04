//! A repair of what was repaired changes nothing, whatever the options are: cases in which it did.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_repair::{
    Distance, Emptying, FaceStorage, PassKind, Pipeline, Plan, Repaired, Side, SplitEdges, TriangulateFaces,
};
use meshmend_testkit::{Soup, oracle};

/// The default plan with some of its options changed.
fn plan(change: impl FnOnce(&mut Plan)) -> Plan {
    let mut plan = Plan::default();
    change(&mut plan);
    plan
}

fn soup(positions: &[[f64; 3]], faces: &[&[u32]]) -> Soup {
    Soup { positions: positions.to_vec(), faces: faces.iter().map(|face| face.to_vec()).collect() }
}

fn bits(repaired: &Repaired) -> Vec<[u64; 3]> {
    repaired.mesh.positions().iter().map(|p| p.map(f64::to_bits)).collect()
}

/// The repair, of which a second one changes nothing.
#[track_caller]
fn final_repair(pipeline: &Pipeline, soup: &Soup) -> Repaired {
    let once = pipeline.run(&soup.mesh()).unwrap();
    let twice = pipeline.run(&once.mesh).unwrap();
    assert_eq!(twice.mesh.faces(), once.mesh.faces());
    assert_eq!(bits(&twice), bits(&once));
    assert!(!twice.is_changed(), "{:?}", twice.passes);
    assert!(twice.provenance.is_same() && twice.removed_faces.is_empty());
    once
}

/// A projective plane of three squares: no diagonal is free, and neither is the middle nor any point halfway to a corner.
#[test]
fn a_star_has_a_centre_of_its_own_however_crowded_it_is() {
    let mut crowded = soup(
        &[
            [0.0; 3],
            [3.0, 0.0, 0.0],
            [0.0, 3.0, 0.0],
            [1.0, 1.0, 0.0],
            [0.5, 0.5, 0.0],
            [2.0, 0.5, 0.0],
            [0.5, 2.0, 0.0],
        ],
        &[&[0, 1, 2, 3], &[0, 1, 3, 2], &[0, 2, 1, 3], &[4, 5, 6]],
    );
    let pipeline = plan(|plan| plan.triangulate.faces = TriangulateFaces::All).pipeline();
    for size in [1.0, f64::MIN_POSITIVE * f64::EPSILON, 1e300] {
        crowded.positions.iter_mut().flatten().for_each(|x| *x *= size);
        let once = final_repair(&pipeline, &crowded);
        let report = oracle::report(&Soup::of_mesh(&once.mesh));
        assert_eq!((report.components, report.euler_characteristic), (2, 2), "{size}");
        crowded.positions.iter_mut().flatten().for_each(|x| *x /= size);
    }
}

/// Three triangles of which two edges come to lie on each other, and are subdivided; any point of theirs is within the
/// tolerance of an end.
#[test]
fn a_created_vertex_is_not_within_the_tolerance_of_another() {
    let short = soup(
        &[[2.0, 1.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [2.0, 1.0, 2.0]],
        &[&[1, 2, 0], &[3, 0, 2], &[3, 2, 4]],
    );
    for distance in [0.0, 0.1, 0.3, 0.49, 0.5, 0.51, 0.7, 0.9].map(Distance::Absolute) {
        let once = final_repair(&plan(|plan| plan.weld.distance = distance).pipeline(), &short);
        assert!(once.mesh.counts().faces >= 3, "{distance:?}: {:?}", once.mesh.counts());
    }
    for part in [0.05, 0.2, 0.25, 0.3] {
        let relative = plan(|plan| plan.weld.distance = Distance::Relative(part)).pipeline();
        assert!(final_repair(&relative, &short).mesh.counts().faces >= 3);
    }
}

/// Edges whose ends are neighbours among numbers: no point between them is free.
#[test]
fn a_created_vertex_has_a_place_of_its_own_however_short_the_edge_is() {
    for (low, high) in [
        (1.0f64, 1.0f64.next_up()),
        (0.0, f64::from_bits(1)),
        (-f64::from_bits(1), 0.0),
        (-1e6, (-1e6f64).next_up()),
    ] {
        let at = |place: [u8; 3]| place.map(|up| if up == 1 { high } else { low });
        let tiny = soup(
            &[[0, 1, 1], [1, 0, 1], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(at),
            &[&[4, 0, 3], &[1, 0, 3], &[1, 2, 0], &[0, 2, 1]],
        );
        final_repair(&Pipeline::default(), &tiny);
    }
}

/// A cracked tetrahedron and a loose triangle upon one of its faces, which is its double once the solid is turned.
#[test]
fn what_is_turned_outward_and_repeats_another_face_goes_at_once() {
    let cracked = soup(
        &[
            [2.0, 1.0, 0.0],
            [2.0, 2.0, 0.0],
            [0.0, 2.0, 0.0],
            [1.0, 0.0, 1.0],
            [1.0, 0.0, 1.0],
            [2.0, 2.0, 0.0],
            [2.0, 2.0, 0.0],
        ],
        &[&[2, 4, 0], &[3, 5, 0], &[2, 6, 0], &[2, 0, 1], &[3, 2, 1]],
    );
    for side in [Side::Outward, Side::OutwardNested] {
        for pass in [None, Some(PassKind::Triangulate), Some(PassKind::Compact)] {
            let plan = pass.map_or_else(Plan::default, |pass| Plan::default().without(pass));
            let plan = Plan { orient: meshmend_repair::Orient { side, ..Default::default() }, ..plan };
            let once = final_repair(&plan.pipeline(), &cracked);
            assert_eq!((once.mesh.counts().faces, once.removed_faces.len()), (4, 1));
        }
    }
}

/// What `pinch-only` leaves is oriented over the patches that are left.
#[test]
fn pinched_vertices_come_apart_and_the_faces_that_are_left_agree() {
    let pinched = soup(
        &[
            [4.0, 4.0, 0.0],
            [2.0, 4.0, 0.0],
            [1.0, 4.0, 0.0],
            [0.0, 1.0, 0.0],
            [2.0, 4.0, 0.0],
            [3.0, 3.0, 0.0],
        ],
        &[&[0, 1, 2], &[0, 2, 3], &[0, 3, 4], &[0, 4, 5], &[4, 5, 2]],
    );
    let once = final_repair(&plan(|plan| plan.split.edges = SplitEdges::PinchOnly).pipeline(), &pinched);
    let report = oracle::report(&Soup::of_mesh(&once.mesh));
    assert!(report.orientable && report.consistently_oriented, "{report:?}");
}

/// Two faces that are the same as welded, and the same as stored once that is stored.
#[test]
fn faces_that_become_the_same_as_stored_go_at_once() {
    let doubled = soup(&[[1.0; 3], [1.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]], &[&[3, 2, 0], &[2, 1, 3]]);
    let once = final_repair(&Plan::default().without(PassKind::Orient).pipeline(), &doubled);
    assert_eq!(once.mesh.counts().faces, 1);
    let far = soup(
        &[
            [1000002.0, -999998.0, 0.0],
            [1000001.0, -999999.0, 0.0],
            [1000000.0, -1000000.0, 1.0],
            [1000001.0, -999999.0, 1.0],
            [1000002.0, -1000000.0, 1.0],
            [1000002.0, -1000000.0, 1.0],
        ],
        &[&[5, 1, 2], &[5, 0, 3], &[1, 2, 0], &[5, 3, 1], &[4, 0, 1]],
    );
    final_repair(&Plan::default().without(PassKind::Split).pipeline(), &far);
}

/// A closed solid that touches another one is stored apart from it, and is so the second time: nothing is changed, and
/// the vertices that welding joins and `split` takes apart again are told as stitched.
#[test]
fn what_is_stitched_and_comes_apart_again_is_no_change() {
    let tetrahedron: [&[u32]; 4] = [&[0, 2, 1], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]];
    let mut two = soup(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], &tetrahedron);
    let second = tetrahedron.map(|face| face.iter().map(|v| v + 4).collect::<Vec<u32>>());
    two.faces.extend(second);
    two.positions.extend(two.positions.clone().into_iter().map(|p| p.map(|x| -x)));
    let once = Pipeline::default().run(&two.mesh()).unwrap();
    assert_eq!((once.is_changed(), once.stitched), (false, 1));
    assert!(once.passes.iter().all(|pass| !pass.is_changed && pass.fixed.is_empty()));
    // Each face with points of its own, as STL stores it.
    let apart = Soup {
        positions: two.faces.iter().flatten().map(|&v| two.positions[v as usize]).collect(),
        faces: (0..8).map(|f| vec![3 * f, 3 * f + 1, 3 * f + 2]).collect(),
    };
    let stl = Pipeline::default().storing(FaceStorage::apart()).run(&apart.mesh()).unwrap();
    assert_eq!((stl.is_changed(), stl.stitched, stl.mesh.counts().vertices), (false, 17, 8));
    assert!(Pipeline::default().run(&apart.mesh()).unwrap().is_changed());
}

/// The first vertex, which no face uses, is joined to the second, which is then where the first was: the box grows, and with
/// it the tolerance, so that the last two are within it.
#[test]
fn a_tolerance_that_grows_with_its_box_is_gone_by_at_once() {
    let strip = soup(&[[0.0, 1.0, 1.0], [1.0; 3], [8.0, 1.0, 1.0], [8.0, 2.81, 1.0]], &[&[1, 2, 3]]);
    // `split` puts a vertex back to where the lowest one of its faces was stored.
    let pipeline =
        plan(|plan| plan.weld.distance = Distance::Relative(0.25)).without(PassKind::Split).pipeline();
    let once = final_repair(&pipeline.on_emptying(Emptying::Allow), &strip);
    assert_eq!(once.mesh.counts().faces, 0);
}

/// Without `clean`, faces that come back to a vertex may be subdivided in each round: that has an end all the same.
#[test]
fn rounds_have_an_end_whatever_is_left_out() {
    let points = [[3.0, 1.0, 1.0], [3.0, 2.0, 3.0], [1.0, 0.0, 2.0]];
    let names: [[usize; 3]; 11] = [
        [0, 1, 2],
        [0, 0, 1],
        [0, 1, 2],
        [0, 1, 2],
        [0, 2, 0],
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
        [2, 1, 0],
        [1, 0, 0],
        [0, 0, 2],
    ];
    let apart = Soup {
        positions: names.iter().flatten().map(|&v| points[v].map(|x| x + 1e6)).collect(),
        faces: (0..11).map(|f| vec![3 * f, 3 * f + 1, 3 * f + 2]).collect(),
    };
    let repair = |(edges, distance, storage): (SplitEdges, Distance, &FaceStorage)| {
        let mut plan = Plan::default().without(PassKind::Clean);
        (plan.split.edges, plan.weld.distance) = (edges, distance);
        plan.triangulate.faces = TriangulateFaces::All;
        let repaired = plan.pipeline().storing(storage.clone()).run(&apart.mesh()).unwrap();
        assert!(repaired.mesh.counts().corners < 1000, "{edges:?} {distance:?} {storage:?}");
    };
    for edges in [SplitEdges::Sheets, SplitEdges::Cut, SplitEdges::PinchOnly] {
        for distance in [Distance::Exact, Distance::Absolute(1.0), Distance::Relative(0.25)] {
            for storage in &[FaceStorage::default(), FaceStorage::apart()] {
                repair((edges, distance, storage));
            }
        }
    }
}
