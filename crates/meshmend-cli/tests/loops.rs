//! Loops and cuts, as a user runs them.

mod common;

use std::fs;

use common::{Folder, example, meshmend};
use serde_json::json;

/// A torus of 4 × 3 quads, and apart from it a tetrahedron.
fn torus_and_sphere() -> String {
    let mut text = String::new();
    for (i, j) in (0..4).flat_map(|i| (0..3).map(move |j| (i, j))) {
        let (u, v) = (f64::from(i) * std::f64::consts::FRAC_PI_2, f64::from(j) * std::f64::consts::TAU / 3.0);
        let radius = 3.0 + v.cos();
        text.push_str(&format!("v {} {} {}\n", radius * u.cos(), radius * u.sin(), v.sin()));
    }
    text.push_str("v 9 0 0\nv 10 0 0\nv 9 1 0\nv 9 0 1\n");
    for (i, j) in (0..4).flat_map(|i| (0..3).map(move |j| (i, j))) {
        let at = |i: i32, j: i32| 1 + 3 * (i % 4) + j % 3;
        text.push_str(&format!("f {} {} {} {}\n", at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)));
    }
    text + "f 13 15 14\nf 13 14 16\nf 14 15 16\nf 15 13 16\n"
}

#[test]
fn loops_are_told_with_their_kind_length_and_vertices() {
    let folder = Folder::new();
    let file = folder.with("a.obj", &torus_and_sphere());
    let report = meshmend(&["loops", "--json", "--hops", "--greedy", &file]).succeeds().json();
    assert_eq!((&report["components_total"], &report["loops_total"]), (&json!(2), &json!(2)));
    let [torus, sphere] = [0, 1].map(|place| &report["components"][place]);
    assert_eq!((&torus["name"], &sphere["name"]), (&json!("torus"), &json!("sphere")));
    let lengths: Vec<_> = torus["loops"].as_array().unwrap().iter().map(|l| &l["length"]).collect();
    assert!(lengths.contains(&&json!(3.0)) && lengths.contains(&&json!(4.0)), "{torus}");
    assert!(
        torus["loops"].as_array().unwrap().iter().all(|l| l["kind"] == "handle" && l["two_sided"] == true)
    );
    let text = meshmend(&["loops", &file]).succeeds().stdout;
    assert!(
        text.contains("component 0: torus, from v0") && text.contains("every closed path bounds"),
        "{text}"
    );
    let short = meshmend(&["loops", "--limit", "1", &file]).succeeds().stdout;
    assert!(short.contains("and 1 component more"), "{short}");
}

#[test]
fn roots_are_chosen_and_must_be_there() {
    let folder = Folder::new();
    let file = folder.with("a.obj", &torus_and_sphere());
    let root = |arguments: &[&str]| {
        let report = meshmend(&[&["loops", "--json", &file], arguments].concat()).succeeds().json();
        report["components"][0]["root"].clone()
    };
    assert_eq!((root(&[]), root(&["--root", "5"])), (json!(0), json!(5)));
    // The innermost ring is the shortest, and its vertices come second of three.
    assert_ne!(root(&["--roots", "12", "--greedy"]), json!(0));
    meshmend(&["loops", "--root", "99", &file]).fails(2, "v99 is in no face");
    meshmend(&["cut", "--root", "99", &file, "-o", &folder.at("b.obj")]).fails(2, "v99 is in no face");
    meshmend(&["loops", "--root", "1", "--roots", "2", &file]).fails(2, "--roots");
    meshmend(&["loops", "--roots", "0", &file]).fails(2, "--roots");
}

#[test]
fn a_component_that_is_no_surface_is_told_and_not_cut() {
    let folder = Folder::new();
    let file = example("pinched.ply");
    let report = meshmend(&["loops", "--json", &file]).succeeds().json();
    assert_eq!(report["components"][0]["obstacle"]["kind"], "pinched-vertex");
    let text = meshmend(&["loops", &file]).succeeds().stdout;
    assert!(text.contains("component 0 is not a surface\n  v0 joins 2 umbrellas"), "{text}");
    meshmend(&["cut", &file, "-o", &folder.at("a.ply")]).fails(5, "only a surface can be cut");
    assert!(folder.names().is_empty());
}

#[test]
fn a_cut_mesh_is_a_disc_and_its_word_says_what_it_was() {
    let folder = Folder::new();
    let (file, output) = (folder.with("a.obj", &torus_and_sphere()), folder.at("b.ply"));
    let report = meshmend(&["cut", "--json", &file, "-o", &output]).succeeds().json();
    for (place, name) in ["torus", "sphere"].iter().enumerate() {
        let component = &report["components"]["items"][place];
        assert_eq!(
            (&component["name"], &component["after"], &component["glued"]),
            (&json!(name), &json!("disc"), &json!(name))
        );
    }
    let after = meshmend(&["check", "--json", &output]).json();
    assert_eq!((&after["euler_characteristic"], &after["boundary_loops"]), (&json!(2), &json!(2)));
    let edges = after["boundary_edges"].as_u64().unwrap();
    assert_eq!(report["seams"]["count"].as_u64().unwrap() * 2, edges);
    let text = meshmend(&["cut", "--along", "generators", &file, "-o", &output]).succeeds().stdout;
    assert!(text.contains("cut along generators") && text.contains("became"), "{text}");
    let open = folder.with("c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    meshmend(&["cut", "--along", "generators", &open, "-o", &output]).fails(5, "has a boundary");
    meshmend(&["cut", &open, "-o", &folder.at("d.fbx")]).fails(2, "d.fbx");
    meshmend(&["cut", &folder.at("none.obj"), "-o", &output]).fails(3, "none.obj");
}

#[test]
fn stl_is_taken_as_welded() {
    let folder = Folder::new();
    let (file, soup) = (folder.with("a.obj", &torus_and_sphere()), folder.at("a.stl"));
    meshmend(&["convert", &file, &soup]).succeeds();
    let report = meshmend(&["loops", "--json", &soup]).succeeds().json();
    assert_eq!((&report["view"], &report["loops_total"]), (&json!("welded"), &json!(2)));
    let cut = meshmend(&["cut", "--json", &soup, "-o", &folder.at("b.off")]).succeeds().json();
    assert_eq!(cut["components"]["count"], 2);
    assert!(fs::read_to_string(folder.at("b.off")).unwrap().starts_with("OFF"));
}
