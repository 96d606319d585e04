//! `meshmend matrix`, as a user runs it.

mod common;

use common::{Folder, example, meshmend};
use serde_json::{Value, json};

const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

fn tetrahedron(folder: &Folder) -> String {
    folder.with("tetrahedron.obj", TETRAHEDRON)
}

#[test]
fn the_matrices_and_every_answer_in_words() {
    let folder = Folder::new();
    let file = tetrahedron(&folder);
    let questions = ["--walks", "4", "--from", "v0", "--spectrum", "4", "--rank", "2,3,Q", "--link", "v0"];
    let text = meshmend(&[&["matrix", &file], &questions[..]].concat()).succeeds().stdout;
    for line in [
        "  ∂₁  4 × 6  12 not 0  240 bytes with ∂₂",
        "  A   4 × 4  12 not 0  68 bytes",
        "  ∂₁∂₂                              0",
        "  cycles of three edges, tr A³ / 6  4",
        "  Z/3         3        3   1   0   1",
        "walks of length 4 from v0",
        "  to v0  21",
        "largest eigenvalues of the adjacency matrix",
        "   3.000000000  within ",
        "  -1.000000000  within ",
        "link of v0",
        "  vertices  3  v1, v2, v3",
        "  edges     3  e3 v1-v2, e4 v1-v3, e5 v2-v3",
        "  a complex of dimension 1",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
}

#[test]
fn the_form_for_programs() {
    let folder = Folder::new();
    let file = tetrahedron(&folder);
    let questions = [
        "--json",
        "--spectrum",
        "2",
        "--of",
        "laplacian",
        "--star",
        "v0,f2",
        "--closure",
        "f0",
        "--boundary",
        "v1",
    ];
    let found = meshmend(&[&["matrix", &file], &questions[..]].concat()).succeeds().json();
    assert_eq!(
        (&found["schema"], &found["view"], &found["walks"]),
        (&json!(2), &json!("indexed"), &json!(null))
    );
    assert_eq!(found["d1"], json!({"rows": 4, "columns": 6, "entries": 12}));
    let values: Vec<f64> = found["spectrum"]["values"]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| v["value"].as_f64().unwrap())
        .collect();
    assert!(values[0].abs() < 1e-9 && (values[1] - 4.0).abs() < 1e-9, "{values:?}");
    let rounds = found["neighbourhoods"].as_array().unwrap();
    let kinds: Vec<&Value> = rounds.iter().map(|round| &round["kind"]).collect();
    assert_eq!(kinds, ["star", "closure", "boundary"]);
    assert_eq!(rounds[0]["of"], json!(["v0", "f2"]));
    assert_eq!(rounds[0]["faces"]["count"], 4);
    assert_eq!((&rounds[1]["pure_dimension"], &rounds[2]["vertices"]["count"]), (&json!(2), &json!(0)));
    // The same bytes on every run and for any number of threads.
    let bytes =
        |threads| meshmend(&["matrix", &file, "--json", "--spectrum", "3", "--threads", threads]).stdout;
    assert_eq!(bytes("1"), bytes("4"));
}

#[test]
fn soups_are_welded_and_lists_are_cut() {
    let found = meshmend(&["matrix", &example("soup.stl"), "--json", "--rank", "2"]).succeeds().json();
    let check = meshmend(&["check", "--json", &example("soup.stl")]).json();
    assert_eq!((&found["view"], &found["ranks"][0]["betti"]), (&json!("welded"), &check["betti"]["z2"]));
    let folder = Folder::new();
    let file = tetrahedron(&folder);
    let text = meshmend(&["matrix", &file, "--star", "v0", "--limit", "1"]).succeeds().stdout;
    assert!(text.contains("  edges     3  e0 v0-v1, … and 2 more"), "{text}");
}

#[test]
fn matrices_are_written_for_numerical_programs() {
    let folder = Folder::new();
    let file = tetrahedron(&folder);
    for (of, line) in [("d1", "4 6 12"), ("d2", "6 4 12"), ("adjacency", "4 4 6"), ("laplacian", "4 4 10")] {
        let out = folder.at(&format!("{of}.mtx"));
        meshmend(&["matrix", &file, "--of", of, "--matrix-market", &out]).succeeds();
        let text = std::fs::read_to_string(&out).unwrap();
        assert!(text.starts_with("%%MatrixMarket matrix coordinate integer "), "{text}");
        assert_eq!(text.lines().nth(2), Some(line));
    }
    meshmend(&["matrix", &file, "--matrix-market", &file]).fails(2, "would overwrite the input");
    meshmend(&["matrix", &file, "--matrix-market", &folder.at("no/a.mtx")]).fails(4, "a.mtx");
    meshmend(&["matrix", &file, "--matrix-market", "-", "--json"])
        .fails(2, "--json prints to standard output");
    let streamed = meshmend(&["matrix", &file, "--matrix-market", "-"]);
    assert!(streamed.stdout.starts_with("%%MatrixMarket") && streamed.stderr.contains("∂₁∂₂"));
}

#[test]
fn what_is_refused() {
    let folder = Folder::new();
    let file = tetrahedron(&folder);
    for (arguments, status, message) in [
        (&["--star", "v99"][..], 2, "there is no v99 in the mesh"),
        (&["--link", "v0,e6"], 2, "there is no e6 in the mesh"),
        (&["--closure", "f4"], 2, "there is no f4 in the mesh"),
        (&["--star", "c0"], 2, "expected the name of a cell, such as v3, e7 or f0"),
        (&["--walks", "3", "--from", "v4"], 2, "there is no v4 in the mesh"),
        (&["--walks", "3"], 2, "--from"),
        (&["--from", "v0"], 2, "--walks"),
        (&["--walks", "-1", "--from", "v0"], 2, "-1"),
        (&["--walks", "1000", "--from", "v0"], 5, "there are 2^128 walks of length 1000 from v0"),
        (&["--walks", "4294967295", "--from", "v0"], 5, "2^128"),
        (&["--rank", "4"], 2, "4 is not a prime number"),
        (&["--rank", "2,,3"], 2, "expected a prime number"),
        (&["--rank", "R"], 2, "expected a prime number below 2^32, or Q"),
        (&["--spectrum", "0"], 2, "1..=32"),
        (&["--spectrum", "33"], 2, "1..=32"),
        (&["--spectrum", "2", "--of", "d1"], 2, "--of adjacency or --of laplacian"),
        (&["--of", "laplacian"], 2, "neither is given"),
        (&["--boundary", "f0"], 2, "--closure shows what is missing"),
        (&["--format", "gltf3"], 2, "the formats are"),
    ] {
        let run = meshmend(&[&["matrix", &file], arguments].concat()).fails(status, message);
        assert_eq!(run.stdout, "", "{arguments:?}");
    }
    let unknown = folder.with("unknown", "hello");
    meshmend(&["matrix", &unknown]).fails(3, "the format is not known");
    meshmend(&["matrix", &unknown, "--format", "off"]).fails(3, "unknown");
    meshmend(&["matrix", &folder.at("missing.obj")]).fails(3, "missing.obj");
    let torus = folder.at("torus.obj");
    meshmend(&["make", "torus", "--resolution", "30", "-o", &torus]);
    meshmend(&["matrix", &torus, "--rank", "2,Q"]).fails(5, "up to 2000 cells, and there are 3600");
}

#[test]
fn a_face_that_cancels_and_a_face_that_is_none() {
    let folder = Folder::new();
    let file = folder.with("odd.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 2\nf 1 1 2\n");
    let text = meshmend(&["matrix", &file, "--rank", "Q"]).succeeds().stdout;
    for line in [
        "sides that cancel in ∂₂",
        "  f0 runs along e0 v0-v1 both ways",
        "vertices without a neighbour      1",
    ] {
        assert!(text.contains(line), "{line}\n{text}");
    }
    meshmend(&["matrix", &file, "--star", "f1"]).fails(2, "f1 is degenerate");
    assert!(meshmend(&["matrix", &file, "--link", "v3"]).succeeds().stdout.contains("  vertices  0"));
}
