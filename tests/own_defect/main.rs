//! A kind of defect of one's own, outside the crates of meshmend: one file and one row, and all that is said of kinds of
//! defect is said of it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_cli::{Program, Status};
use meshmend_core::Rules;
use meshmend_tests::contributing::Example;
use meshmend_tests::in_process;
use meshmend_tests::scratch::Scratch;
use serde_json::{Value, json};

macro_rules! own_rules {
    ($($file:ident)*) => {
        $(mod $file;)*

        fn rules() -> Rules {
            Rules::with(&[$(&$file::RULE),*]).unwrap()
        }
    };
}

own_rules! {
    crowded_vertex
}

/// How a run of the program with these rules ended, and what it printed.
fn run(arguments: &[&str]) -> (Status, String, String) {
    in_process::run(Program::default().with_rules(rules()), arguments)
}

/// A disc of so many triangles round `v0`.
fn fan(triangles: usize) -> String {
    let mut text = String::from("v 0 0 0\n");
    for i in 0..triangles {
        let (sin, cos) = (i as f64).sin_cos();
        text.push_str(&format!("v {cos} {sin} {i}\n"));
    }
    for i in 0..triangles {
        text.push_str(&format!("f 1 {} {}\n", i + 2, (i + 1) % triangles + 2));
    }
    text
}

#[test]
fn a_check_lists_it_with_the_faces_round_it() {
    let scratch = Scratch::new();
    let (crowded, roomy) = (scratch.file("crowded.obj", &fan(13)), scratch.file("roomy.obj", &fan(12)));
    let (status, text, _) = run(&["check", &crowded, "--limit", "3"]);
    assert_eq!(status, Status::Done);
    let item = "    v0 has 13 corners, at (0, 0, 0); faces f0 f1 f2 … and 10 more\n";
    assert!(text.contains("  crowded vertices: 1 (crowded-vertex)\n") && text.contains(item), "{text}");
    let (_, text, _) = run(&["check", &roomy]);
    assert!(!text.contains("crowded"), "{text}");
}

#[test]
fn json_has_it_in_the_form_of_all_kinds() {
    let scratch = Scratch::new();
    let crowded = scratch.file("crowded.obj", &fan(13));
    let (_, text, _) = run(&["check", "--json", "--limit", "1", &crowded]);
    let document: Value = serde_json::from_str(&text).unwrap();
    let groups = document["defects"].as_array().unwrap();
    let group = groups.iter().find(|group| group["kind"] == rules().own().next().unwrap().code()).unwrap();
    let item = json!({
        "kind": group["kind"],
        "element": "vertex",
        "vertex": 0,
        "corners": 13,
        "message": "v0 has 13 corners",
        "vertices": [0],
        "positions": [[0.0, 0.0, 0.0]],
        "faces": [0],
        "face_count": 13,
    });
    let expected = json!({"kind": group["kind"], "severity": "note", "count": 1, "items": [item]});
    assert_eq!(*group, expected);
}

#[test]
fn it_is_explained_and_fails_a_check_when_it_is_named() {
    let scratch = Scratch::new();
    let (crowded, roomy) = (scratch.file("crowded.obj", &fan(13)), scratch.file("roomy.obj", &fan(12)));
    let code = rules().own().next().unwrap().code();
    assert_eq!(run(&["check", &crowded, "--fail-on", code]).0, Status::Failing);
    assert_eq!(run(&["check", &roomy, "--fail-on", code]).0, Status::Done);
    let (status, _, errors) = run(&["check", &roomy, "--fail-on", "no-such-kind"]);
    assert!(status == Status::Usage && errors.contains(code), "{errors}");
    let (_, text, _) = run(&["explain", code]);
    let sentences: Vec<&str> = text.split_whitespace().collect();
    assert!(sentences.join(" ").contains("the faces round it are thin."), "{text}");
    assert!(run(&["explain"]).1.contains(code));
}

#[test]
fn a_repair_reports_it_before_and_after() {
    let scratch = Scratch::new();
    let crowded = scratch.file("crowded.obj", &fan(13));
    let (status, text, errors) = run(&["repair", &crowded, "--dry-run", "--json"]);
    assert_eq!(status, Status::Done, "{errors}");
    let document: Value = serde_json::from_str(&text).unwrap();
    for state in ["before", "after"] {
        let groups = document[state]["defects"].as_array().unwrap();
        let code = rules().own().next().unwrap().code();
        assert!(groups.iter().any(|group| group["kind"] == code), "{state}");
    }
}

fn example() -> Example {
    Example::beside_main("tests/own_defect", "own_rules")
}

#[test]
fn the_diff_that_is_shown_is_true() {
    example().assert_shown();
}

#[test]
fn a_kind_is_one_file_and_one_row() {
    example().assert_said_nowhere_else(&[]);
}
