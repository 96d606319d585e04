//! Faces that repeat another one but differ from it, and what `outward` says, through the command.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

mod common;

use std::fs;

use common::{Folder, group, meshmend};
use serde_json::json;

const DECAL: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n\
    usemtl base\nf 1/1 2/2 3/3\nusemtl decal\nf 1/4 2/2 3/3\n";

#[test]
fn a_decal_is_kept_and_named() {
    let folder = Folder::new();
    let (input, output, again) =
        (folder.with("decal.obj", DECAL), folder.at("out.obj"), folder.at("again.obj"));
    let report = meshmend(&["repair", &input, "-o", &output, "--json"]).succeeds().json();
    assert_eq!(report["removed_faces"]["count"], 0);
    let left = &report["passes"][1]["left"]["differing-face"];
    let item = json!({
        "kind": "differing-face",
        "element": "face",
        "face": 1,
        "beside": {"element": "face", "face": 0},
        "differs": ["material", "texcoord"],
        "message": "f1 is f0 again, but for material and texcoord",
    });
    assert_eq!((&left["count"], &left["items"][0]), (&json!(1), &item));
    let text = meshmend(&["repair", &input, "-o", &output]).succeeds().stdout;
    assert!(text.contains("f1 is f0 again, but for material and texcoord"), "{text}");
    meshmend(&["repair", &output, "-o", &again]).succeeds();
    assert_eq!(fs::read(&output).unwrap(), fs::read(&again).unwrap());
    let written = fs::read_to_string(&output).unwrap();
    assert!(written.contains("usemtl decal\nf 4/4 5/2 6/3"), "{written}");
}

#[test]
fn a_format_that_holds_no_difference_gets_one_face_and_it_is_said() {
    let folder = Folder::new();
    let input = folder.with("decal.obj", DECAL);
    for name in ["out.off", "out.stl"] {
        let report = meshmend(&["repair", &input, "-o", &folder.at(name), "--json"]).succeeds().json();
        let removed = &report["removed_faces"];
        assert_eq!((&removed["count"], &removed["differing"]), (&json!(1), &json!(1)), "{name}");
        let item = json!({
            "face": 1, "pass": "clean", "reason": "duplicate-face",
            "differed": ["material", "texcoord"], "had": {"material": "decal"},
        });
        assert_eq!(removed["items"][0], item);
    }
    let text = meshmend(&["repair", &input, "-o", &folder.at("out.off")]).succeeds().stdout;
    let said =
        "f1 by clean: duplicate-face, although it differed in material and texcoord (it had material decal)";
    assert!(text.contains(said), "{text}");
    // PLY has texture coordinates.
    let report = meshmend(&["repair", &input, "-o", &folder.at("out.ply"), "--json"]).succeeds().json();
    assert_eq!(report["removed_faces"]["count"], 0);
    let report = meshmend(&["repair", &input, "--dry-run", "--repeated", "drop", "--json"]).succeeds().json();
    assert_eq!(report["removed_faces"]["differing"], 1);
}

#[test]
fn solids_of_text_stl_are_told_apart_where_text_is_written() {
    let folder = Folder::new();
    let facet =
        "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
    let content = format!("solid one\n{facet}endsolid one\nsolid two\n{facet}endsolid two\n");
    let input = folder.with("in.stl", &content);
    let faces = |options: &[&str]| {
        let out = folder.at("out.stl");
        let run = meshmend(&[&["repair", &input, "-o", &out, "--json"], options].concat()).succeeds();
        run.json()["stored"]["after"]["faces"].clone()
    };
    assert_eq!(faces(&["--encoding", "ascii"]), 2);
    assert_eq!(faces(&["--encoding", "binary"]), 1);
}

#[test]
fn a_split_that_is_left_out_leaves_a_decal_where_it_is() {
    let folder = Folder::new();
    let input = folder.with("decal.obj", DECAL);
    for options in [["--split", "off"], ["--split", "pinch-only"], ["--orient", "off"], ["--clean", "off"]] {
        let (one, two) = (folder.at("one.obj"), folder.at("two.obj"));
        meshmend(&[&["repair", &input, "-o", &one][..], &options].concat()).succeeds();
        meshmend(&[&["repair", &one, "-o", &two][..], &options].concat()).succeeds();
        assert_eq!(fs::read(&one).unwrap(), fs::read(&two).unwrap(), "{options:?}");
        assert_eq!(meshmend(&["check", &two, "--json"]).json()["faces"], 2);
    }
}

/// A cube about the origin, which looks outward or inward.
fn cube(half: f64, first: usize, is_outward: bool) -> String {
    let mut text = String::new();
    for corner in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|axis| if corner >> axis & 1 == 1 { half } else { -half });
        text.push_str(&format!("v {x} {y} {z}\n"));
    }
    for mut face in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
        if !is_outward {
            face.reverse();
        }
        let [a, b, c, d] = face.map(|v| v + first);
        text.push_str(&format!("f {a} {b} {c} {d}\n"));
    }
    text
}

#[test]
fn outward_says_which_cavities_it_turned() {
    let folder = Folder::new();
    let hollow = folder.with("hollow.obj", &(cube(3.0, 1, true) + &cube(1.0, 9, false)));
    let run = |options: &[&str]| {
        meshmend(&[&["repair", &hollow, "--dry-run", "--json"], options].concat()).succeeds().json()
    };
    let report = run(&["--orient", "outward"]);
    let left = &report["passes"][2]["left"];
    let item = json!({
        "kind": "turned-cavity",
        "element": "patch",
        "face": 6,
        "patch_faces": 6,
        "message": "the closed patch of f6, 6 faces in all, is inside another",
    });
    assert_eq!(left["turned-cavity"], json!({"count": 1, "items": [item]}));
    assert_eq!(left.get("unjudged-patch"), None);
    let text = meshmend(&["repair", &hollow, "--dry-run", "--orient", "outward"]).succeeds().stdout;
    assert!(text.contains("the closed patch of f6, 6 faces in all, is inside another"), "{text}");
    assert!(text.contains("--orient outward-nested keeps the walls of cavities"), "{text}");
    for options in [&["--orient", "outward-nested"][..], &[]] {
        let report = run(options);
        assert_eq!(report["flipped_faces"]["count"], 0);
        assert!(report["passes"].as_array().unwrap().iter().all(|pass| pass["left"] == json!({})));
    }
}

#[test]
fn outward_does_not_call_a_body_inside_another_a_cavity() {
    let folder = Folder::new();
    for (inner, others) in [(true, String::new()), (false, cube(2.0, 17, false))] {
        // A body in a body; a body in the cavity of another, all of it inside out but for the cavity.
        let content = cube(3.0, 1, true) + &cube(1.0, 9, inner) + &others;
        let input = folder.with("in.obj", &content);
        let report =
            meshmend(&["repair", &input, "--dry-run", "--orient", "outward", "--json"]).succeeds().json();
        let turned = &report["passes"][2]["left"]["turned-cavity"]["items"];
        let expected = if inner { [json!(null), json!(null)] } else { [json!(12), json!(6)] };
        assert_eq!([turned[0]["face"].clone(), turned[0]["patch_faces"].clone()], expected);
        assert_eq!(turned[1], json!(null));
    }
}

#[test]
fn outward_names_what_it_can_not_judge() {
    let folder = Folder::new();
    let open = "v 9 0 0\nv 8 0 0\nv 9 1 0\nv 8 1 0\nf 9 10 11\nf 11 10 12\n";
    let flat = "v 20 0 0\nv 21 0 0\nv 20 1 0\nf 13 14 15\nf 13 15 14\n";
    let input = folder.with("in.obj", &(cube(3.0, 1, true) + open + flat));
    for side in ["outward", "outward-nested"] {
        let report = meshmend(&["repair", &input, "--dry-run", "--orient", side, "--json"]).succeeds().json();
        let orients: Vec<_> = report["passes"].as_array().unwrap().iter().collect();
        let last = orients.iter().rfind(|pass| pass["pass"] == "orient").unwrap();
        let unjudged = &last["left"]["unjudged-patch"];
        assert_eq!(unjudged["count"], 2);
        let items = [(6, "open"), (8, "no-volume")];
        for (item, (face, reason)) in unjudged["items"].as_array().unwrap().iter().zip(items) {
            assert_eq!((&item["element"], &item["face"]), (&json!("patch"), &json!(face)));
            assert_eq!((&item["patch_faces"], &item["reason"]), (&json!(2), &json!(reason)));
        }
        let named = orients.iter().filter(|pass| pass["left"].get("unjudged-patch").is_some()).count();
        assert_eq!(named, 1);
    }
    assert_eq!(group(&meshmend(&["check", &input, "--json"]).json(), "unjudged-patch"), &json!(null));
}
