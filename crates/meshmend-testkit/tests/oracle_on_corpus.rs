//! The oracle agrees with the known answers of the corpus, which were found by other programs and by formula.
//!
//! Skipped, with a message, where there is no corpus beside the workspace.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::{Path, PathBuf};

use meshmend_testkit::Soup;
use meshmend_testkit::oracle::{findings, report};
use serde_json::{Value, json};

/// Larger files take a naive program too long.
const MOST_FACES: u64 = 300;

#[test]
fn the_oracle_agrees_with_the_corpus() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/corpus");
    let Ok(manifest) = std::fs::read_to_string(folder.join("manifest.json")) else {
        println!("skipped: there is no {}/manifest.json", folder.display());
        return;
    };
    let manifest: Value = serde_json::from_str(&manifest).unwrap();
    let mut compared = 0;
    for entry in manifest["files"].as_array().unwrap() {
        let expected = &entry["expected"]["indexed"];
        let is_small = expected["F_total"].as_u64().is_some_and(|faces| faces <= MOST_FACES);
        if !is_small || entry["format"] != "off" {
            continue;
        }
        let Some(soup) = read_off(&folder.join(entry["path"].as_str().unwrap())) else { continue };
        compare(&soup, expected, &entry["path"]);
        compared += 1;
    }
    assert!(compared > 20, "only {compared} files were compared");
    println!("{compared} files");
}

fn compare(soup: &Soup, expected: &Value, path: &Value) {
    let (report, found) = (report(soup), findings(soup));
    let non_orientable = found.witnesses.len();
    let ours = json!({
        "V": report.vertices,
        "E": report.edges,
        "F": report.faces,
        "V_unused": report.unreferenced_vertices,
        "degenerate_faces": report.degenerate_faces,
        "pinched_faces": report.non_simple_faces,
        "edges_1": report.boundary_edges,
        "edges_2": report.interior_edges,
        "edges_3plus": report.non_manifold_edges,
        "edges_2_inconsistent": report.inconsistent_edges,
        "duplicate_faces": report.duplicate_faces.same + report.duplicate_faces.opposite,
        "nonmanifold_vertices": report.non_manifold_vertices.pinched + report.non_manifold_vertices.singular,
        "components": report.components,
        "patches": report.patches,
        "nonorientable_patches": non_orientable,
        "orientable": report.orientable,
        "consistently_oriented": report.consistently_oriented,
        "closed": report.closed,
        "manifold": report.manifold,
        "chi": report.euler_characteristic,
        "betti": report.betti.z2,
    });
    for (key, value) in ours.as_object().unwrap() {
        assert_eq!(*value, expected[key], "{key} of {path}");
    }
    if report.manifold {
        assert_eq!(json!(report.boundary_loops), expected["boundary_loops"], "{path}");
        // The corpus counts 0 where no component has the figure.
        assert_eq!(json!(report.genus.unwrap_or(0)), expected["genus_total"], "{path}");
        assert_eq!(json!(report.cross_caps.unwrap_or(0)), expected["nonorientable_genus_total"], "{path}");
    }
}

/// A plain OFF file with three coordinates a vertex and a face a line; nothing for other dialects.
fn read_off(path: &Path) -> Option<Soup> {
    let text = std::fs::read_to_string(path).ok()?;
    let plain = text.lines().map(|line| line.split('#').next().unwrap_or(""));
    let mut lines = plain.filter(|line| !line.trim().is_empty());
    if lines.next()?.trim() != "OFF" {
        return None;
    }
    let counts: Vec<usize> = lines.next()?.split_whitespace().map(|n| n.parse().unwrap()).collect();
    let numbers = |line: &str| -> Vec<f64> { line.split_whitespace().map(|n| n.parse().unwrap()).collect() };
    let positions =
        lines.by_ref().take(counts[0]).map(|line| numbers(line)[..3].try_into().unwrap()).collect();
    let face = |line: &str| {
        let mut list = line.split_whitespace().map(|n| n.parse::<u32>());
        let size = list.next().unwrap().unwrap() as usize;
        list.take(size).map(Result::unwrap).collect()
    };
    Some(Soup { positions, faces: lines.take(counts[1]).map(face).collect() })
}
