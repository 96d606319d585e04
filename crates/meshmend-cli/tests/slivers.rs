//! `meshmend repair --slivers`, as a user runs it.

mod common;

use std::fs;

use common::{Folder, meshmend};
use serde_json::{Value, json};

/// A square whose middle is a needle, and a cap next to its upper side.
const SQUARE: &str = "v -1 0 0\nv 0 0 0\nv 0 1e-7 0\nv 1 0 0\nv 0 -1 0\nv 0 1 0\n\
                      f 2 4 3\nf 3 1 2\nf 1 5 2\nf 2 5 4\nf 4 6 3\nf 3 6 1\n";
/// A cap over an inner edge.
const CAP: &str =
    "v 0 0 0\nv 5 0 0\nv 2.5 1e-6 0\nv 2.5 -3 0\nv 2.5 4 0\nf 1 2 3\nf 2 1 4\nf 1 3 5\nf 3 2 5\n";

/// What the pass says of the slivers.
fn of_slivers(report: &Value) -> Value {
    let passes = report["passes"].as_array().into_iter().flatten();
    passes
        .filter(|pass| pass["pass"] == "slivers")
        .map(|pass| pass["slivers"].clone())
        .next()
        .unwrap_or_default()
}

#[test]
fn a_needle_is_collapsed_and_named_in_every_format() {
    let folder = Folder::new();
    let input = folder.at("square.obj");
    fs::write(&input, SQUARE).unwrap();
    for output in ["a.obj", "a.ply", "a.stl", "a.off", "a.glb"].map(|name| folder.at(name)) {
        let run = meshmend(&["repair", &input, "-o", &output, "--slivers", "1000"]).succeeds();
        for line in ["slivers     1 step", "f0, a needle of aspect", "v2 went into v1"] {
            assert!(run.stdout.contains(line), "{line}\n{}", run.stdout);
        }
        let after =
            meshmend(&["check", "--weld", "exact", "--geometry=shape", "--json", &output]).succeeds().json();
        assert_eq!((&after["faces"], &after["euler_characteristic"]), (&json!(4), &json!(1)));
        let again = ["repair", &output, "-o", &output, "--json", "--slivers", "1000"];
        assert_eq!(meshmend(&again).succeeds().json()["changed"], false, "{output}");
    }
}

#[test]
fn each_step_and_each_sliver_that_is_left_is_in_the_report() {
    let folder = Folder::new();
    let input = folder.at("cap.obj");
    fs::write(&input, CAP).unwrap();
    let repair = |more: &[&str]| {
        let arguments =
            [&["repair", input.as_str(), "--dry-run", "--json", "--slivers", "1000"], more].concat();
        meshmend(&arguments).succeeds().json()
    };
    let mended = repair(&[]);
    let slivers = of_slivers(&mended);
    assert_eq!((&slivers["left"]["count"], &slivers["move_limit"]), (&json!(0), &json!(0)));
    let step = &slivers["steps"]["items"][0];
    assert_eq!((&step["face"], &step["shape"], &step["step"]), (&json!(0), &json!("cap"), &json!("flip")));
    assert_eq!((&step["edge"], &step["to"], &step["with"]), (&json!([0, 1]), &json!([2, 3]), &json!(1)));
    let still = repair(&["--max-move", "1e-7"]);
    assert_eq!(still["changed"], false);
    let slivers = of_slivers(&still);
    assert_eq!((&slivers["steps"]["count"], &slivers["move_limit"]), (&json!(0), &json!(1)));
    assert_eq!(slivers["left"]["items"][0]["left"], "move");
    let removed = folder.at("square.obj");
    fs::write(&removed, SQUARE).unwrap();
    let report =
        meshmend(&["repair", &removed, "--dry-run", "--json", "--slivers", "1000"]).succeeds().json();
    assert_eq!(report["removed_faces"]["by_reason"], json!({"sliver-face": 2}));
}

#[test]
fn what_can_not_be_asked_for_is_refused() {
    let folder = Folder::new();
    let (input, plan) = (folder.at("cap.obj"), folder.at("plan.toml"));
    fs::write(&input, CAP).unwrap();
    let with = |options: &[&str]| meshmend(&[&["repair", input.as_str(), "--dry-run"], options].concat());
    with(&["--slivers", "0.5"]).fails(2, "1 or more");
    with(&["--max-move=-1"]).fails(2, "0.01%");
    with(&["--slivers", "off", "--max-move", "1"]).fails(2, "no meaning");
    fs::write(&plan, "passes = ['slivers', 'triangulate']").unwrap();
    with(&["--plan", &plan]).fails(2, "`triangulate` has to come before it");
    let page = meshmend(&["explain", "slivers"]).succeeds();
    assert!(page.stdout.contains("the short edge of a needle is collapsed"), "{}", page.stdout);
}
