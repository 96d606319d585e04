//! `meshmend repair --fill`, as a user runs it.

mod common;

use std::fs;

use common::{Folder, meshmend};
use serde_json::json;

/// A cube without its lid.
const CUP: &str = "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\n\
                   f 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 1 2 4 3\n";

#[test]
fn a_hole_is_filled_and_named_in_every_format() {
    let folder = Folder::new();
    let input = folder.at("cup.obj");
    fs::write(&input, CUP).unwrap();
    for output in
        ["mended.obj", "mended.ply", "mended.stl", "mended.off", "mended.glb"].map(|name| folder.at(name))
    {
        let run = meshmend(&["repair", &input, "-o", &output, "--fill", "all"]).succeeds();
        for line in [
            "faces created: 2",
            "fill        boundary edges: 4",
            "loop at v1: 4 edges, length 4.000000, turned 0.200: filled by 2 faces, fold 1.000, area 1.000000",
        ] {
            assert!(run.stdout.contains(line), "{line}\n{}", run.stdout);
        }
        let after = meshmend(&["check", "--weld", "exact", "--json", &output]).succeeds().json();
        assert_eq!((&after["boundary_loops"], &after["manifold"]), (&json!(0), &json!(true)), "{output}");
        let again =
            meshmend(&["repair", &output, "-o", &output, "--json", "--fill", "all"]).succeeds().json();
        assert_eq!(again["changed"], false, "{output}");
    }
}

#[test]
fn a_loop_that_stays_open_has_its_reason() {
    let folder = Folder::new();
    let input = folder.at("cup.obj");
    fs::write(&input, CUP).unwrap();
    let arguments = ["repair", &input, "--dry-run", "--json", "--fill", "edges:3,area:50%"];
    let report = meshmend(&arguments).succeeds().json();
    assert_eq!(report["changed"], false);
    assert!(report.get("created_faces").is_none());
    let fill = report["passes"].as_array().unwrap().iter().find(|pass| pass["pass"] == "fill").unwrap();
    let row = &fill["loops"]["items"][0];
    assert_eq!((&row["first_vertex"], &row["edges"], &row["left"]), (&json!(1), &json!(4), &json!("edges")));
    let report = meshmend(&["repair", &input, "--dry-run", "--json", "--fill-by", "fan"]).succeeds().json();
    let causes = [5, 6, 7, 8].map(|face| json!({"face": face, "cause": "filled"}));
    assert_eq!(report["created_faces"], json!({"count": 4, "items": causes}));
    let unasked = meshmend(&["repair", &input, "--dry-run", "--json"]).succeeds().json();
    assert_eq!(unasked["passes"].as_array().unwrap().len(), 7);
    meshmend(&["repair", &input, "--dry-run", "--fill", "edges:x"]).fails(2, "edges:12");
    meshmend(&["repair", &input, "--dry-run", "--fill", "off", "--fill-rims"]).fails(2, "no meaning");
}
