//! Mended slivers beside the executable specification, and what mending keeps.
//!
//! `slivers.jsonl` has a mesh a line with its steps, each of which the specification allows where it is made, and with the
//! slivers that are left, for none of which it allows a step, each with its reason. `MESHMEND_SLIVERS` names a file of more
//! such lines.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

mod shared;

use meshmend_core::{Build, EdgeUse, PolygonMesh};
use meshmend_spatial::{MendedSlivers, NoAttributes, SliverMend, SliverTask, mend_slivers};
use meshmend_topology::topology;
use proptest::prelude::*;
use serde_json::{Value, json};

fn mended(mesh: &PolygonMesh, aspect: f64, reach: f64) -> MendedSlivers {
    let task = SliverTask { mesh, aspect, reach, stood_for: &[], attributes: &NoAttributes };
    mend_slivers(&task, &|| true).unwrap()
}

/// The faces that there are after all steps.
fn faces_after(mesh: &PolygonMesh, mended: &MendedSlivers) -> Vec<Vec<u32>> {
    let faces = mesh.faces();
    let now = |face| match &mended.reshaped {
        Some(reshaped) => &reshaped.vertices[faces.corner_range(face)],
        None => faces.face_vertices(face),
    };
    let is_gone = |at: usize| mended.reshaped.as_ref().is_some_and(|reshaped| reshaped.is_gone[at]);
    let there = faces.faces().filter(|face| !is_gone(face.0 as usize));
    there.map(|face| now(face).iter().map(|vertex| vertex.0).collect()).collect()
}

fn steps(mended: &MendedSlivers) -> Vec<Value> {
    let step = |face: u32, mend| match mend {
        SliverMend::Collapse { from, into } => json!([face, "collapse", from.0, into.0]),
        SliverMend::Flip { edge: [a, b], to: [c, d], with } => {
            json!([face, "flip", a.0, b.0, c.0, d.0, with.0])
        }
        SliverMend::Drop => json!([face, "drop"]),
    };
    mended.steps.iter().map(|made| step(made.sliver.face.0, made.mend)).collect()
}

fn read(case: &Value) -> PolygonMesh {
    let points: Vec<[f64; 3]> = serde_json::from_value(case["positions"].clone()).unwrap();
    let faces: Vec<Vec<u32>> = serde_json::from_value(case["faces"].clone()).unwrap();
    shared::mesh(&points, &faces)
}

#[test]
fn steps_are_those_that_the_specification_allows() {
    let more = std::env::var("MESHMEND_SLIVERS").ok().map(|path| std::fs::read_to_string(path).unwrap());
    let text = include_str!("slivers.jsonl");
    for line in text.lines().chain(more.iter().flat_map(|more| more.lines())) {
        let case: Value = serde_json::from_str(line).unwrap();
        let number = |key: &str| case[key].as_f64().unwrap();
        let mended = mended(&read(&case), number("aspect"), number("move"));
        assert_eq!(json!(steps(&mended)), case["steps"], "{line}");
        let left: Vec<Value> =
            mended.left.iter().map(|left| json!([left.sliver.face.0, left.reason])).collect();
        assert_eq!(json!(left), case["left"], "{line}");
    }
}

#[test]
fn first_steps_are_those_of_the_cases() {
    for (case, mesh) in shared::cases("shape") {
        let expected = &case["reference"]["steps"];
        let Some(reach) = case["options"]["move"].as_str() else { continue };
        let mended = mended(&mesh, 1000.0, reach.parse().unwrap());
        let first = steps(&mended).first().map(|step| {
            let step = step.as_array().unwrap();
            if step[1] == "drop" { json!(["drop", step[0]]) } else { json!(step[1..4]) }
        });
        let allowed = expected.as_array().unwrap();
        let is_allowed = first.as_ref().map_or(allowed.is_empty(), |step| allowed.contains(step));
        assert!(is_allowed, "{}: {first:?}, not {expected}", case["file"]);
    }
}

/// A bumpy torus or sheet of squares, whose vertices were drawn to one another.
fn drawn_grid() -> impl Strategy<Value = PolygonMesh> {
    let pulls = prop::collection::vec((0usize..36, 0usize..8, 0usize..3), 0..8);
    (4u32..7, 4u32..7, any::<bool>(), prop::collection::vec(any::<bool>(), 36), pulls).prop_map(
        |(rows, columns, is_closed, cuts, pulls)| {
            let at = |i: u32, j: u32| (i % rows) * columns + j % columns;
            let mut points: Vec<[f64; 3]> = (0..rows * columns).map(|v| bump(v, rows, columns)).collect();
            let last = u32::from(!is_closed);
            let squares = (0..rows - last).flat_map(|i| (0..columns - last).map(move |j| (i, j)));
            let faces: Vec<Vec<u32>> = squares
                .zip(cuts.into_iter().cycle())
                .flat_map(|((i, j), cut)| {
                    let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                    if cut { [vec![a, b, c], vec![a, c, d]] } else { [vec![a, b, d], vec![b, c, d]] }
                })
                .collect();
            for (vertex, face, corner) in pulls {
                let (vertex, target) =
                    (vertex % points.len(), faces[(7 * vertex + face) % faces.len()][corner]);
                let part = if corner == 1 { 1.0 - 1e-9 } else { 0.5 };
                let to = points[target as usize];
                points[vertex] =
                    std::array::from_fn(|k| points[vertex][k] + part * (to[k] - points[vertex][k]));
            }
            shared::mesh(&points, &faces)
        },
    )
}

fn bump(vertex: u32, rows: u32, columns: u32) -> [f64; 3] {
    let turn = |part: u32, whole: u32| std::f64::consts::TAU * f64::from(part) / f64::from(whole);
    let (u, v) = (turn(vertex / columns, rows), turn(vertex % columns, columns));
    let radius = 3.0 + v.cos();
    [radius * u.cos(), radius * u.sin(), v.sin()]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn how_faces_hang_together_is_kept(
        mesh in drawn_grid(),
        aspect in prop::sample::select(vec![1.0, 4.0, 50.0, 1000.0]),
        reach in prop::sample::select(vec![0.0, 1e-6, 0.5, 10.0]),
    ) {
        let mended = mended(&mesh, aspect, reach);
        let after = shared::mesh(mesh.positions(), &faces_after(&mesh, &mended));
        let [was, is] = [&mesh, &after].map(|mesh| {
            topology(&EdgeUse::build(mesh.complex()).unwrap(), mesh)
        });
        let steps = mended.steps.len();
        prop_assert!(is.manifold && is.consistently_oriented, "{steps}");
        // Vertices in no face are components of themselves.
        let lone = |report: &meshmend_topology::TopologyReport| {
            (report.euler_characteristic, report.boundary_loops, report.genus, report.closed)
        };
        prop_assert_eq!(lone(&was), lone(&is));
        let again = self::mended(&after, aspect, reach);
        if !mended.left.iter().any(|left| left.reason.is_limit()) {
            prop_assert_eq!(again.steps, []);
        }
    }
}
