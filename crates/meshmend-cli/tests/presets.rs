//! `--preset`, `preset`, and what a plan says beside the passes.

mod common;

use common::{Folder, example, meshmend};
use serde_json::json;

#[test]
fn a_preset_does_what_the_plan_does_that_it_prints() {
    let folder = Folder::new();
    for name in ["asset", "print", "scan", "teaching"] {
        let plan = folder.with("plan.toml", &meshmend(&["preset", name]).succeeds().stdout);
        let output = folder.at("out.ply");
        let repair = |option: &str, value: &str| {
            let run = meshmend(&["repair", &example("broken.obj"), "-o", &output, "--json", option, value]);
            (run.status, run.json())
        };
        let (by_name, by_plan) = (repair("--preset", name), repair("--plan", &plan));
        assert_eq!(by_name, by_plan, "{name}");
        assert!(by_name.0 <= 1, "{name}: {}", by_name.0);
    }
    meshmend(&["preset", "prnt"]).fails(2, "print");
    meshmend(&["repair", &example("broken.obj"), "--dry-run", "--preset", "prnt"]).fails(2, "scan");
}

#[test]
fn a_print_is_closed_or_fails() {
    let folder = Folder::new();
    // A tetrahedron with a crack and without one face.
    let open = folder.with(
        "open.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0.00001 0\nv 0 1.00001 0\nf 1 2 4\nf 5 4 6\nf 2 3 4\n",
    );
    let run =
        meshmend(&["repair", &open, "-o", &folder.at("a.stl"), "--preset", "print", "--json"]).succeeds();
    let report = run.json();
    assert_eq!((&report["after"]["closed"], &report["after"]["faces"]), (&json!(true), &json!(4)));
    // Without the fills it is left open, and fails, as the plan says.
    let run = meshmend(&["repair", &open, "-o", &folder.at("b.stl"), "--preset", "print", "--fill", "off"]);
    run.fails(1, "boundary-edge (3)");
    // An option overrides what the plan fails on.
    let words = ["--preset", "print", "--fill", "off", "--fail-on", "removed"];
    meshmend(&[&["repair", &open, "-o", &folder.at("c.stl")], &words[..]].concat()).succeeds();
    let strict = ["--preset", "print", "--fill", "off", "--strict"];
    meshmend(&[&["repair", &open, "-o", &folder.at("d.stl")], &strict[..]].concat())
        .fails(1, "nothing is written");
    assert!(!folder.names().contains(&"d.stl".to_owned()));
}

#[test]
fn a_plan_overrides_a_preset_and_options_both() {
    let folder = Folder::new();
    let plan =
        folder.with("plan.toml", "limit = 1\nfail-on = [\"changed\"]\n[weld]\ndistance = \"single\"\n");
    let (input, output) = (example("broken.obj"), folder.at("out.ply"));
    let run = |options: &[&str]| {
        let arguments = ["repair", &input, "-o", &output, "--json", "--preset", "asset", "--plan", &plan];
        meshmend(&[&arguments[..], options].concat()).fails(1, "changed").json()
    };
    let weld = |report: &serde_json::Value| {
        report["passes"][0]["mended"]["coincident-vertex"]["items"].as_array().unwrap().len()
    };
    assert_eq!((weld(&run(&[])), weld(&run(&["--limit", "3"]))), (1, 3));
    let wrong = folder.with("wrong.toml", "fail-on = [\"hole\"]\n");
    meshmend(&["repair", &input, "--dry-run", "--plan", &wrong]).fails(2, "boundary-edge");
    let wrong = folder.with("seams.toml", "\nseams = \"weld\"\n");
    meshmend(&["repair", &input, "--dry-run", "--plan", &wrong]).fails(2, "line 2");
}

#[test]
fn a_plan_says_how_seams_are_written() {
    let folder = Folder::new();
    let (input, plan) = (example("broken.obj"), folder.with("plan.toml", "seams = \"corners\"\n"));
    let vertices = |options: &[&str]| {
        let output = folder.at("out.ply");
        meshmend(&[&["repair", &input, "-o", &output], options].concat()).succeeds();
        meshmend(&["check", &output, "--json"]).json()["stored"]["vertices"].as_u64().unwrap()
    };
    let (split, corners) = (vertices(&[]), vertices(&["--plan", &plan]));
    assert!(split > corners, "{split} {corners}");
    assert_eq!(vertices(&["--plan", &plan, "--seams", "split"]), split);
}
