//! All figures of shapes whose figures are known, and of random soups.

use meshmend_core::{Build, Connectivity, DefectKind, EdgeUse, Element, Watch};
use serde_json::{Value, json};

use super::*;
use crate::Betti;
use crate::shapes::{self, Random, Shape};

#[track_caller]
fn assert_surface(shape: &Shape, elements: [u64; 3], name: &str) {
    let report = shape.report();
    assert_eq!([report.vertices, report.edges, report.faces], elements, "{name}");
    assert!(report.manifold);
    let names: Vec<_> = report.component_kinds.iter().map(|k| k.name.as_deref()).collect();
    assert_eq!(names, [Some(name)]);
}

#[test]
fn the_platonic_solids_of_table_1() {
    let cube = Shape::of(&[
        &[0, 3, 2, 1],
        &[4, 5, 6, 7],
        &[0, 1, 5, 4],
        &[1, 2, 6, 5],
        &[2, 3, 7, 6],
        &[3, 0, 4, 7],
    ]);
    let icosahedron = icosahedron();
    assert_surface(&shapes::tetrahedron(), [4, 6, 4], "sphere");
    assert_surface(&cube, [8, 12, 6], "sphere");
    assert_surface(&dual(&cube), [6, 12, 8], "sphere");
    assert_surface(&icosahedron, [12, 30, 20], "sphere");
    assert_surface(&dual(&icosahedron), [20, 30, 12], "sphere");
}

fn icosahedron() -> Shape {
    let (top, upper, lower, bottom) = (0, |i| 1 + i % 5, |i| 6 + i % 5, 11);
    let column = |i: u32| {
        [
            vec![top, upper(i), upper(i + 1)],
            vec![upper(i), lower(i), upper(i + 1)],
            vec![upper(i + 1), lower(i), lower(i + 1)],
            vec![lower(i), bottom, lower(i + 1)],
        ]
    };
    Shape((0..5).flat_map(column).collect())
}

/// A closed, consistently oriented surface with a vertex for each face and a face for each vertex.
fn dual(shape: &Shape) -> Shape {
    let kernel = shape.kernel();
    let round = |vertex| {
        let first = kernel.vertex_corners(vertex).next().unwrap();
        let next = |&corner: &_| kernel.across(kernel.prev_corner(corner)).filter(|&corner| corner != first);
        let corners = std::iter::successors(Some(first), next);
        corners.map(|corner| kernel.corner_face(corner).0).collect()
    };
    Shape(kernel.vertices().map(round).collect())
}

#[test]
fn surfaces_by_name() {
    assert_surface(&shapes::torus(4, 3), [12, 24, 12], "torus");
    assert_surface(&shapes::klein_bottle(4, 5), [20, 40, 20], "Klein bottle");
    assert_surface(&shapes::projective_plane(), [6, 15, 10], "projective plane");
    assert_surface(&shapes::moebius_band(5), [10, 15, 5], "Möbius band");
    assert_surface(&shapes::annulus(6), [12, 18, 6], "annulus");
    assert_surface(&Shape::of(&[&[0, 1, 2, 3, 4, 5]]), [6, 6, 1], "disc");
    // One face, glued to itself along an edge both of whose sides are its own.
    assert_surface(&Shape::of(&[&[0, 1, 2, 0, 3, 4, 5, 3]]), [6, 7, 1], "annulus");
}

#[test]
fn what_has_faces_and_no_edge_of_degree_one_is_closed() {
    for closed in [shapes::tetrahedron(), shapes::klein_bottle(4, 5), shapes::sphere_with_membrane()] {
        assert!(closed.report().closed, "{closed:?}");
    }
    for open in [shapes::annulus(6), shapes::bow_tie(), Shape::of(&[&[0, 1]])] {
        assert!(!open.report().closed, "{open:?}");
    }
}

#[test]
fn nothing_is_manifold_and_open() {
    let report = Shape::of(&[]).report();
    assert!(report.manifold && !report.closed && report.consistently_oriented && report.orientable);
    assert_eq!((report.boundary_loops, report.genus, report.cross_caps), (Some(0), None, None));
    assert_eq!(report.betti, Betti { z2: Some([0; 3]), q: Some([0; 3]) });
    assert_eq!(report.undefined.iter().map(|u| u.reason).collect::<Vec<_>>(), [Reason::NoFaces; 2]);
}

#[test]
fn totals_sum_over_the_components_that_have_the_figure() {
    let parts =
        [shapes::torus(3, 3), shapes::klein_bottle(4, 4), shapes::torus(3, 4), shapes::moebius_band(5)];
    let report = Shape::side_by_side(&parts).report();
    assert_eq!((report.boundary_loops, report.genus, report.cross_caps), (Some(1), Some(2), Some(3)));
    assert!(report.undefined.is_empty() && report.manifold && !report.orientable);
    assert_eq!((report.components, report.non_orientable_patches), (4, 2));
}

#[test]
fn one_bad_component_leaves_the_totals_undefined() {
    let report = Shape::side_by_side(&[shapes::tetrahedron(), shapes::bow_tie()]).report();
    assert!(!report.manifold);
    assert_eq!((report.boundary_loops, report.genus, report.cross_caps), (None, None, None));
    assert!(report.undefined.iter().all(|u| u.reason == Reason::NonManifoldComponent));
    assert_eq!(report.undefined.len(), 3);
    assert_eq!(report.non_manifold_vertices, NonManifoldVertexCounts { pinched: 1, singular: 0 });
}

#[test]
fn the_json_says_what_is_absent() {
    let value = serde_json::to_value(shapes::bow_tie().report()).unwrap();
    assert_eq!(value["genus"], Value::Null);
    assert_eq!(value["undefined"][1], json!({"figure": "genus", "reason": "non-manifold-component"}));
    assert_eq!(value["betti"], json!({"z2": [1, 0, 0], "q": [1, 0, 0]}));
    assert_eq!(value["betti_unknown"], Value::Null);
    assert_eq!(value["non_manifold_vertices"], json!({"pinched": 1, "singular": 0}));
    assert_eq!(value["duplicate_faces"], json!({"same": 0, "opposite": 0}));
    assert_eq!(value["instigators"]["f_n"], 2);
    assert_eq!(value["component_kinds"][0]["name"], Value::Null);
    assert!(value.get("defects").is_none());
}

#[test]
fn names_orders_and_first_corners_do_not_matter() {
    let mut random = Random(21);
    for round in 0..1000 {
        let shape = Shape(random.soup(4 + round % 7, 12, 7));
        let original = figures(&shape);
        let names = random.permutation(12);
        let order = random.permutation(shape.0.len());
        let renamed = order.iter().map(|&face| {
            let mut face: Vec<u32> = shape.0[face as usize].iter().map(|&v| names[v as usize]).collect();
            let places = random.below(face.len());
            face.rotate_left(places);
            face
        });
        let mut renamed = figures(&Shape(renamed.collect()));
        // How many of the vertices are in no face depends on how many there are.
        renamed["unreferenced_vertices"] = original["unreferenced_vertices"].clone();
        assert_eq!(original, renamed, "{shape:?}");
    }
}

/// The report but for the vertices and the order that it names.
fn figures(shape: &Shape) -> Value {
    let mut value = serde_json::to_value(shape.report()).unwrap();
    let kinds = value["component_kinds"].as_array_mut().unwrap();
    kinds.iter_mut().for_each(|kind| kind["first_vertex"] = Value::Null);
    kinds.sort_by_key(Value::to_string);
    value
}

#[test]
fn figures_fit_together_on_random_soups() {
    let mut random = Random(22);
    for round in 0..2000 {
        let report = Shape(random.soup(4 + round % 9, 14, 8)).report();
        let betti = report.betti.z2.unwrap().map(|b| b as i64);
        assert_eq!(betti[0] - betti[1] + betti[2], report.euler_characteristic);
        let i = report.instigators;
        assert_eq!(i.v_c - i.e_n, report.components);
        assert_eq!(i.e_c - i.f_n.unwrap(), report.betti.z2.unwrap()[1]);
        let no_bad_element = report.non_manifold_edges == 0
            && report.non_manifold_vertices == NonManifoldVertexCounts { pinched: 0, singular: 0 };
        assert_eq!(report.manifold, no_bad_element);
        assert_eq!(report.boundary_loops.is_some(), report.manifold);
        for kind in report.component_kinds.iter().filter(|kind| kind.manifold) {
            let twice = 2 * kind.genus.unwrap_or(0) + kind.cross_caps.unwrap_or(0);
            let holes = kind.boundary_loops.unwrap();
            assert_eq!(2 - kind.euler_characteristic, (twice + holes) as i64);
            assert_eq!(kind.closed, holes == 0);
        }
    }
}

#[test]
fn a_shortest_witness_is_given_when_it_is_asked_for() {
    let shape = shapes::klein_bottle(5, 12);
    let mesh = shape.mesh();
    let kernel = EdgeUse::build(mesh.complex()).unwrap();
    let [usual, shortest] = [Witness::BreadthFirst, Witness::Shortest].map(|witness| {
        let report = topology_watched(&kernel, &mesh, witness, &Watch::NOBODY).unwrap();
        assert!(report.witness == witness && report.undefined.iter().all(|u| u.figure == "genus"));
        let defect = report.defects.of_kind(DefectKind::NonOrientablePatch).next().unwrap();
        let Element::Strip(strip) = defect.at else { panic!("{defect:?}") };
        strip.faces.len()
    });
    assert!(usual >= 6 && shortest == 6);
}

#[test]
fn a_coordinate_that_is_no_number_is_told() {
    let mesh = shapes::tetrahedron().mesh();
    let mut positions = mesh.positions().to_vec();
    positions[2][1] = f64::INFINITY;
    let mesh = mesh.with_positions(positions).unwrap();
    let report = topology(&EdgeUse::build(mesh.complex()).unwrap(), &mesh);
    assert_eq!(report.non_finite_vertices, 1);
}

/// Told without a table of edges, and by the report.
#[track_caller]
fn assert_oriented_surface_is_told(vertices: u32, faces: &[&[u32]]) -> bool {
    let mesh = crate::shapes::mesh(vertices, faces);
    let report = topology(&EdgeUse::build(mesh.complex()).unwrap(), &mesh);
    let repeats = report.duplicate_faces.same + report.duplicate_faces.opposite;
    let wrong =
        report.degenerate_faces + report.repeated_corner_faces + report.unreferenced_vertices + repeats;
    let is_surface = report.manifold && report.consistently_oriented && report.faces > 0 && wrong == 0;
    let expected = is_surface && faces.iter().all(|face| face.len() == 3);
    assert_eq!(mesh.complex().is_oriented_surface(), expected, "{faces:?}");
    expected
}

#[test]
fn oriented_surfaces_are_told_without_edges() {
    let mut random = Random(17);
    let mut seen = 0;
    for _ in 0..4000 {
        let soup = random.soup(5, 5, 4);
        seen += usize::from(assert_oriented_surface_is_told(
            5,
            &soup.iter().map(Vec::as_slice).collect::<Vec<_>>(),
        ));
    }
    // Closed and open fans of few and of many corners, in any order, with one face more, less, turned, or put elsewhere.
    for count in [2, 3, 5, 11, 12, 13, 14, 40u32] {
        for case in 0..60 {
            let mut fan: Vec<Vec<u32>> = (0..count).map(|i| vec![count, i, (i + 1) % count]).collect();
            if case % 2 == 1 {
                fan.extend((0..count).map(|i| vec![count + 1, (i + 1) % count, i]));
            }
            match case / 2 % 6 {
                0 => {}
                1 => drop(fan.remove(random.below(count as usize))),
                2 => fan[random.below(count as usize)].reverse(),
                3 => fan.push(vec![count, 0, count + 2]),
                4 => fan.push(fan[0].clone()),
                _ => fan[0][1] = count + 2,
            }
            let order = random.permutation(fan.len());
            let mut fan: Vec<Vec<u32>> = order.iter().map(|&at| fan[at as usize].clone()).collect();
            fan.iter_mut().for_each(|face| face.rotate_left(random.below(3)));
            let used = fan.iter().flatten().max().map_or(0, |&most| most + 1);
            let faces: Vec<&[u32]> = fan.iter().map(Vec::as_slice).collect();
            seen += usize::from(assert_oriented_surface_is_told(used, &faces));
        }
    }
    assert!(seen > 100, "{seen}");
}
