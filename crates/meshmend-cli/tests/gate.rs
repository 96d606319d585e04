//! `--fail-on` and `--strict`: what fails a run, and what is then written.

mod common;

use std::fs;

use common::{Folder, example, meshmend};
use serde_json::json;

const OPEN: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[test]
fn a_repair_fails_on_what_is_left_and_on_what_it_did_and_writes_all_the_same() {
    let folder = Folder::new();
    for (word, told) in [
        ("removed", "removed (1 face)"),
        ("changed", "changed"),
        ("loss", "loss ("),
        ("loss:shared-vertices", "loss:shared-vertices ("),
        ("boundary-edge,removed", "removed (1 face)"),
    ] {
        let output = folder.at(&format!("{}.stl", word.replace([':', ','], "-")));
        let arguments = ["repair", &example("broken.obj"), "-o", &output, "--fail-on", word, "--json"];
        let run = meshmend(&arguments).fails(1, told);
        assert!(fs::metadata(&output).is_ok(), "{word}");
        let report = run.json();
        assert_eq!(report["output"], output.as_str());
        assert_eq!(report["failing"].as_array().unwrap().len(), 1, "{}", report["failing"]);
    }
    // Before it had inconsistent edges and a duplicate face. None is left.
    let output = folder.at("mended.ply");
    let words = "duplicate-face,inconsistent-edge,non-manifold-edge,left,loss:polygons";
    let run = meshmend(&[
        "repair",
        &example("broken.obj"),
        "-o",
        &output,
        "--fail-on",
        words,
        "--seams",
        "corners",
    ]);
    run.succeeds();
    // Quietly, the result is judged all the same.
    let open = folder.with("open.obj", OPEN);
    for words in ["boundary-edge", "crossing-faces,boundary-edge"] {
        let run = meshmend(&["repair", "-q", &open, "-o", &output, "--fail-on", words]);
        run.fails(1, "boundary-edge (3)");
    }
    meshmend(&["repair", "-q", &open, "--dry-run", "--fail-on", "boundary-edge"])
        .fails(1, "boundary-edge (3)");
}

#[test]
fn what_passes_could_not_mend_is_left() {
    let folder = Folder::new();
    let output = folder.at("band.obj");
    for quiet in [&[][..], &["-q"]] {
        let run = meshmend(
            &[&["repair", &example("moebius.off"), "-o", &output, "--fail-on", "left"], quiet].concat(),
        );
        run.fails(1, "left (");
    }
    let cut = ["--non-orientable", "cut"];
    meshmend(&[&["repair", &example("moebius.off"), "-o", &output, "--fail-on", "left"], &cut[..]].concat())
        .succeeds();
}

#[test]
fn strictly_nothing_is_written() {
    let folder = Folder::new();
    let (input, report) = (folder.with("open.obj", OPEN), folder.at("report.json"));
    let output = folder.with("old.obj", "# old\n");
    let strict = ["--strict", "--fail-on", "boundary-edge", "--report", &report];
    let run = meshmend(&[&["repair", &input, "-o", &output], &strict[..]].concat());
    run.fails(1, "open.obj: --fail-on boundary-edge (3); nothing is written");
    assert_eq!(fs::read_to_string(&output).unwrap(), "# old\n");
    let told: serde_json::Value = serde_json::from_str(&fs::read_to_string(&report).unwrap()).unwrap();
    assert_eq!((&told["output"], &told["after"]["file"]), (&json!(null), &json!(null)));
    assert_eq!(told["failing"], json!([{"criterion": "boundary-edge", "count": 3}]));
    // In place, with nothing to complain of.
    meshmend(&["repair", &input, "-o", &input, "--strict", "--fail-on", "left"]).succeeds();
    meshmend(&["repair", &input, "-o", &output, "--strict"]).fails(2, "--fail-on");
}

#[test]
fn the_parts_of_a_file_fail_together() {
    let folder = Folder::new();
    let (two, output) = (folder.at("two.glb"), folder.at("out.glb"));
    let solids = format!("o a\n{OPEN}o b\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 4 5 6\nf 4 5 6\n");
    meshmend(&["convert", &folder.with("two.obj", &solids), &two]).succeeds();
    let run = meshmend(&["repair", &two, "-o", &output, "--json", "--fail-on", "boundary-edge,removed"]);
    let report = run.fails(1, "boundary-edge (6), removed (1 face)").json();
    assert_eq!(report["failing"][0], json!({"criterion": "boundary-edge", "count": 6}));
    fs::remove_file(&output).unwrap();
    let run = meshmend(&["repair", &two, "-o", &output, "--json", "--strict", "--fail-on", "removed"]);
    assert_eq!(run.fails(1, "nothing is written").json()["output"], json!(null));
    assert!(fs::metadata(&output).is_err());
}

#[test]
fn a_conversion_fails_on_losses_and_on_what_a_check_of_it_counts() {
    let folder = Folder::new();
    let (input, output) =
        (folder.with("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"), folder.at("a.stl"));
    let convert = |words: &str| meshmend(&["convert", &input, &output, "--fail-on", words]);
    convert("loss:polygons").fails(1, "loss:polygons (1)");
    convert("boundary-edge,polygon-face").fails(1, "boundary-edge (4), polygon-face (1)");
    convert("loss:layer,pinched-vertex,crossing-faces").succeeds();
    convert("changed").fails(2, "nothing is repaired");
    assert!(fs::metadata(&output).is_ok());
    let strict = folder.at("b.stl");
    let run = meshmend(&["convert", &input, &strict, "--strict", "--fail-on", "loss"]);
    run.fails(1, "nothing is written");
    assert!(fs::metadata(&strict).is_err());
}

#[test]
fn a_word_that_can_never_be_met_is_a_mistake() {
    let folder = Folder::new();
    let input = folder.with("open.obj", OPEN);
    meshmend(&["check", &input, "--fail-on", "loss"]).fails(2, "nothing is written");
    meshmend(&["check", &input, "--fail-on", "left"]).fails(2, "nothing is repaired");
    meshmend(&["repair", &input, "--dry-run", "--fail-on", "loss:color"])
        .fails(2, "there is no kind of loss `color`");
    meshmend(&["repair", &input, "--dry-run", "--fail-on", "hole"]).fails(2, "boundary-edge");
}
