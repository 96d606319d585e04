//! No silent emptiness: what has no faces stays as it is, and nothing loses its last face unasked.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

mod common;

use std::fs;

use common::{Folder, meshmend};
use serde_json::{Value, json};

/// A unit cube, and a vertex far away that no face uses.
const CUBE: &str = "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\nv 1000000 0 0\n\
    f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";

#[test]
fn a_stray_vertex_does_not_stretch_a_percentage() {
    let folder = Folder::new();
    let cube = folder.with("cube.obj", CUBE);
    let report = meshmend(&["repair", &cube, "--dry-run", "--weld", "0.01%", "--json"]).succeeds().json();
    assert_eq!(report["stored"]["after"]["faces"], 6);
    let check = meshmend(&["check", &cube, "--weld", "0.01%", "--json"]).json();
    assert_eq!((&check["vertices"], &check["faces"]), (&json!(8), &json!(6)));
}

#[test]
fn clouds_and_lines_are_written_as_they_were_read() {
    let folder = Folder::new();
    // Points at one place, loose points and lines, a coordinate that is no number.
    for content in [
        "v 0 0 0\nv 0 0 0\nv 1 0 0\n",
        "v 0 0 0\nv 0 0 0\np 1 2\n",
        "v 0 0 0\nv 1 0 0\nv 1 0 0\nl 1 2 3\nl 3 1\n",
        "v 0 0 0\nv nan 0 0\n",
    ] {
        let (input, output) = (folder.with("in.obj", content), folder.at("out.obj"));
        let plain = folder.at("plain.obj");
        meshmend(&["convert", &input, &plain]);
        for options in [&[][..], &["--weld", "50%"], &["--orient", "outward", "--triangulate", "all"]] {
            let run = meshmend(&[&["repair", &input, "-o", &output][..], options].concat()).succeeds();
            assert!(run.stdout.contains("nothing to mend: there is no face"), "{}", run.stdout);
            assert_eq!(fs::read(&output).unwrap(), fs::read(&plain).unwrap(), "{content} {options:?}");
        }
        let report = meshmend(&["repair", &input, "-o", &output, "--json"]).succeeds().json();
        assert_eq!(report["stored"]["before"], report["stored"]["after"]);
        assert!(report["passes"].as_array().unwrap().iter().all(|pass| pass["changed"] == false));
    }
}

#[test]
fn what_has_no_face_has_one_reason_for_all_that_is_not_defined() {
    let folder = Folder::new();
    for content in ["v 0 0 0\n", "v 0 0 0\nv 1 0 0\nl 1 2\n", "v 0 0 0\nv 1 0 0\nf 1 2 1\n"] {
        let input = folder.with("in.obj", content);
        let report = meshmend(&["check", &input, "--json"]).json();
        let reasons: Vec<&Value> =
            report["undefined"].as_array().unwrap().iter().map(|undefined| &undefined["reason"]).collect();
        assert_eq!(reasons, [&json!("no-faces"); 2], "{content}");
        assert_eq!((&report["genus"], &report["cross_caps"]), (&Value::Null, &Value::Null));
        let text = meshmend(&["check", &input]).stdout;
        assert!(text.contains("there is no face to judge"), "{text}");
        assert!(!text.contains("orientable"), "{text}");
    }
}

#[track_caller]
fn refuses(folder: &Folder, content: &str, options: &[&str], reasons: &str) {
    let (input, output) = (folder.with("in.obj", content), folder.at("out.obj"));
    for target in [&["--dry-run"][..], &["-o", &output], &["-o", &input], &["--dry-run", "--json"]] {
        let arguments = [&["repair", &input], target, options].concat();
        let run = meshmend(&arguments).fails(5, reasons);
        assert!(run.stderr.contains("--allow-empty"), "{}", run.stderr);
        assert_eq!(folder.names(), ["in.obj"]);
        assert_eq!(fs::read_to_string(&input).unwrap(), content);
    }
    let run = meshmend(&[&["repair", &input, "-o", &output, "--allow-empty"], options].concat()).succeeds();
    assert!(run.stdout.contains("the result is empty: no face is left"), "{}", run.stdout);
    fs::remove_file(output).unwrap();
}

#[test]
fn no_mesh_loses_its_last_face_unasked() {
    let folder = Folder::new();
    let why = "would remove all 6 faces: degenerate faces: 6, because of --weld 100%";
    refuses(&folder, CUBE, &["--weld", "100%"], why);
    refuses(&folder, CUBE, &["--weld", "7.5"], "degenerate faces: 6, because of --weld 7.5");
    let sliver = "v 0 0 0\nv 1 0 0\nv 0 0 0\nf 1 2 3\n";
    refuses(&folder, sliver, &[], "would remove the only face: degenerate faces: 1, because of --weld exact");
    let spike = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1\nf 1 2 3\n";
    refuses(&folder, spike, &["--weld", "9"], "degenerate faces: 1, as stored; degenerate faces: 1, because");
    let infinite = "v 0 0 0\nv inf 0 0\nv 0 1 0\nf 1 2 3\n";
    refuses(&folder, infinite, &[], "faces with non-finite corners: 1, because of --non-finite drop");
    let wall = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n";
    let why = "opposite duplicate faces: 2, because of --duplicates remove-pair";
    refuses(&folder, wall, &["--duplicates", "remove-pair"], why);
}

#[test]
fn a_plan_can_allow_it_too() {
    let folder = Folder::new();
    let input = folder.with("in.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n");
    let plan = folder.with("plan.toml", "empty = 'allow'\n");
    meshmend(&["repair", &input, "--dry-run", "--plan", &plan]).succeeds();
    let plan = folder.with("plan.toml", "empty = 'refuse'\n");
    meshmend(&["repair", &input, "--dry-run", "--plan", &plan]).fails(5, "as stored");
    meshmend(&["repair", &input, "--dry-run", "--plan", &plan, "--allow-empty"]).succeeds();
}

#[test]
fn a_picture_of_a_repair_that_leaves_nothing_is_refused_too() {
    let folder = Folder::new();
    let input = folder.with("in.obj", "v 0 0 0\nv 1 0 0\nf 1 2 1\n");
    meshmend(&["render", &input, "-o", &folder.at("out.svg"), "--before-after"]).fails(5, "as stored");
}
