//! Searches of many runs: threads, the budget and the limit.

#![allow(clippy::unwrap_used, reason = "a case that does not fit is a failed test")]

use meshmend_core::{FaceId, PolygonMesh};
use meshmend_spatial::{
    Budget, Contact, FacePair, IntersectionOptions, Intersections, Surface, intersections,
};

/// Two tori of triangles, one a little beside the other.
fn two_tori() -> PolygonMesh {
    let shape = meshmend_shapes::torus(90, 90).unwrap().triangulated().unwrap();
    let arrays = shape.mesh.to_arrays();
    let count = shape.mesh.counts().vertices as u32;
    let one = shape.mesh.positions();
    let other = one.iter().map(|&[x, y, z]| [x + 0.01, y + 0.02, z + 0.03]);
    let points: Vec<[f64; 3]> = one.iter().copied().chain(other).collect();
    let corners: Vec<u32> =
        arrays.corners.iter().copied().chain(arrays.corners.iter().map(|v| v + count)).collect();
    let starts: Vec<u32> = (0..=corners.len() as u32 / 3).map(|face| 3 * face).collect();
    PolygonMesh::from_polygons(&points, &corners, &starts).unwrap()
}

fn found(mesh: &PolygonMesh, threads: usize, options: IntersectionOptions) -> Intersections {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| intersections(&Surface::of(mesh).unwrap(), options).unwrap())
}

#[test]
fn answers_do_not_depend_on_the_number_of_threads() {
    let mesh = two_tori();
    let all = found(&mesh, 1, IntersectionOptions::default());
    assert!(all.pairs.len() > 300 && all.figures.is_some() && all.complete_to.is_none());
    assert!(all.pairs.is_sorted_by_key(|pair| pair.faces));
    for threads in [2, 3] {
        assert_eq!(found(&mesh, threads, IntersectionOptions::default()), all);
    }
    let limited = found(&mesh, 2, IntersectionOptions { limit: 100, ..IntersectionOptions::default() });
    // Each class has its limit; here nearly all pairs cross.
    let crossing = |found: &Intersections| -> Vec<FacePair> {
        found.pairs.iter().filter(|pair| pair.contact == Contact::FaceFace).copied().collect()
    };
    assert_eq!(crossing(&limited), crossing(&all)[..100]);
    assert_eq!((limited.figures, limited.contacts), (all.figures, all.contacts));
}

#[test]
fn a_search_beyond_its_budget_says_how_far_it_came() {
    let mesh = two_tori();
    let all = found(&mesh, 1, IntersectionOptions::default());
    let options = IntersectionOptions { budget: Budget::Tests(100), ..IntersectionOptions::default() };
    for threads in [1, 3] {
        let stopped = found(&mesh, threads, options);
        assert_eq!((stopped.complete_to, stopped.figures), (Some(FaceId(4095)), None));
        let complete = all.pairs.iter().take_while(|pair| pair.faces[0] <= FaceId(4095));
        assert!(stopped.pairs.iter().eq(complete));
    }
}

#[test]
fn a_search_of_all_at_once_finds_what_one_run_by_run_finds() {
    let mut state = 1_u64;
    let mut below = |end: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) % end
    };
    for round in 0..60 {
        let size = 2 + round % 7;
        let points: Vec<[f64; 3]> = (0..40).map(|_| [(); 3].map(|()| below(size) as f64)).collect();
        // Faces of three to five corners, many of them no simple polygons.
        let starts: Vec<u32> =
            (0..=60).scan(0, |end, _| Some(std::mem::replace(end, *end + 3 + below(3) as u32))).collect();
        let corners: Vec<u32> = (0..starts[60]).map(|_| below(40) as u32).collect();
        let mesh = PolygonMesh::from_polygons(&points, &corners, &starts).unwrap();
        let run_by_run = IntersectionOptions { budget: Budget::Tests(0), ..IntersectionOptions::default() };
        assert_eq!(found(&mesh, 2, IntersectionOptions::default()), found(&mesh, 2, run_by_run), "{round}");
    }
}
