//! `meshmend incremental`, and the options of others about patches that are not orientable, as a user runs them.

mod common;

use common::{Folder, example, group, meshmend};
use serde_json::json;

/// A band of five triangles that comes back mirrored.
const BAND: &str =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 4 3\nf 3 4 5\nf 4 1 5\nf 5 1 2\n";

#[test]
fn each_step_says_what_it_does() {
    let folder = Folder::new();
    let triangle = folder.with("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let text = meshmend(&["incremental", &triangle]).succeeds().stdout;
    for line in [
        "Betti numbers mod 2 in the end: 1 0 0",
        "  vertices that start a component  3",
        "  faces that fill a loop           1",
        "  cell  what it does          β₀  β₁  β₂",
        "  e0    joins two components   2   0   0",
        "  e1    starts a loop          1   1   0",
        "  f0    fills a loop           1   0   0",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    let text = meshmend(&["incremental", &triangle, "--limit", "2"]).succeeds().stdout;
    assert!(text.contains("… and 5 more") && !text.contains("e0"), "{text}");
}

#[test]
fn it_ends_at_the_figures_of_check() {
    for file in ["broken.obj", "moebius.off", "pinched.ply", "soup.stl"].map(example) {
        let check = meshmend(&["check", "--json", &file]).json();
        let built = meshmend(&["incremental", "--json", &file]).succeeds().json();
        assert_eq!(built["betti"], check["betti"]["z2"], "{file}");
        assert_eq!((&built["instigators"], &built["view"]), (&check["instigators"], &check["view"]));
        assert_eq!((&built["betti_unknown"], &built["schema"]), (&json!(null), &json!(2)));
        let counts = ["vertices", "edges", "faces"].map(|key| check[key].as_u64().unwrap());
        assert_eq!(built["steps"]["count"], counts.iter().sum::<u64>());
    }
}

#[test]
fn the_plot_is_written_whole_or_not_at_all() {
    let folder = Folder::new();
    let plot = folder.at("plot.svg");
    meshmend(&["incremental", &example("moebius.off"), "--plot", &plot]).succeeds();
    let svg = std::fs::read_to_string(&plot).unwrap();
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n") && svg.contains("β₂ (voids)"));
    let nowhere = folder.at("no/plot.svg");
    meshmend(&["incremental", &example("moebius.off"), "--plot", &nowhere]).fails(4, "plot.svg");
    meshmend(&["incremental", &folder.at("missing.obj")]).fails(3, "missing.obj");
}

#[test]
fn a_witness_can_be_a_shortest_one() {
    let folder = Folder::new();
    let band = folder.with("band.obj", BAND);
    let strip = |options: &[&str]| {
        let check = meshmend(&[&["check", "--json", &band], options].concat()).json();
        let faces = group(&check, "non-orientable-patch")["items"][0]["faces"].as_array().unwrap().len();
        (check["witness"].clone(), faces)
    };
    assert_eq!(strip(&[]), (json!("breadth-first"), 5));
    assert_eq!(strip(&["--witness", "shortest"]), (json!("shortest"), 5));
    meshmend(&["check", &band, "--witness", "tall"]).fails(2, "shortest");
}

#[test]
fn a_seam_is_reported_with_its_length_and_what_it_added() {
    let folder = Folder::new();
    let band = folder.with("band.obj", BAND);
    let arguments = ["repair", &band, "--dry-run", "--non-orientable", "cut"];
    let text = meshmend(&arguments).succeeds().stdout;
    assert!(text.contains("cut open: 1 edge and 2 vertices added"), "{text}");
    let report = meshmend(&[&arguments[..], &["--json"]].concat()).succeeds().json();
    let split = &report["passes"][3];
    assert_eq!((&split["pass"], &report["passes"][2]["seam"]), (&json!("split"), &json!(null)));
    assert_eq!(
        (&split["seam"]["edges"], &split["seam"]["edges_added"], &split["seam"]["vertices_added"]),
        (&json!(1), &json!(1), &json!(2))
    );
    assert!(split["seam"]["length"].as_f64().unwrap() > 0.9);
}
