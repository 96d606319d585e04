//! Each shape is what it says: its figures are held against what `topology` finds, and its places against geometry.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use std::collections::BTreeSet;

use meshmend_core::{Build, EdgeUse, FaceTable, Id, PolygonMesh};
use meshmend_shapes::*;
use meshmend_topology::{TopologyReport, topology};

fn report(shape: &Shape) -> TopologyReport {
    topology(&EdgeUse::build(shape.mesh.complex()).unwrap(), &shape.mesh)
}

#[track_caller]
fn assert_true(shape: &Shape) {
    let (found, truth) = (report(shape), &shape.truth);
    let name = &shape.name;
    let numbers = |list: [usize; 3]| list.map(|n| n as u64);
    let figure = |value: Option<usize>| value.map(|n| n as u64);
    assert_eq!(
        [found.vertices, found.edges, found.faces],
        numbers([truth.vertices, truth.edges, truth.faces]),
        "{name}"
    );
    assert_eq!(found.euler_characteristic, truth.euler_characteristic(), "{name}");
    assert_eq!(found.components, truth.components as u64, "{name}");
    assert_eq!((found.manifold, found.orientable), (truth.manifold, truth.orientable), "{name}");
    let surface = (figure(truth.boundary_loops), figure(truth.genus), figure(truth.cross_caps));
    assert_eq!((found.boundary_loops, found.genus, found.cross_caps), surface, "{name}");
    let betti = (Some(numbers(truth.betti_z2)), Some(numbers(truth.betti_q)));
    assert_eq!((found.betti.z2, found.betti.q), betti, "{name}");
    assert_eq!(
        found.unreferenced_vertices + found.degenerate_faces + found.duplicate_faces.same,
        0,
        "{name}"
    );
}

/// Shapes of every kind in small sizes.
fn small() -> Vec<Shape> {
    let mut shapes: Vec<Shape> =
        NAMED_SHAPES.iter().map(|generator| generator.make(&Sizes::default()).unwrap()).collect();
    for n in 1..=4 {
        shapes.extend([book(n), nested_pages(n), umbrellas(n), fan(n), strip(n)].map(Result::unwrap));
        shapes.extend([polygon(n + 2), wrapped_disc(n), foam(n, 2, 1), disc(n, 3)].map(Result::unwrap));
        shapes.extend([torus(3, n + 2), klein_bottle(n + 2, 3), annulus(3, n)].map(Result::unwrap));
        shapes.extend([moebius_band(3, n), pinched_torus(2, n + 2)].map(Result::unwrap));
    }
    for (holes, n) in (0..=2).flat_map(|holes| (1..=3).map(move |n| (holes, n))) {
        shapes.extend((0..=3).map(|genus| surface(Closed::Handles(genus), holes, n).unwrap()));
        shapes.extend((1..=3).map(|caps| surface(Closed::CrossCaps(caps), holes, n).unwrap()));
    }
    shapes
}

#[test]
fn every_shape_is_what_it_says() {
    small().iter().for_each(assert_true);
    assert_true(&out_and_back(5).unwrap());
}

#[test]
fn refining_and_cutting_into_triangles_change_the_counts_alone() {
    for shape in small() {
        let refined = shape.refined().unwrap();
        assert_true(&refined);
        let faces = refined.mesh.faces();
        assert!(faces.faces().all(|face| faces.face_vertices(face).len() == 4));
        for triangles in [shape.triangulated().unwrap(), refined.triangulated().unwrap()] {
            assert_true(&triangles);
            assert!(triangles.mesh.faces().is_all_triangles());
        }
    }
}

#[test]
fn no_two_vertices_coincide() {
    let embedded = |shape: &&Shape| shape.truth.manifold && shape.truth.orientable;
    let refined = small().iter().filter(embedded).map(|shape| shape.refined().unwrap()).collect::<Vec<_>>();
    for shape in small().into_iter().chain(refined) {
        let key = |point: &[f64; 3]| point.map(|x| (x + 0.0).to_bits());
        let places: BTreeSet<_> = shape.mesh.positions().iter().map(key).collect();
        assert_eq!(places.len(), shape.truth.vertices, "{}", shape.name);
        assert!(shape.mesh.positions().iter().flatten().all(|x| x.is_finite()), "{}", shape.name);
    }
}

#[test]
fn no_triangle_is_degenerate() {
    for shape in small() {
        let triangles = shape.triangulated().unwrap().mesh;
        for corners in corners(&triangles) {
            let [a, b, c] = corners;
            let normal = cross(minus(b, a), minus(c, a));
            assert!(normal.iter().any(|x| x.abs() > 1e-9), "{} {corners:?}", shape.name);
        }
    }
}

/// Six times the volume, by the divergence theorem: only right if every face looks outward.
fn six_volumes(mesh: &PolygonMesh) -> f64 {
    corners(mesh).iter().map(|&[a, b, c]| dot(a, cross(b, c))).sum()
}

#[test]
fn a_slab_encloses_its_cubes() {
    for (genus, n) in (0..=4usize).flat_map(|genus| (1..=3).map(move |n| (genus, n))) {
        let slab = surface(Closed::Handles(genus), 0, n).unwrap().triangulated().unwrap();
        let cubes = 3 * (2 * genus.max(1) + 1) - genus;
        assert!((six_volumes(&slab.mesh) - 6.0 * cubes as f64).abs() < 1e-9, "genus {genus}, n {n}");
        let area: f64 =
            corners(&slab.mesh).iter().map(|&[a, b, c]| length(cross(minus(b, a), minus(c, a)))).sum();
        let squares = 8 * (2 * genus.max(1) + 1) + 6 + 2 * genus;
        assert!((area - 2.0 * squares as f64).abs() < 1e-9, "genus {genus}, n {n}");
    }
}

#[test]
fn solids_look_outward() {
    let golden = (1.0 + 5f64.sqrt()) / 2.0;
    let cases =
        [(tetrahedron(), 16.0), (cube(), 6.0), (octahedron(), 8.0), (icosahedron(), 40.0 * golden * golden)];
    for (shape, volumes) in cases {
        let shape = shape.unwrap().triangulated().unwrap();
        assert!((six_volumes(&shape.mesh) - volumes).abs() < 1e-9, "{}", shape.name);
    }
    assert!(six_volumes(&dodecahedron().unwrap().triangulated().unwrap().mesh) > 0.0);
    let ring = torus(64, 64).unwrap().triangulated().unwrap();
    let smooth = 2.0 * std::f64::consts::PI.powi(2) * 3.0;
    assert!((six_volumes(&ring.mesh) / 6.0 - smooth).abs() < 0.01 * smooth);
}

#[test]
fn a_pentagon_of_the_dodecahedron_is_flat_and_regular() {
    let mesh = dodecahedron().unwrap().mesh;
    for face in mesh.faces().faces() {
        let points: Vec<[f64; 3]> =
            mesh.faces().face_vertices(face).iter().map(|v| mesh.position(*v)).collect();
        let side = |i: usize| length(minus(points[(i + 1) % 5], points[i]));
        assert!((0..5).all(|i| (side(i) - side(0)).abs() < 1e-9));
        let normal = cross(minus(points[1], points[0]), minus(points[2], points[0]));
        assert!((3..5).all(|i| dot(normal, minus(points[i], points[0])).abs() < 1e-9));
    }
}

#[test]
fn names_are_found_and_are_unlike() {
    let names: BTreeSet<_> = NAMED_SHAPES.iter().map(|generator| generator.name).collect();
    assert_eq!(names.len(), NAMED_SHAPES.len());
    for generator in NAMED_SHAPES {
        assert_eq!(NamedShape::from_name(generator.name).unwrap().name, generator.name);
    }
    assert!(NamedShape::from_name("teapot").is_none());
}

#[test]
fn sizes_are_those_that_are_given() {
    let make = |name: &str, sizes: Sizes| NamedShape::from_name(name).unwrap().make(&sizes);
    let book = make("book", Sizes { count: Some(9), ..Sizes::default() }).unwrap();
    assert_eq!(book.truth.faces, 9);
    let torus = make("torus", Sizes { resolution: Some(5), ..Sizes::default() }).unwrap();
    assert_eq!(torus.truth.vertices, 25);
    let sizes = Sizes { genus: Some(2), holes: Some(3), resolution: Some(1), ..Sizes::default() };
    let pierced = make("surface", sizes).unwrap();
    assert_eq!((pierced.truth.genus, pierced.truth.boundary_loops), (Some(2), Some(3)));
    let one_sided = make("surface", Sizes { cross_caps: Some(4), ..Sizes::default() }).unwrap();
    assert_eq!(one_sided.truth.cross_caps, Some(4));
}

#[test]
fn what_cannot_be_made_is_refused() {
    let make = |name: &str, sizes: Sizes| NamedShape::from_name(name).unwrap().make(&sizes).unwrap_err();
    let none = Sizes::default();
    let wrong = make("cube", Sizes { genus: Some(1), ..none });
    assert_eq!(wrong.to_string(), "`cube` has no genus");
    let wrong = make("surface", Sizes { genus: Some(1), cross_caps: Some(1), ..none });
    assert_eq!(wrong, ShapeError::TwoKinds);
    assert_eq!(wrong.to_string(), "a surface has a genus or cross-caps, not both");
    let wrong = make("torus", Sizes { resolution: Some(2), ..none });
    assert_eq!(wrong.to_string(), "the number of cells round has to be at least 3, but is 2");
    for (name, sizes) in [
        ("surface", Sizes { cross_caps: Some(0), ..none }),
        ("surface", Sizes { resolution: Some(0), ..none }),
        ("book", Sizes { count: Some(0), ..none }),
        ("three-hemispheres", Sizes { resolution: Some(2), ..none }),
        ("foam", Sizes { resolution: Some(0), ..none }),
    ] {
        assert!(matches!(make(name, sizes), ShapeError::TooSmall { .. }), "{name}");
    }
}

/// No size, however large, makes a generator panic or fill the memory.
#[test]
fn the_too_large_is_refused_before_it_is_made() {
    let huge = [1 << 31, 1 << 40, usize::MAX];
    for (generator, size) in NAMED_SHAPES.iter().flat_map(|generator| huge.map(|size| (generator, size))) {
        for (parameter, _) in generator.parameters() {
            let mut sizes = Sizes::default();
            match parameter {
                Parameter::Resolution => sizes.resolution = Some(size),
                Parameter::Count => sizes.count = Some(size),
                Parameter::Genus => sizes.genus = Some(size),
                Parameter::CrossCaps => sizes.cross_caps = Some(size),
                Parameter::Holes => sizes.holes = Some(size),
            }
            let refused = generator.make(&sizes).unwrap_err();
            assert!(matches!(refused, ShapeError::TooLarge(_)), "{} {refused}", generator.name);
        }
    }
    assert!(matches!(out_and_back(usize::MAX), Err(ShapeError::TooLarge(_))));
}

/// What would be too large after all refinements is refused before the first.
#[test]
fn too_many_refinements_are_refused_before_the_first() {
    for generator in NAMED_SHAPES {
        let shape = generator.make(&Sizes::default()).unwrap();
        for times in [15, 16, 31, 32, 40, 63, 64, 1 << 20, 1 << 32, usize::MAX] {
            let refused = shape.refined_times(times).unwrap_err();
            assert!(matches!(refused, ShapeError::TooLarge(_)), "{} {times}: {refused}", generator.name);
        }
        let (once, twice) = (shape.refined_times(1).unwrap(), shape.refined().unwrap().refined().unwrap());
        assert_eq!(once.name, shape.refined().unwrap().name);
        assert_eq!(shape.refined_times(2).unwrap().truth, twice.truth);
        assert_eq!(shape.refined_times(0).unwrap().truth, shape.truth);
    }
}

fn corners(mesh: &PolygonMesh) -> Vec<[[f64; 3]; 3]> {
    let faces: &FaceTable = mesh.faces();
    let points = |face| {
        let vertices = faces.face_vertices(face);
        [0, 1, 2].map(|i| mesh.positions()[vertices[i].index()])
    };
    faces.faces().map(points).collect()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
