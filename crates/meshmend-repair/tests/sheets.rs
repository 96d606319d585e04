//! How what meets at an edge of more than two sides comes apart, on meshes small enough to draw.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use std::collections::{BTreeMap, BTreeSet};

use meshmend_repair::{NonOrientable, Pipeline, Plan, SplitEdges};
use meshmend_testkit::{Soup, oracle, shapes};

/// Two fans all the way round the lower end of an upright edge that both have a spoke there: each has its two faces at
/// the edge in neighbouring quarters. Next to each face lies one of the other fan as well, with solid between them if
/// there were any.
#[test]
fn a_sheet_stays_whole_where_another_one_is_nearer() {
    let rims = [[[1, 0, 0], [1, 1, -1], [0, 1, 0]], [[-1, 0, 0], [-1, -1, -1], [0, -1, 0]]];
    let points = [[0, 0, 0], [0, 0, 1]].into_iter().chain(rims.into_iter().flatten());
    let positions = points.map(|p: [i32; 3]| p.map(f64::from)).collect();
    let fan = |first: u32| {
        let rim = [1, first, first + 1, first + 2, 1];
        rim.windows(2).map(|side| vec![0, side[0], side[1]]).collect::<Vec<_>>()
    };
    let soup = Soup { positions, faces: [fan(2), fan(5)].concat() };
    let result = Soup::of_mesh(&Pipeline::default().run(&soup.mesh()).unwrap().mesh);
    let vertices = |faces: &[Vec<u32>]| faces.iter().flatten().copied().collect::<BTreeSet<u32>>();
    let fans = [vertices(&result.faces[..4]), vertices(&result.faces[4..])];
    assert_eq!(fans.each_ref().map(BTreeSet::len), [5, 5]);
    assert!(fans[0].is_disjoint(&fans[1]) && result.faces.len() == 8);
}

/// The outward sides of unit cubes.
fn solid(cubes: &[[u32; 3]]) -> Soup {
    let mut vertex: BTreeMap<[u32; 3], u32> = BTreeMap::new();
    let mut faces = Vec::new();
    for &cube in cubes {
        for (axis, is_far) in (0..3).flat_map(|axis| [(axis, false), (axis, true)]) {
            let step = if is_far { 1 } else { u32::MAX };
            let mut beside = cube;
            beside[axis] = beside[axis].wrapping_add(step);
            if cubes.contains(&beside) {
                continue;
            }
            let corner = |[u, v]: [u32; 2]| {
                let mut corner = cube;
                corner[axis] += u32::from(is_far);
                corner[(axis + 1) % 3] += u;
                corner[(axis + 2) % 3] += v;
                corner
            };
            let mut corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(corner);
            if !is_far {
                corners.reverse();
            }
            let mut name = |corner| {
                let next = vertex.len() as u32;
                *vertex.entry(corner).or_insert(next)
            };
            faces.push(corners.map(&mut name).to_vec());
        }
    }
    let mut positions = vec![[0.0; 3]; vertex.len()];
    vertex.iter().for_each(|(corner, &v)| positions[v as usize] = corner.map(f64::from));
    Soup { positions, faces }
}

/// A row of cubes round a hole whose ends touch along an edge: solid lies between two faces of one end, not between
/// the ends.
#[test]
fn a_solid_that_touches_itself_comes_apart_whichever_way_its_faces_look() {
    let row = [[1, 1], [0, 1], [0, 2], [0, 3], [1, 3], [2, 3], [2, 2]];
    let mut soup = solid(&row.map(|[x, y]| [x, y, 0]));
    assert_eq!(oracle::report(&soup).non_manifold_edges, 1);
    for look in ["outward", "inward"] {
        let result = Soup::of_mesh(&Pipeline::default().run(&soup.mesh()).unwrap().mesh);
        let report = oracle::report(&result);
        assert_eq!((report.components, report.euler_characteristic), (1, 2), "{look}");
        assert!(report.manifold && report.closed, "{look}");
        soup.faces.iter_mut().for_each(|face| face.reverse());
    }
}

#[test]
fn a_seam_is_opened_also_where_other_edges_are_left_alone() {
    let mut plan = Plan::default();
    plan.orient.non_orientable = NonOrientable::Cut;
    plan.split.edges = SplitEdges::PinchOnly;
    let band = shapes::moebius_band(6, 1, shapes::Tiles::Quads).soup;
    let result = plan.pipeline().run(&band.mesh()).unwrap().mesh;
    let report = oracle::report(&Soup::of_mesh(&result));
    assert!(report.orientable && report.consistently_oriented);
}
