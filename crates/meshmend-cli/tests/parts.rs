//! A mesh taken apart by the names of its faces, through the command.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

mod common;

use std::fs;

use common::{Folder, meshmend};
use serde_json::json;

/// Two objects that share a side. In the first, a face is there twice and another looks the other way.
const OBJECTS: &str = "o body\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 3\nf 1 4 3\n\
    o lid\nv 2 0 0\nf 2 5 3\n";

/// The rest of a tetrahedron whose first face is another object's.
const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no one\nf 1 3 2\no rest\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

#[test]
fn a_check_tells_which_object_is_broken() {
    let folder = Folder::new();
    let input = folder.with("two.obj", OBJECTS);
    let text = meshmend(&["check", &input, "--by", "object"]).fails(1, "").stdout;
    let line = |name: &str| text.lines().find(|line| line.contains(name)).unwrap_or_else(|| panic!("{text}"));
    assert!(line("body (object)").contains("duplicate faces: 1"), "{text}");
    assert!(line("lid (object)").contains("nothing"), "{text}");
    let report = meshmend(&["check", &input, "--by", "object", "--json"]).fails(1, "").json();
    assert_eq!(report["parts"].as_array().unwrap().len(), 2);
    assert_eq!((&report["faces"], &report["genus"]), (&json!(4), &json!(null)));
    assert_eq!(report["parts"][0]["name"], "body");
    assert_eq!(report["parts"][1]["genus"], 0);
    meshmend(&["check", &input, "--by", "object", "--part", "lid"]).succeeds();
    meshmend(&["check", &input, "--by", "object", "--part", "1", "--json"]).succeeds();
}

#[test]
fn an_edge_that_another_object_has_too_is_shared_and_not_boundary() {
    let folder = Folder::new();
    let input = folder.with("tetrahedron.obj", TETRAHEDRON);
    let report = meshmend(&["check", &input, "--by", "object", "--json"]).succeeds().json();
    for (part, loops) in report["parts"].as_array().unwrap().iter().zip([1, 1]) {
        assert_eq!((&part["shared_edges"]["count"], &part["boundary_loops"]), (&json!(3), &json!(loops)));
        let defects = part["defects"].as_array().unwrap();
        assert!(defects.iter().all(|group| group["kind"] != "boundary-edge"), "{defects:?}");
    }
    meshmend(&["check", &input, "--by", "object", "--fail-on", "boundary-edge"]).succeeds();
}

#[test]
fn a_repair_mends_each_object_and_keeps_what_they_share() {
    let folder = Folder::new();
    let (input, output, again) =
        (folder.with("two.obj", OBJECTS), folder.at("out.obj"), folder.at("again.obj"));
    let report = meshmend(&["repair", &input, "--by", "object", "-o", &output, "--json"]).succeeds().json();
    assert_eq!(report["removed_faces"]["count"], 1);
    assert_eq!(
        (&report["parts"][0]["changed"], &report["parts"][1]["changed"]),
        (&json!(true), &json!(false))
    );
    assert_eq!(report["changed"], true);
    let written = fs::read_to_string(&output).unwrap();
    assert!(written.contains("f 1 2 3\nf 1 3 4\n"), "{written}");
    assert!(written.contains("o lid\nf 2 5 3\n"), "{written}");
    meshmend(&["repair", &output, "--by", "object", "-o", &again]).succeeds();
    assert_eq!(fs::read(&output).unwrap(), fs::read(&again).unwrap());
    // One part alone.
    let text =
        meshmend(&["repair", &input, "--by", "object", "--part", "lid", "-o", &output]).succeeds().stdout;
    assert!(text.contains("1 part, 0 changed"), "{text}");
    assert_eq!(fs::read_to_string(&output).unwrap().matches("\nf ").count(), 4);
}

#[test]
fn what_can_not_be_taken_apart_is_said() {
    let folder = Folder::new();
    let input = folder.with("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let no_names = "its faces have no material to take it apart by";
    meshmend(&["check", &input, "--by", "material"]).fails(2, no_names);
    let no_part = "there is no part `lid`; the parts are 0: whole file";
    meshmend(&["repair", &input, "--part", "lid", "--dry-run"]).fails(2, no_part);
}

/// Two tetrahedra that meet in a vertex.
const PINCHED: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv -1 0 0\nv 0 -1 0\nv 0 0 -1\n\
    f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 1 5 6\nf 1 7 5\nf 1 6 7\nf 5 7 6\n";

#[test]
fn a_scene_says_on_request_which_vertices_are_one() {
    let folder = Folder::new();
    let (input, scene) = (folder.with("pinched.obj", PINCHED), folder.at("pinched.glb"));
    meshmend(&["convert", &input, &scene]).succeeds();
    meshmend(&["check", &scene]).fails(1, "");
    let (plain, told, again) = (folder.at("plain.glb"), folder.at("told.glb"), folder.at("again.glb"));
    let text = meshmend(&["repair", &scene, "-o", &plain]).succeeds().stdout;
    assert!(text.contains("1 vertex that was split stands at one place with others"), "{text}");
    // By its place the vertex is one again.
    meshmend(&["check", &plain]).fails(1, "");
    let text = meshmend(&["repair", &scene, "--manifold-extension", "-o", &told]).succeeds().stdout;
    assert!(!text.contains("was split"), "{text}");
    let report = meshmend(&["check", &told, "--json"]).succeeds().json();
    assert_eq!((&report["manifold"], &report["components"]), (&json!(true), &json!(2)));
    // Nothing changes any more, with the option or without it; a clean scene gets the extension too.
    for options in [&["--manifold-extension"][..], &[]] {
        meshmend(&[&["repair", &told, "-o", &again], options].concat()).succeeds();
        assert_eq!(fs::read(&told).unwrap(), fs::read(&again).unwrap());
    }
    meshmend(&["convert", &plain, &again, "--manifold-extension"]).succeeds();
    let json = String::from_utf8_lossy(&fs::read(&again).unwrap()).into_owned();
    assert!(json.contains("\"EXT_mesh_manifold\":{\"manifoldPrimitive\""), "{json}");
}
