//! Cracks are closed along open edges, and what is whole stays as it is.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

use meshmend_core::{Defect, Element, PolygonMesh};
use meshmend_repair::{Context, Distance, Outcome, Pass, Pipeline, Weld};

fn welded(mesh: &PolygonMesh, epsilon: f64) -> Outcome {
    Weld::within(Distance::Boundary(epsilon)).apply(mesh, &Context::default()).unwrap()
}

fn joined(outcome: &Outcome) -> Vec<[u32; 2]> {
    let vertices = |defect: Defect| {
        [Some(&defect.at), defect.beside.as_ref()].map(|place| place.and_then(Element::vertex).unwrap().0)
    };
    outcome.fixed.iter().map(vertices).collect()
}

/// Triangles with corners of their own, over points in the plane.
fn apart(triangles: &[[[f64; 2]; 3]]) -> PolygonMesh {
    let points: Vec<[f64; 3]> = triangles.iter().flatten().map(|[x, y]| [*x, *y, 0.0]).collect();
    let faces: Vec<[u32; 3]> =
        (0..triangles.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    PolygonMesh::from_triangles(&points, &faces).unwrap()
}

#[test]
fn a_crack_is_closed() {
    let mesh = apart(&[[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]], [[4.01, 0.0], [4.0, 4.0], [0.0, 4.02]]]);
    assert_eq!(joined(&welded(&mesh, 0.05)), [[3, 1], [5, 2]]);
    assert_eq!(joined(&welded(&mesh, 0.015)), [[3, 1]]);
    assert!(welded(&mesh, 0.005).fixed.is_empty());
    let repaired =
        Pipeline::default().with(Weld::within(Distance::BoundaryRelative(0.01))).run(&mesh).unwrap();
    assert_eq!(repaired.mesh.counts().vertices, 4);
    assert_eq!(repaired.mesh.positions()[1], [4.0, 0.0, 0.0], "the lowest keeps its place");
}

#[test]
fn vertices_inside_of_a_surface_stay_although_they_are_near() {
    // A fan of triangles round two inner vertices that are nearer to each other than the distance.
    let ring = [[3.0, 0.0], [0.0, 3.0], [-3.0, 0.0], [0.0, -3.0]];
    let points: Vec<[f64; 3]> =
        ring.iter().chain(&[[0.01, 0.0], [-0.01, 0.0]]).map(|[x, y]| [*x, *y, 0.0]).collect();
    let faces = [[0, 1, 4], [1, 5, 4], [1, 2, 5], [2, 3, 5], [3, 4, 5], [3, 0, 4]];
    let mesh = PolygonMesh::from_triangles(&points, &faces).unwrap();
    assert!(welded(&mesh, 0.5).fixed.is_empty());
    let everywhere = Weld::within(Distance::Absolute(0.5)).apply(&mesh, &Context::default()).unwrap();
    assert_eq!(everywhere.fixed.len(), 1);
}

#[test]
fn no_face_loses_a_corner() {
    // A needle whose short side is shorter than the distance.
    let mesh = apart(&[[[0.0, 0.0], [0.01, 0.0], [0.0, 9.0]]]);
    assert!(welded(&mesh, 0.5).fixed.is_empty());
    // A vertex near both ends of that side is joined to the nearer one alone.
    let near = apart(&[[[0.0, 0.0], [0.01, 0.0], [0.0, 9.0]], [[0.008, -0.001], [-4.0, -5.0], [4.0, -5.0]]]);
    assert_eq!(joined(&welded(&near, 0.5)), [[3, 1]]);
}

#[test]
fn no_chain_is_longer_than_the_distance() {
    let at = |x: f64| [[x, 0.0], [x - 9.0, 9.0 + x], [x - 9.0, 8.0 + x]];
    let mesh = apart(&[at(0.0), at(1.0), at(2.0), at(2.5)]);
    let outcome = welded(&mesh, 1.1);
    let joined = joined(&outcome);
    assert!(joined.contains(&[3, 0]) && joined.contains(&[9, 6]), "{joined:?}");
    assert!(!joined.contains(&[6, 0]), "nearest first, then by ids, and none farther than the distance");
    let chained = Weld::within(Distance::Absolute(1.1)).apply(&mesh, &Context::default()).unwrap();
    assert!(chained.fixed.len() > outcome.fixed.len());
}

#[test]
fn a_distance_of_zero_is_an_exact_weld() {
    let mesh = apart(&[[[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]], [[4.0, 0.0], [4.0, 4.0], [0.0, 4.0]]]);
    let exact = Weld::default().apply(&mesh, &Context::default()).unwrap();
    assert_eq!(joined(&welded(&mesh, 0.0)), joined(&exact));
    let refused = |epsilon| {
        let weld = Weld::within(Distance::Boundary(epsilon));
        weld.apply(&mesh, &Context::default()).unwrap_err().to_string()
    };
    assert!(refused(1e-300).contains("can't be resolved") && refused(f64::NAN).contains("not NaN"));
}

#[test]
fn a_second_run_changes_nothing() {
    let at = |x: f64| [[x, 0.0], [x - 9.0, 9.0 + x], [x - 9.0, 8.0 + x]];
    let mesh = apart(&[at(0.0), at(0.9), at(1.7), at(2.9)]);
    let pipeline = Pipeline::default().with(Weld::within(Distance::Boundary(1.0)));
    let repaired = pipeline.run(&mesh).unwrap();
    assert!(!pipeline.run(&repaired.mesh).unwrap().is_changed());
}
