//! `meshmend advise` and `repair --weld auto`.

mod common;

use std::fs;

use common::{Folder, example, meshmend};
use serde_json::{Value, json};

/// A square of two triangles with a crack of this width between them.
fn cracked(width: f64) -> String {
    format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 {width} 0\nv 0 {} 0\nv 1 1 0\nf 1 2 3\nf 5 4 6\n", 1.0 + width)
}

#[test]
fn a_crack_is_advised_on_and_taken() {
    let folder = Folder::new();
    let (input, picture, output) =
        (folder.with("a.obj", &cracked(1e-4)), folder.at("a.svg"), folder.at("b.obj"));
    let run = meshmend(&["advise", &input, "--svg", &picture]).succeeds();
    for line in
        ["weld within ", "closes 2 of 6 boundary edges", "faces that vanish: 0", "repair --weld boundary:0."]
    {
        assert!(run.stdout.contains(line), "{line}\n{}", run.stdout);
    }
    let drawing = fs::read_to_string(&picture).unwrap();
    assert!(
        drawing.starts_with("<svg ") && drawing.ends_with("</svg>\n") && drawing.contains("1e-4"),
        "{drawing}"
    );
    let advice = meshmend(&["advise", &input, "--json"]).succeeds().json();
    assert_eq!((&advice["open_edges"], &advice["tolerance"]["closes"]), (&json!(6), &json!(2)));
    let distance = advice["tolerance"]["distance"].as_f64().unwrap();
    assert_eq!(advice["option"], format!("boundary:{distance}"));
    assert!(distance > 1e-4 && distance <= 1e-3, "{distance}");

    let run = meshmend(&["repair", &input, "-o", &output, "--weld", "auto"]).succeeds();
    assert!(run.stdout.contains("closes 2 of 6 boundary edges"), "{}", run.stdout);
    let report = meshmend(&["repair", &input, "-o", &output, "--weld", "auto", "--json"]).succeeds().json();
    assert_eq!(report["passes"][0]["advice"]["tolerance"], advice["tolerance"]);
    assert_eq!(report["after"]["vertices"], 4);
    let again = meshmend(&["repair", &output, "-o", &output, "--weld", "auto", "--json"]).succeeds().json();
    assert_eq!(
        (&again["changed"], &again["passes"][0]["advice"]["tolerance"]),
        (&json!(false), &Value::Null)
    );
    // A plan says the same, and a check judges as welded within it.
    let plan = folder.with("auto.toml", "[weld]\ndistance = \"auto\"\n");
    let planned = meshmend(&["repair", &input, "-o", &output, "--plan", &plan, "--json"]).succeeds().json();
    assert_eq!(planned["passes"], report["passes"]);
    let check = meshmend(&["check", &input, "--weld", "auto", "--json"]).succeeds().json();
    assert_eq!((&check["weld"], &check["vertices"]), (&json!({ "boundary": distance }), &json!(4)));
}

#[test]
fn where_nothing_stands_out_it_says_so_and_welds_exactly() {
    let folder = Folder::new();
    let output = folder.at("b.obj");
    let closed = meshmend(&["advise", &example("soup.stl")]).succeeds();
    assert!(closed.stdout.contains("weld exactly"), "{}", closed.stdout);
    let wide = folder.with("wide.obj", &cracked(0.3));
    let run = meshmend(&["advise", &wide, "--json"]).succeeds().json();
    assert_eq!((&run["tolerance"], &run["option"]), (&Value::Null, &Value::Null));
    let run = meshmend(&["repair", &wide, "-o", &output, "--weld", "auto"]).succeeds();
    assert!(run.stdout.contains("no tolerance stands out: weld exactly"), "{}", run.stdout);
    let empty = folder.with("empty.obj", "v 0 0 0\n");
    assert!(meshmend(&["advise", &empty]).succeeds().stdout.contains("no edge is open"));
    let svg = folder.at("c.svg");
    meshmend(&["advise", &empty, "--svg", &svg]).succeeds();
    assert!(fs::read_to_string(&svg).unwrap().ends_with("</svg>\n"));
    meshmend(&["advise", &wide, "--svg", &folder.at("c.obj")]).fails(2, "has the name of a mesh");
    meshmend(&["advise", &folder.at("none.obj")]).fails(3, "none.obj");
}
