//! Best fills of the cases of holes beside the workspace, and how many admissible ones there are.

#![allow(clippy::unwrap_used, reason = "a test stops where it fails")]

mod shared;

use meshmend_core::{Build, Connectivity, EdgeUse, PolygonMesh, VertexId, Watch};
use meshmend_spatial::{FillBy, OpenLoop, Opening, best_fill, direction_of_face, open_loops};

#[test]
fn fills_have_the_costs_of_the_cases() {
    for (case, mesh) in shared::cases("holes") {
        let kernel = EdgeUse::build(mesh.complex()).unwrap();
        let reference = case["reference"]["loops"].as_array().unwrap();
        for (found, expected) in open_loops(&kernel, &mesh, &Watch::NOBODY).unwrap().iter().zip(reference) {
            let (admissible, cost) = asked(&kernel, &mesh, found);
            assert_eq!(Some(admissible as u64), expected["admissible"].as_u64(), "{}", case["file"]);
            let Some(best) = expected["best_cost"].as_array() else { continue };
            let [zero_area, fold, area] = [0, 1, 2].map(|at| best[at].as_f64().unwrap());
            let (found_zero_area, found_fold, found_area) = cost.unwrap();
            assert_eq!(found_zero_area as f64, zero_area, "{}", case["file"]);
            assert!((found_fold - fold).abs() < 1e-9, "{} {found_fold}", case["file"]);
            assert!((found_area - area).abs() <= 1e-9 * area, "{} {found_area}", case["file"]);
        }
    }
}

/// How many admissible fills a loop has, and what the best one costs.
fn asked(kernel: &EdgeUse, mesh: &PolygonMesh, found: &OpenLoop) -> (usize, Option<(usize, f64, f64)>) {
    let vertices: Vec<VertexId> = found.vertices.iter().copied().rev().collect();
    let edge =
        |a: VertexId, b: VertexId| kernel.edges().find(|&e| kernel.edge_ends(e) == [a.min(b), a.max(b)]);
    let points: Vec<[f64; 3]> = vertices.iter().map(|&vertex| mesh.position(vertex)).collect();
    let next = vertices.iter().cycle().skip(1);
    let beside = vertices.iter().zip(next).map(|(&a, &b)| {
        let face = kernel.edge_faces(edge(a, b).unwrap()).next().unwrap();
        let corners: Vec<[f64; 3]> =
            mesh.faces().face_vertices(face).iter().map(|&v| mesh.position(v)).collect();
        direction_of_face(&corners)
    });
    let beside: Vec<[f64; 3]> = beside.collect();
    let is_joined = |a: usize, b: usize| edge(vertices[a], vertices[b]).is_some();
    let is_there = |corners: [usize; 3]| {
        let corners = corners.map(|corner| vertices[corner]);
        mesh.faces().faces().any(|face| {
            let face = mesh.faces().face_vertices(face);
            face.len() == 3 && corners.iter().all(|vertex| face.contains(vertex))
        })
    };
    let opening = Opening {
        points: &points,
        vertices: &vertices,
        beside: &beside,
        is_joined: &is_joined,
        is_there: &is_there,
    };
    let cost = best_fill(&opening, FillBy::Fold).map(|fill| fill.cost);
    (count(&opening, 0, points.len() - 1), cost.map(|cost| (cost.zero_area, cost.fold, cost.area)))
}

/// How many admissible fills the range between two corners has.
fn count(opening: &Opening<'_>, low: usize, high: usize) -> usize {
    let is_whole = high - low == opening.points.len() - 1;
    if high - low == 1 {
        return 1;
    }
    if !is_whole && (opening.is_joined)(low, high) {
        return 0;
    }
    let with = |middle| {
        let is_there = (opening.is_there)([low, middle, high]);
        if is_there { 0 } else { count(opening, low, middle) * count(opening, middle, high) }
    };
    (low + 1..high).map(with).sum()
}
