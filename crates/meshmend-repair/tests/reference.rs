//! The default pipeline with `triangulate off` against the reference, face by face. A mesh with a face that has a hole is
//! not compared: what such faces are cut into is judged instead.
//!
//! The cases come from `reference_cases.py`, which asks the reference itself; where that is not at hand the test says
//! that it was skipped. More cases than the usual number: `MESHMEND_REFERENCE_CASES=100000`, or a file of cases made
//! before: `MESHMEND_REFERENCE_FILE=…`. Cases that once differed are kept, with their right answers, in
//! `reference_finds.jsonl`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use meshmend_core::{Defect, DefectKind, FaceId, FaceTableBuilder, PolygonMesh, VertexId};
use meshmend_kernels::KernelKind;
use meshmend_repair::{Emptying, PassKind, Pipeline, Plan, Repaired, Session, SplitEdges};
use meshmend_testkit::{Soup, reference};
use serde_json::Value;

fn case_lines() -> Option<Box<dyn Iterator<Item = String>>> {
    if let Ok(path) = std::env::var("MESHMEND_REFERENCE_FILE") {
        let file = std::fs::File::open(path).unwrap();
        return Some(Box::new(BufReader::new(file).lines().map(Result::unwrap)));
    }
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/reference");
    if !std::path::Path::new(root).join("repair_reference.py").exists() {
        println!("skipped: the reference is not here ({root})");
        return None;
    }
    let count = std::env::var("MESHMEND_REFERENCE_CASES").unwrap_or_else(|_| "1500".into());
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference_cases.py");
    let Ok(child) = Command::new("python3").args([script, root, "0", &count]).stdout(Stdio::piped()).spawn()
    else {
        println!("skipped: there is no python3");
        return None;
    };
    Some(Box::new(BufReader::new(child.stdout.unwrap()).lines().map(Result::unwrap)))
}

fn mesh_of(case: &Value) -> PolygonMesh {
    let position = |p: &Value| match p.as_array() {
        Some(p) => [0, 1, 2].map(|i| p[i].as_f64().unwrap()),
        None => [f64::NAN; 3],
    };
    let positions: Vec<[f64; 3]> = case["positions"].as_array().unwrap().iter().map(position).collect();
    let mut builder = FaceTableBuilder::default();
    for face in case["faces"].as_array().unwrap() {
        builder.push_face(face.as_array().unwrap().iter().map(|v| VertexId(v.as_u64().unwrap() as u32)));
    }
    let faces = builder.build(positions.len()).unwrap();
    PolygonMesh::new(positions, faces).unwrap()
}

/// A repair's result in the reference's words.
fn words_of(repaired: &Repaired) -> Value {
    let faces = repaired.mesh.faces();
    let list: Vec<Vec<u32>> =
        faces.faces().map(|f| rotated(faces.face_vertices(f).iter().map(|v| v.0).collect())).collect();
    let mut flipped = vec![false; list.len()];
    repaired.provenance.flipped.iter().for_each(|f| flipped[f.0 as usize] = true);
    let twisted: Vec<u32> = repaired
        .topology
        .as_ref()
        .unwrap()
        .defects
        .iter()
        .filter_map(|defect| match defect.at {
            meshmend_core::Element::Strip(strip) => strip.faces.iter().map(|f| f.0).min(),
            _ => None,
        })
        .collect();
    serde_json::json!({
        "faces": list,
        "positions": repaired.mesh.positions(),
        "source_vertex": repaired.provenance.vertices,
        "source_face": repaired.provenance.faces,
        "flipped": flipped,
        "non_orientable": twisted.len(),
    })
}

fn expected(case: &Value, stored: &PolygonMesh) -> Value {
    let faces = case["faces"].as_array().unwrap().iter();
    let faces: Vec<Vec<u32>> = faces
        .map(|f| rotated(f.as_array().unwrap().iter().map(|v| v.as_u64().unwrap() as u32).collect()))
        .collect();
    let stored = |id: &Value| stored.position(VertexId(id.as_u64().unwrap() as u32));
    let inserted = |new: usize| {
        let place = case["inserted"][&new.to_string()].as_array().unwrap();
        let ([a, b], [n, d]) =
            ([&place[0], &place[1]].map(stored), [&place[2], &place[3]].map(|x| x.as_f64().unwrap()));
        std::array::from_fn(|i| a[i] + (b[i] - a[i]) * n / d)
    };
    let sources = case["source_vertex"].as_array().unwrap().iter().enumerate();
    let positions: Vec<[f64; 3]> =
        sources.map(|(new, source)| if source.is_null() { inserted(new) } else { stored(source) }).collect();
    serde_json::json!({
        "faces": faces,
        "positions": positions,
        "source_vertex": case["source_vertex"],
        "source_face": case["source_face"],
        "flipped": case["flipped"],
        "non_orientable": case["non_orientable"].as_array().unwrap().len(),
    })
}

fn rotated(mut face: Vec<u32>) -> Vec<u32> {
    let least = face.iter().enumerate().min_by_key(|(_, v)| **v).map_or(0, |(i, _)| i);
    face.rotate_left(least);
    face
}

fn pipeline(edges: SplitEdges) -> Pipeline {
    let mut plan = Plan::default().without(PassKind::Triangulate);
    plan.split.edges = edges;
    plan.pipeline().on_emptying(Emptying::Allow)
}

#[test]
fn the_default_pipeline_is_the_reference() {
    let Some(lines) = case_lines() else { return };
    let count = agree_with_the_reference(lines);
    println!("{count} random meshes repaired as the reference does");
    assert!(count > 0);
}

#[test]
fn what_once_differed_from_the_reference_no_longer_does() {
    // 78601: a degenerate face's vertex, in no other face, lies at the middle of an edge that is subdivided.
    let finds = include_str!("reference_finds.jsonl");
    assert_eq!(agree_with_the_reference(finds.lines().map(str::to_owned)), 1);
}

/// Repairs each case with every kernel that holds anything, in pools of several sizes; gives the number of cases.
fn agree_with_the_reference(lines: impl Iterator<Item = String>) -> usize {
    let permissive: Vec<KernelKind> =
        KernelKind::ALL.iter().copied().filter(|k| k.capabilities().is_permissive()).collect();
    let pools: Vec<rayon::ThreadPool> =
        [1, 2, 8].map(|n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap()).into();
    let mut count = 0;
    for line in lines {
        let case: Value = serde_json::from_str(&line).unwrap();
        let mesh = mesh_of(&case);
        count += 1;
        let soup = Soup::of_mesh(&mesh);
        let holes = reference::faces_with_holes(&reference::exact_positions(&soup), &soup.faces);
        if !holes.is_empty() {
            assert_eq!(faults(&mesh, &soup, &holes), [""; 0], "seed {}: {:?}", case["seed"], soup);
            continue;
        }
        for (name, edges) in [("sheets", SplitEdges::Sheets), ("cut", SplitEdges::Cut)] {
            let wanted = expected(&case[name], &mesh);
            for (&kernel, pool) in permissive.iter().flat_map(|k| pools.iter().map(move |pool| (k, pool))) {
                let found =
                    pool.install(|| pipeline(edges).run_in(Session::begin(&mesh).with_kernel(kernel)));
                let found = words_of(&found.unwrap_or_else(|e| panic!("seed {}: {e}", case["seed"])));
                assert_eq!(found, wanted, "{name} on {kernel}, seed {}: {}", case["seed"], case["faces"]);
            }
        }
    }
    count
}

/// What is wrong with a mesh with faces that have holes once it is repaired, and with the pieces of these.
fn faults(mesh: &PolygonMesh, soup: &Soup, holes: &[u32]) -> Vec<String> {
    let repaired = Soup::of_mesh(&pipeline(SplitEdges::Sheets).run(mesh).unwrap().mesh);
    let mut faults = reference::broken_postconditions(repaired.vertex_count(), &repaired.faces);
    let plan = Plan { passes: vec![PassKind::Weld, PassKind::Clean], ..Plan::default() };
    let cleaned = plan.pipeline().run(mesh).unwrap();
    let positions = reference::exact_positions(soup);
    let named = cleaned.passes.iter().flat_map(|pass| pass.fixed.iter());
    let spared: Vec<FaceId> = named
        .filter(|defect| matches!(defect.kind, DefectKind::CrossingFace | DefectKind::DuplicateFace))
        .filter_map(|defect| defect.at.face())
        .collect();
    // What goes in a second round has other numbers there.
    let is_repeat = |defect: Defect| defect.kind == DefectKind::DuplicateFace;
    if cleaned.passes.iter().skip(2).any(|pass| pass.fixed.iter().any(is_repeat)) {
        return faults;
    }
    for &hole in holes.iter().filter(|&&hole| !spared.contains(&FaceId(hole))) {
        let faces = cleaned.mesh.faces();
        let pieces = faces.faces().filter(|&f| cleaned.provenance.faces.of(f) == Some(FaceId(hole)));
        // A vertex is named after the lowest one behind a corner that is left, which need not be the lowest in its place.
        let lowest = |v: &VertexId| {
            let place = cleaned.mesh.position(*v);
            soup.positions.iter().position(|&position| position == place).unwrap() as u32
        };
        let pieces: Vec<Vec<u32>> =
            pieces.map(|f| faces.face_vertices(f).iter().map(lowest).collect()).collect();
        let word = reference::word_of(&positions, &soup.faces[hole as usize]);
        faults.extend(reference::hole_faults(&positions, &word, &pieces));
    }
    faults
}
