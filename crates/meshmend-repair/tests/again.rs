//! A repair of what was repaired changes nothing, whatever the options are: cases in which it did.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use meshmend_repair::{Distance, Pipeline, Plan, Repaired, TriangulateFaces};
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
