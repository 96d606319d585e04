//! STL as users have it: numbers with many digits, names, colours, and what binary files can't hold.

#![allow(clippy::unwrap_used, reason = "a test may panic")]

mod common;

use std::fs;

use common::{Folder, meshmend};

/// The corners of a box of some size at a place, and its faces, all outward.
fn cube(at: [f64; 3], size: f64) -> (Vec<[f64; 3]>, [[usize; 3]; 12]) {
    let corner = |i: usize| [0, 1, 2].map(|axis| at[axis] + if i >> axis & 1 == 1 { size } else { 0.0 });
    let faces = [
        [0, 2, 3],
        [0, 3, 1],
        [4, 5, 7],
        [4, 7, 6],
        [0, 1, 5],
        [0, 5, 4],
        [2, 6, 7],
        [2, 7, 3],
        [0, 4, 6],
        [0, 6, 2],
        [1, 3, 7],
        [1, 7, 5],
    ];
    ((0..8).map(corner).collect(), faces)
}

fn as_stl(name: &str, (corners, faces): &(Vec<[f64; 3]>, [[usize; 3]; 12])) -> String {
    let mut text = format!("solid {name}\n");
    for face in faces {
        text += "facet normal 0 0 0\nouter loop\n";
        for &vertex in face {
            let [x, y, z] = corners[vertex];
            text += &format!("vertex {x:.6} {y:.6} {z:.6}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text + &format!("endsolid {name}\n")
}

fn as_obj((corners, faces): &(Vec<[f64; 3]>, [[usize; 3]; 12])) -> String {
    let mut text: String = corners.iter().map(|[x, y, z]| format!("v {x:.6} {y:.6} {z:.6}\n")).collect();
    for face in faces {
        text += &format!("f {} {} {}\n", face[0] + 1, face[1] + 1, face[2] + 1);
    }
    text
}

/// Two centimetres at the coordinates of a survey.
fn survey_cube() -> (Vec<[f64; 3]>, [[usize; 3]; 12]) {
    cube([548_123.41, 5_801_234.57, 33.1], 0.02)
}

#[test]
fn a_small_box_far_away_is_whole_in_text() {
    let folder = Folder::new();
    let input = folder.with("a.stl", &as_stl("utm", &survey_cube()));
    let check = meshmend(&["check", "--json", &input]).succeeds().json();
    assert_eq!((check["vertices"].as_u64(), check["closed"].as_bool()), (Some(8), Some(true)));
    assert_eq!(check["joined_in_single"], 6);
    let (once, twice) = (folder.at("1.stl"), folder.at("2.stl"));
    let report = meshmend(&["repair", &input, "-o", &once, "--json"]).succeeds().json();
    assert_eq!(
        (report["stored"]["after"]["faces"].as_u64(), &report["losses"]),
        (Some(12), &serde_json::json!([]))
    );
    meshmend(&["repair", &once, "-o", &twice]).succeeds();
    assert_eq!(fs::read(&once).unwrap(), fs::read(&twice).unwrap());
    assert!(fs::read_to_string(&once).unwrap().starts_with("solid utm\nfacet normal"));
}

#[test]
fn noise_in_the_last_digits_is_told_and_joined_when_asked() {
    let folder = Folder::new();
    let text = as_stl("noisy", &cube([0.1, 0.2, 0.3], 1.0)).replacen("1.100000", "1.1000000001", 1);
    let input = folder.with("a.stl", &text);
    let heading = meshmend(&["check", &input]).stdout;
    assert!(
        heading.contains("; 1 more vertex would be joined in single precision (--weld single)\n"),
        "{heading}"
    );
    let single = meshmend(&["check", "--weld", "single", "--json", &input]).succeeds().json();
    assert_eq!((&single["weld"], single["vertices"].as_u64()), (&"single".into(), Some(8)));
    assert_eq!(single["joined_in_single"], 0);
    let plan = folder.with("plan.toml", "[weld]\ndistance = \"single\"\n");
    for policy in [["--weld", "single"], ["--plan", &plan]] {
        let (once, twice) = (folder.at("1.stl"), folder.at("2.stl"));
        let report = |from: &str, to: &str| {
            meshmend(&[&["repair", from, "-o", to, "--json"], &policy[..]].concat()).succeeds().json()
        };
        assert_eq!(report(&input, &once)["after"]["closed"], true);
        report(&once, &twice);
        assert_eq!(fs::read(&once).unwrap(), fs::read(&twice).unwrap());
    }
}

#[test]
fn a_conversion_counts_what_single_precision_empties() {
    let folder = Folder::new();
    let input = folder.with("a.obj", &as_obj(&survey_cube()));
    let run = meshmend(&["convert", &input, &folder.at("a.stl")]).succeeds();
    for loss in
        ["positions rounded to single precision: 8 of 8", "12 faces lose their area", "6 vertices become one"]
    {
        assert!(run.stdout.contains(loss), "{}", run.stdout);
    }
    let exact = meshmend(&["convert", &input, &folder.at("b.stl"), "--encoding", "ascii"]).succeeds();
    assert!(!exact.stdout.contains("can't carry"), "{}", exact.stdout);
}

#[test]
fn text_stays_text_and_binary_stays_binary() {
    let folder = Folder::new();
    let two = as_stl("bodyA", &cube([0.0; 3], 1.0)) + &as_stl("my facet endsolid", &cube([5.0; 3], 1.0));
    let input = folder.with("two.stl", &two);
    let starts = |file: &str, start: &str| fs::read(folder.at(file)).unwrap().starts_with(start.as_bytes());
    for command in [&["repair", "-o"][..], &["convert"]] {
        let output = |file: &str, more: &[&str]| {
            let path = folder.at(file);
            let words = [&command[..1], &[&input], &command[1..], &[&path], more].concat();
            meshmend(&words).succeeds();
        };
        output("a.stl", &[]);
        let text = fs::read_to_string(folder.at("a.stl")).unwrap();
        assert!(text.contains("solid bodyA\n") && text.contains("\nsolid my facet endsolid\n"), "{text}");
        output("b.stl", &["--encoding", "binary"]);
        assert!(!starts("b.stl", "solid"));
        output("c.ply", &["--encoding", "ascii"]);
        output("d.ply", &[]);
        assert!(starts("d.ply", "ply\nformat binary_little_endian"));
        for (from, to, start) in [
            ("c.ply", "e.ply", "ply\nformat ascii"),
            ("d.ply", "f.ply", "ply\nformat binary_little_endian"),
            ("c.ply", "g.stl", "\0"),
        ] {
            meshmend(&["convert", &folder.at(from), &folder.at(to)]).succeeds();
            assert!(starts(to, start), "{to}");
        }
    }
}

/// Four facets of a tetrahedron: red, green, blue, and the colour of the whole.
fn magics() -> Vec<u8> {
    let mut bytes = b"COLOR=\xa9\xa9\xff\xff,MATERIAL=...".to_vec();
    bytes.resize(80, 0);
    bytes.extend(4_u32.to_le_bytes());
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let facets = [([0, 2, 1], 0x001f_u16), ([0, 1, 3], 0x03e0), ([1, 2, 3], 0x7c00), ([0, 3, 2], 0x8000)];
    for (facet, attribute) in facets {
        let numbers = [0.0; 3].into_iter().chain(facet.into_iter().flat_map(|vertex: usize| corners[vertex]));
        bytes.extend(numbers.flat_map(|x: f32| x.to_le_bytes()));
        bytes.extend(attribute.to_le_bytes());
    }
    bytes
}

#[test]
fn attribute_bytes_become_colours_when_asked() {
    let folder = Folder::new();
    let input = folder.at("magics.stl");
    fs::write(&input, magics()).unwrap();
    let convert = |to: &str, more: &[&str]| {
        meshmend(&[&["convert", &input, &folder.at(to)], more].concat()).succeeds().stdout
    };
    let kept = convert("a.ply", &["--encoding", "ascii"]);
    assert!(kept.contains("Materialise Magics") && kept.contains("--stl-colors decode"), "{kept}");
    let decoded = ["--stl-colors", "decode"];
    let text = |file: &str| fs::read_to_string(folder.at(file)).unwrap();
    assert!(text("a.ply").contains("property ushort attribute"));
    convert("b.ply", &[&decoded[..], &["--encoding", "ascii"]].concat());
    let ply = text("b.ply");
    assert!(ply.contains("property uchar red") && !ply.contains("attribute"), "{ply}");
    for row in ["3 0 1 2 255 0 0", "3 3 4 5 0 255 0", "3 6 7 8 0 0 255", "3 9 10 11 169 169 255"] {
        assert!(ply.contains(row), "{ply}");
    }
    convert("c.obj", &decoded);
    assert!(text("c.obj").contains("v 0 1 0 1 0 0\n"), "{}", text("c.obj"));
    let refused = folder.at("d.stl");
    let to_stl = [&["convert", &input, &refused], &decoded[..]].concat();
    meshmend(&to_stl).fails(2, "--stl-colors decode has no meaning for STL");
    convert("e.stl", &[]);
    let again = fs::read(folder.at("e.stl")).unwrap();
    assert_eq!(again[..84], magics()[..84]);
    assert_eq!(again[84 + 3 * 50 + 48..], magics()[84 + 3 * 50 + 48..]);
}

#[test]
fn stl_in_and_out_lose_nothing_where_nothing_is_split() {
    let folder = Folder::new();
    let input = folder.with("a.stl", &as_stl("x", &cube([0.0; 3], 1.0)));
    for words in [
        &["convert", &input, &folder.at("1.stl")][..],
        &["repair", &input, "-o", &folder.at("2.stl")],
        &["repair", &input, "-o", &folder.at("3.stl"), "--weld", "none"],
        &["repair", &input, "-o", &folder.at("4.stl"), "--encoding", "binary", "--weld", "none"],
    ] {
        let run = meshmend(words).succeeds();
        assert!(!run.stdout.contains("at the same point"), "{}", run.stdout);
    }
    // Two boxes that share an edge are taken apart, which STL can't say.
    let pair = as_stl("a", &cube([0.0; 3], 1.0)) + &as_stl("b", &cube([1.0, 1.0, 0.0], 1.0));
    let run = meshmend(&["repair", &folder.with("b.stl", &pair), "-o", &folder.at("5.stl")]).succeeds();
    assert!(run.stdout.contains("at the same point"), "{}", run.stdout);
}

/// What single precision leaves of a small part far away is no repair.
#[test]
fn a_repair_into_single_precision_that_leaves_nothing_is_refused() {
    let folder = Folder::new();
    let (input, output) = (folder.with("a.obj", &as_obj(&survey_cube())), folder.at("a.stl"));
    let refused = meshmend(&["repair", &input, "-o", &output]).fails(5, "rounding to single precision");
    assert!(refused.stderr.contains("--encoding ascii"), "{}", refused.stderr);
    assert_eq!(folder.names(), ["a.obj"]);
    let allowed = meshmend(&["repair", &input, "-o", &output, "--allow-empty", "--json"]).succeeds().json();
    let figures = serde_json::json!({"moved": 8, "joined": 6, "emptied": 12});
    assert_eq!(allowed["rounding"], figures);
    meshmend(&["repair", &input, "-o", &output, "--encoding", "ascii"]).succeeds();
}

/// What rounding joins is told once, and a second repair finds nothing.
#[test]
fn a_repair_into_single_precision_is_done_after_one_run() {
    let folder = Folder::new();
    let input = folder.with("a.obj", &as_obj(&cube([0.1, 100_000.2, 0.3], 0.7)));
    let (once, twice) = (folder.at("1.stl"), folder.at("2.stl"));
    let run = |from: &str, to: &str| meshmend(&["repair", from, "-o", to, "--json"]).succeeds().json();
    let first = run(&input, &once);
    assert_eq!((first["rounding"]["moved"].as_u64(), first["changed"].as_bool()), (Some(8), Some(true)));
    assert_eq!(first["losses"][0]["kind"], "precision");
    let second = run(&once, &twice);
    assert_eq!((&second["rounding"], second["changed"].as_bool()), (&serde_json::Value::Null, Some(false)));
    assert_eq!(fs::read(&once).unwrap(), fs::read(&twice).unwrap());
}
