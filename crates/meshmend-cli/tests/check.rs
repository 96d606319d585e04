//! `meshmend check`, as a user runs it.

mod common;

use std::process::Stdio;

use common::{Folder, example, group, meshmend, program};
use meshmend::KernelKind;
use serde_json::{Value, json};

#[test]
fn defects_are_listed_with_ids_and_coordinates() {
    let run = meshmend(&["check", &example("broken.obj")]);
    assert_eq!((run.status, run.stderr.as_str()), (1, ""));
    for line in [
        "e1 v0-v2 has 3 sides, at (0, 0, 0) (0, 1, 0)",
        "f6 is f5 again, at (0, 1, 0) (0, 0, 0) (0, 0, 1) (0, 1, 1)",
        "v20 is in no face, at (5, 5, 5)",
        "exact welding would join 6 vertices to others",
        "manifold                no   non-manifold edges: 4, singular vertices: 4",
        "half-edge        refuses: non-manifold edges: 4, inconsistently oriented edges: 3, singular vertices: 4",
        "1 ×  disc           8 vertices, 12 edges, 5 faces  χ 1  at v8",
    ] {
        assert!(run.stdout.contains(line), "{line}\n{}", run.stdout);
    }
    assert!(!run.stdout.contains('\u{1b}'));
}

#[test]
fn the_faces_along_an_edge_and_round_a_vertex_are_named() {
    let folder = Folder::new();
    // Five pages on one edge, one of them the other way round; a degenerate face and a vertex in no face; two faces that
    // meet in a vertex.
    let book = "f 2 1 3\nf 1 2 4\nf 1 2 5\nf 1 2 6\nf 2 1 7\nf 1 2 1\nf 8 9 10\nf 8 11 12\n";
    let vertices: String = (0..13).map(|i| format!("v {i} {} 0\n", i * i)).collect();
    let file = folder.with("book.obj", &(vertices + book));
    let text = meshmend(&["check", &file]).stdout;
    for line in [
        "e0 v0-v1 has 5 sides, at (0, 0, 0) (1, 1, 0); faces f0 f1 f2 f3 f4\n",
        "v0 is on a non-manifold edge, at (0, 0, 0); faces f0 f1 f2 f3 f4\n",
        "v7 joins 2 umbrellas, all open, at (7, 49, 0); faces f6 f7\n",
        "e1 v0-v2 has one side, at (0, 0, 0) (2, 4, 0); face f0\n",
        "v12 is in no face, at (12, 144, 0)\n",
        "f5 has fewer than three different vertices, at (0, 0, 0) (1, 1, 0) (0, 0, 0)\n",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let text = meshmend(&["check", &file, "--limit", "2"]).stdout;
    assert!(text.contains("; faces f0 f1 … and 3 more\n"), "{text}");
    assert!(!meshmend(&["check", &file, "--limit", "0"]).stdout.contains("faces f"));
    let json = meshmend(&["check", &file, "--limit", "2", "--json"]).json();
    let edge = &group(&json, "non-manifold-edge")["items"][0];
    assert_eq!(
        (&edge["degree"], &edge["face_count"], &edge["faces"]),
        (&json!(5), &json!(5), &json!([0, 1]))
    );
    assert_eq!(edge["message"], "e0 v0-v1 has 5 sides");
    let unused = &group(&json, "unreferenced-vertex")["items"][0];
    assert_eq!((&unused["face_count"], &unused["faces"]), (&json!(0), &json!([])));
    assert_eq!(group(&json, "degenerate-face")["items"][0].get("faces"), None);
}

#[test]
fn the_faces_are_those_of_the_view_and_the_same_on_every_kernel() {
    let folder = Folder::new();
    // A square in two triangles that share no vertex, the second one with a corner twice.
    let square = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 5 4 6 6\n";
    let file = folder.with("square.obj", square);
    let faces = |options: &[&str]| {
        let json = meshmend(&[&["check", "--json", &file], options].concat()).json();
        let items = group(&json, "boundary-edge")["items"].as_array().unwrap().clone();
        items.iter().map(|item| item["faces"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(faces(&[]), [0, 0, 0, 1, 1, 1].map(|face| json!([face])));
    assert_eq!(faces(&["--weld", "exact"]), [0, 0, 1, 1].map(|face| json!([face])));
    for kernel in KernelKind::ALL.iter().map(|kind| kind.name()) {
        let run = meshmend(&["check", "--json", &file, "--kernel", kernel]);
        assert_eq!(run.stdout, meshmend(&["check", "--json", &file]).stdout, "{kernel}");
    }
}

#[test]
fn notes_fail_only_when_they_are_named() {
    let (pinched, band) = (example("pinched.ply"), example("moebius.off"));
    let folder = Folder::new();
    let open = folder.with("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\nf 1 2 3\n");
    assert_eq!(meshmend(&["check", &open]).status, 0);
    assert_eq!(meshmend(&["check", &open, "--fail-on", "boundary-edge"]).status, 1);
    assert_eq!(meshmend(&["check", &open, "--fail-on", "loose-edge,unreferenced-vertex"]).status, 1);
    assert_eq!(meshmend(&["check", &open, "--fail-on", "loose-edge,polygon-face"]).status, 0);
    assert_eq!(meshmend(&["check", &band, &pinched]).status, 1);
    meshmend(&["check", &open, "--fail-on", "hole"]).fails(2, "boundary-edge");
}

#[test]
fn what_fails_a_check_is_listed() {
    let folder = Folder::new();
    let quad = folder.with("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    assert!(!meshmend(&["check", &quad]).succeeds().stdout.contains("(polygon-face)"));
    let run = meshmend(&["check", &quad, "--fail-on", "polygon-face,loose-edge"]);
    assert!(run.status == 1 && run.stdout.contains("f0 has 4 corners, at"), "{}", run.stdout);
    assert!(!run.stdout.contains("loose-edge"), "{}", run.stdout);
}

#[test]
fn a_file_without_indices_is_judged_as_welded() {
    let soup = example("soup.stl");
    let check =
        |options: &[&str]| meshmend(&[&["check", "--json", &soup], options].concat()).succeeds().json();
    let (usual, stored) = (check(&[]), check(&["--weld", "none"]));
    assert_eq!(
        (&usual["view"], &usual["components"], &usual["closed"]),
        (&json!("welded"), &json!(1), &json!(true))
    );
    assert_eq!((&stored["view"], &stored["components"]), (&json!("indexed"), &json!(4)));
    assert_eq!(group(&stored, "coincident-vertex")["count"], 8);
    assert_eq!(usual["stored"], json!({"vertices": 12, "faces": 4, "loose_edges": 0, "loose_points": 0}));
    let all_in_one = meshmend(&["check", "--json", "--weld", "200%", &soup]);
    assert_eq!((all_in_one.status, &all_in_one.json()["degenerate_faces"]), (1, &json!(4)));
}

#[test]
fn json_is_one_sorted_object_a_line_and_the_same_every_time() {
    let files = [example("broken.obj"), example("moebius.off"), example("pinched.ply")];
    let arguments = ["check", "--json", &files[0], &files[1], &files[2]];
    let run = meshmend(&arguments);
    assert_eq!(run.stdout, meshmend(&arguments).stdout);
    let lines: Vec<Value> = run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let formats: Vec<&Value> = lines.iter().map(|line| &line["format"]).collect();
    assert_eq!(formats, ["obj", "off", "ply-ascii"]);
    for (line, text) in lines.iter().zip(run.stdout.lines()) {
        assert_eq!(line["schema"], 2);
        assert_eq!(line.to_string(), text, "a sorted map gives the same text");
    }
    assert_eq!(lines[0]["file"], files[0].as_str());
    let edge = &group(&lines[0], "non-manifold-edge")["items"][0];
    assert_eq!((&edge["ends"], &edge["degree"]), (&json!([0, 2]), &json!(3)));
    assert_eq!(edge["positions"], json!([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]));
    assert_eq!(lines[1]["component_kinds"][0]["name"], "Möbius band");
    let half_edge =
        lines[2]["kernels"].as_array().unwrap().iter().find(|k| k["name"] == "half-edge").unwrap();
    assert_eq!(*half_edge, json!({"name": "half-edge", "holds": false, "refusals": {"pinched-vertex": 1}}));
}

#[test]
fn the_limit_cuts_lists_and_no_count() {
    let broken = example("broken.obj");
    for limit in [0_usize, 1, 100] {
        let json = meshmend(&["check", "--json", "--limit", &limit.to_string(), &broken]).json();
        let edges = group(&json, "boundary-edge");
        assert_eq!((&edges["count"], edges["items"].as_array().unwrap().len()), (&json!(8), limit.min(8)));
        assert_eq!(json["component_kinds"].as_array().unwrap().len(), limit.min(3));
        assert_eq!(json["component_kinds_total"], 3);
    }
    let text = meshmend(&["check", "--limit", "1", &broken]).stdout;
    assert!(text.contains("boundary edges: 8") && text.contains("… and 7 more"), "{text}");
}

#[test]
fn a_coordinate_that_is_no_number_is_null() {
    let folder = Folder::new();
    let file = folder.with("nan.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n");
    let run = meshmend(&["check", "--json", &file]);
    assert_eq!(run.status, 1);
    let json = run.json();
    assert_eq!(group(&json, "non-finite-vertex")["items"][0]["positions"], json!([[1.0, null, 0.0]]));
    assert!(!json["notes"].as_array().unwrap().is_empty());
}

#[test]
fn an_unreadable_file_is_no_reason_to_stop() {
    let folder = Folder::new();
    let wrong = folder.with("wrong.obj", "v 0 0 0\nf 1 2 3\n");
    let scene = folder.with("scene.dae", "<COLLADA/>");
    let missing = folder.at("missing.obj");
    let soup = example("soup.stl");
    let run = meshmend(&["check", "--json", &wrong, &missing, &scene, &soup, &example("pinched.ply")]);
    assert_eq!(run.status, 3);
    let files: Vec<Value> = run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!((files.len(), &files[0]["file"]), (2, &json!(soup)));
    let errors: Vec<&str> = run.stderr.lines().collect();
    assert_eq!(errors.len(), 3, "{}", run.stderr);
    assert!(errors[0].starts_with(&format!("meshmend: {wrong}:2: ")), "{}", errors[0]);
    assert!(errors[1].starts_with(&format!("meshmend: {missing}: ")), "{}", errors[1]);
    assert!(errors[2].contains("looks like COLLADA; the formats that are read are OBJ, "), "{}", errors[2]);
}

#[test]
fn a_kernel_that_cant_hold_the_mesh_refuses() {
    let (pinched, soup) = (example("pinched.ply"), example("soup.stl"));
    let run = meshmend(&["check", "--kernel", "half-edge", &pinched]).fails(5, "v0 joins 2 umbrellas");
    assert_eq!(run.stdout, "");
    let of_kernel = |kernel| meshmend(&["check", "--json", "--kernel", kernel, &soup]).succeeds().stdout;
    assert_eq!(of_kernel("half-edge"), of_kernel("edge-use"));
    meshmend(&["check", "--kernel", "full-edge", &soup]).fails(2, "half-edge");
}

#[test]
fn wrong_distances_are_usage_errors() {
    for distance in ["nan", "1e999", "-1", "near", "%"] {
        assert_eq!(meshmend(&["check", &format!("--weld={distance}"), &example("soup.stl")]).status, 2);
    }
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let files = vec![example("broken.obj"); 200];
    let mut child =
        program().arg("check").args(files).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(1), b"".as_slice()));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_an_error() {
    let Ok(full) = std::fs::OpenOptions::new().write(true).open("/dev/full") else { return };
    let output = program().args(["check", &example("soup.stl")]).stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(4));
    assert!(String::from_utf8_lossy(&output.stderr).contains("standard output"));
}

#[test]
fn names_and_notes_cant_take_hold_of_a_terminal() {
    let folder = Folder::new();
    let file = folder.with("a\u{1b}[2Jb.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert!(!meshmend(&["check", &file]).succeeds().stdout.contains('\u{1b}'));
    let missing = meshmend(&["check", &folder.at("\u{1b}[2J.obj")]);
    assert!(missing.status == 3 && !missing.stderr.contains('\u{1b}'), "{}", missing.stderr);
}

#[test]
fn the_heading_says_what_is_there_and_as_what_it_is_judged() {
    let folder = Folder::new();
    let file = folder.with("loose.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\np 3\n");
    let heading = |options: &[&str]| meshmend(&[&["check", &file], options].concat()).succeeds().stdout;
    assert!(heading(&[]).contains("3 vertices, 1 face, 1 loose edge, 1 loose point\njudged as stored"));
    assert!(
        heading(&["--weld", "exact"]).contains("\njudged as welded: vertices at the same position are one\n")
    );
    assert!(heading(&["--weld", "0.25"]).contains("\njudged as welded: vertices within 0.25 are one\n"));
    let part = "\njudged as welded: vertices within 0.01 of the bounding box's diagonal are one\n";
    assert!(heading(&["--weld", "1%"]).contains(part));
}
