//! `meshmend check --geometry`, as a user runs it.

#![allow(clippy::unwrap_used, reason = "output that is not as expected is a failed test")]

mod common;

use common::{Folder, group, meshmend};
use serde_json::{Value, json};

/// Two triangles that pass through one another, a needle, and a closed box inside out.
const CROSSED: &str = "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 -1\nv 1 1 1\nv 3 3 1\nv 0 9 0\nv 4000 9 0\nv 1 9.0001 0\n\
    f 1 2 3\nf 4 5 6\nf 7 8 9\n";

/// A tetrahedron that looks inward.
const INWARD: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";

fn json_of(arguments: &[&str]) -> Value {
    serde_json::from_str(&meshmend(&[arguments, &["--json"]].concat()).stdout).unwrap()
}

#[test]
fn faces_that_cross_fail_a_check_that_asks_for_them_alone() {
    let folder = Folder::new();
    let file = folder.with("crossed.obj", CROSSED);
    let plain = meshmend(&["check", &file]);
    assert_eq!((plain.status, plain.stdout.contains("crossings")), (0, false), "{}", plain.stdout);
    let asked = meshmend(&["check", "--geometry", &file]);
    assert_eq!(asked.status, 1, "{}", asked.stdout);
    for line in [
        "crossings       1 pair in 1 cluster of 2 faces; passing through: 1, overlapping in one plane: 0\n",
        "boundary loops  3 rims of sheets\n",
        "components      3 open\n",
        "f0 and f1 pass through one another",
        "f2 is a needle",
    ] {
        assert!(asked.stdout.contains(line), "{line}\n{}", asked.stdout);
    }
    let document = json_of(&["check", "--geometry=crossings", &file]);
    assert_eq!(document["geometry"]["intersections"]["pairs"], json!([[0, 1, "face-face", false]]));
    assert_eq!(document["geometry"]["intersections"]["points"][0].as_array().unwrap().len(), 3);
    assert_eq!(document["geometry"]["intersections"]["counts"]["face-face"], 1);
    assert!(document["geometry"]["loops"].is_null() && document["geometry"]["slivers"].is_null());
    assert_eq!(group(&document, "crossing-faces")["items"][0]["how"], "pass through one another");
}

#[test]
fn a_kind_that_is_to_fail_the_check_is_asked_for() {
    let folder = Folder::new();
    let file = folder.with("crossed.obj", CROSSED);
    let run = meshmend(&["check", "--fail-on", "sliver-face", &file]);
    assert_eq!((run.status, run.stdout.contains("f2 is a needle")), (1, true), "{}", run.stdout);
    assert!(!run.stdout.contains("pass through"), "{}", run.stdout);
}

#[test]
fn what_is_inside_out_is_named_and_what_was_not_searched_to_its_end_has_no_figures() {
    let folder = Folder::new();
    let file = folder.with("inward.obj", INWARD);
    let document = json_of(&["check", "--geometry=nesting", &file]);
    let component = &document["geometry"]["components"][0];
    assert_eq!((&component["state"], &component["depth"]), (&json!("inside-out"), &json!(0)));
    assert_eq!(document["geometry"]["state_counts"], json!({"inside-out": 1}));
    assert_eq!(group(&document, "inside-out-component")["items"][0]["component_faces"], 4);
    let text = meshmend(&["check", "--geometry=nesting", &file]);
    assert_eq!(text.status, 1);
}

#[test]
fn a_vertex_on_an_edge_is_a_t_junction_from_a_distance_on() {
    let folder = Folder::new();
    let text =
        "v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 0.01 0\nv 0 -1 0\nv 2 -1 0\nf 1 2 3\nf 1 5 4\nf 4 5 6\nf 4 6 2\n";
    let file = folder.with("crack.obj", text);
    let count = |arguments: &[&str]| {
        let document = json_of(&[&["check", "--geometry=t-junctions", &file], arguments].concat());
        document["geometry"]["t_junctions"]["count"].clone()
    };
    assert_eq!(count(&[]), 0);
    assert_eq!(count(&["--near", "0.02"]), 1);
    assert_eq!(meshmend(&["check", "--geometry", "--near", "single", &file]).status, 2);
}
