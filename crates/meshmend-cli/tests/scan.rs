//! A scan with cracks, holes and components inside out goes in, and a closed, outward mesh comes out; as a user runs it.

#![allow(clippy::unwrap_used, reason = "output that is not as expected is a failed test")]

mod common;

use common::{Folder, meshmend};
use serde_json::{Value, json};

const SCAN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/scan.ply");

/// Two cubes of triangles that touch along an edge, over shared vertices, as OBJ.
const TOUCHING: &str = "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\nv 1 2 0\nv 1 2 1\nv 2 1 0\n\
    v 2 1 1\nv 2 2 0\nv 2 2 1\nf 1 2 4\nf 1 4 3\nf 5 7 8\nf 5 8 6\nf 1 5 6\nf 1 6 2\nf 3 4 8\nf 3 8 7\nf 1 3 7\nf 1 7 5\n\
    f 2 6 8\nf 2 8 4\nf 7 8 10\nf 7 10 9\nf 11 13 14\nf 11 14 12\nf 7 11 12\nf 7 12 8\nf 9 10 14\nf 9 14 13\nf 7 9 13\n\
    f 7 13 11\nf 8 12 14\nf 8 14 10\n";

fn repaired(arguments: &[&str]) -> Value {
    serde_json::from_str(&meshmend(&[&["repair", "--json"], arguments].concat()).stdout).unwrap()
}

fn pass<'a>(document: &'a Value, name: &str) -> &'a Value {
    document["passes"].as_array().unwrap().iter().find(|pass| pass["pass"] == name).unwrap()
}

#[test]
fn a_scan_comes_out_closed_and_outward_and_what_is_left_is_named() {
    let folder = Folder::new();
    let output = folder.at("mended.ply");
    let options = ["--heal", "exact", "--fill", "all", "--outward", "nested", "--geometry", "--limit", "99"];
    let document = repaired(&[&[SCAN, "-o", &output], &options[..]].concat());
    let changes = &document["geometry_changes"];
    let of = |kind: &str| {
        let change = &changes[kind];
        ["before", "mended", "new", "left"].map(|what| change[what].as_u64().unwrap())
    };
    assert_eq!(of("t-junction"), [12, 12, 0, 0]);
    assert_eq!(of("inside-out-component")[1..], [0, 0, 0], "open components have no inside");
    assert_eq!(of("crossing-faces"), [0; 4]);
    let healed = &pass(&document, "heal")["t_junctions"];
    assert_eq!((&healed["healed"]["count"], &healed["left"]["count"]), (&json!(12), &json!(0)));
    let loops = &pass(&document, "fill")["loops"]["items"];
    let fates: Vec<&Value> = loops.as_array().unwrap().iter().map(|row| &row["left"]).collect();
    assert_eq!(fates, [&Value::Null, &Value::Null, &json!("lone-face")]);
    let after = &document["after"];
    let components = after["geometry"]["state_counts"].clone();
    assert_eq!(components, json!({"cavity": 1, "open": 1, "outward": 1}));
    assert_eq!(after["boundary_loops"], 1, "the face beside the model is left, and named");
    let again = meshmend(&[&["repair", &output, "-o", &folder.at("again.ply")], &options[..7]].concat());
    assert!(again.stdout.contains("nothing to mend"), "{}", again.stdout);
    let same = std::fs::read(&output).unwrap() == std::fs::read(folder.at("again.ply")).unwrap();
    assert!(same, "a second run changes nothing");
}

#[test]
fn the_report_says_what_was_mended_and_what_is_new() {
    let folder = Folder::new();
    let run = meshmend(&["repair", SCAN, "-o", &folder.at("mended.ply"), "--heal", "exact", "--geometry"]);
    let start = run.stdout.find("where the faces lie").unwrap();
    let lines: Vec<&str> = run.stdout[start..].lines().skip(1).take(2).map(str::trim).collect();
    assert_eq!(lines[0].split_whitespace().collect::<Vec<_>>(), ["before", "mended", "new", "left"]);
    assert!(run.stdout[start..].contains("T-junctions"), "{}", run.stdout);
    let quiet = meshmend(&["repair", SCAN, "-o", &folder.at("mended.ply"), "--geometry", "--quiet"]);
    assert_eq!((quiet.status, quiet.stdout.lines().count()), (0, 1));
}

#[test]
fn a_plan_that_heals_without_orienting_is_refused() {
    let folder = Folder::new();
    let run = meshmend(&["repair", SCAN, "-o", &folder.at("x.ply"), "--heal", "exact", "--orient", "off"]);
    assert_eq!(run.status, 2);
    assert!(run.stderr.contains("`heal` needs `orient` before it"), "{}", run.stderr);
    let plan = folder.with("plan.toml", "passes = ['weld', 'heal', 'orient']");
    let run = meshmend(&["repair", SCAN, "-o", &folder.at("x.ply"), "--plan", &plan]);
    assert_eq!((run.status, run.stderr.contains("plan.toml")), (2, true), "{}", run.stderr);
}

#[test]
fn parts_go_when_they_are_small() {
    let folder = Folder::new();
    let output = folder.at("mended.ply");
    let document = repaired(&[SCAN, "-o", &output, "--drop-components", "faces:2"]);
    let dropped = &pass(&document, "drop")["dropped"];
    assert_eq!(dropped["components"]["count"], 1);
    assert_eq!(dropped["components"]["items"][0]["reason"], "small-component");
    assert_eq!(document["removed_faces"]["by_reason"], json!({"small-component": 1}));
    let all = meshmend(&["repair", SCAN, "-o", &output, "--drop-components", "faces:999"]);
    assert_eq!(all.status, 5);
    assert!(all.stderr.contains("because of --drop-components faces:999"), "{}", all.stderr);
    assert_eq!(meshmend(&["repair", SCAN, "-o", &output, "--drop-components", "faces:x"]).status, 2);
}

#[test]
fn what_was_split_stays_apart_in_stl() {
    let folder = Folder::new();
    let input = folder.with("touching.obj", TOUCHING);
    let (plain, nudged) = (folder.at("plain.stl"), folder.at("nudged.stl"));
    let told = meshmend(&["repair", &input, "-o", &plain]);
    assert!(told.stdout.contains("repair --apart nudge keeps them apart"), "{}", told.stdout);
    let document = repaired(&[&input, "-o", &nudged, "--apart", "nudge"]);
    assert_eq!(document["losses"], json!([]), "nothing is one again");
    let moved = &pass(&document, "apart")["apart"]["moved"];
    assert_eq!(moved["count"], 2);
    assert!(moved["items"][0]["length"].as_f64().unwrap() < 1e-6);
    let components = |file: &str| {
        let run = meshmend(&["check", "--json", file]);
        serde_json::from_str::<Value>(&run.stdout).unwrap()["components"].clone()
    };
    assert_eq!((components(&plain), components(&nudged)), (json!(1), json!(2)));
    let again = meshmend(&["repair", &nudged, "-o", &folder.at("again.stl"), "--apart", "nudge"]);
    assert!(again.stdout.contains("nothing to mend"), "{}", again.stdout);
}

#[test]
fn a_kind_that_positions_tell_is_explained_with_a_picture_and_found_in_a_file() {
    let page = meshmend(&["explain", "t-junction", SCAN]).stdout;
    assert!(page.contains("a──●──b"), "{page}");
    assert!(page.contains("scan.ply: 12"), "{page}");
    assert!(meshmend(&["explain", "heal"]).stdout.contains("─▶"));
}

#[test]
fn a_picture_shows_what_positions_tell() {
    let folder = Folder::new();
    let output = folder.at("scan.svg");
    let overlays = "crossings,t-junctions,holes,slivers,inside-out,internal";
    let run = meshmend(&["render", SCAN, "-o", &output, "--overlay", overlays]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let picture = std::fs::read_to_string(&output).unwrap();
    assert!(picture.contains("T-junctions") && picture.contains("holes"));
    assert!(!picture.contains("crossing faces"), "a legend says nothing of what is not there");
}
