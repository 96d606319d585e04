//! Layouts, as a user runs them.

#![cfg(feature = "flatten")]

mod common;

use std::fs;

use common::{Folder, meshmend};

fn made(folder: &Folder, shape: &[&str]) -> String {
    let file = folder.at("shape.off");
    let line: Vec<&str> = ["make"].into_iter().chain(shape.iter().copied()).chain(["-o", &file]).collect();
    meshmend(&line).succeeds();
    file
}

#[test]
fn a_surface_is_cut_and_laid_out_as_texture_coordinates() {
    let folder = Folder::new();
    let (file, out) = (made(&folder, &["surface", "--genus", "2"]), folder.at("out.obj"));
    let run = meshmend(&["flatten", &file, "-o", &out]).succeeds();
    assert!(run.stdout.contains("no face is flipped or has collapsed"), "{}", run.stdout);
    let text = fs::read_to_string(&out).unwrap();
    let vertices = text.lines().filter(|line| line.starts_with("v ")).count();
    let points: Vec<[f64; 2]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("vt "))
        .map(|line| {
            let numbers: Vec<f64> = line.split_whitespace().map(|word| word.parse().unwrap()).collect();
            [numbers[0], numbers[1]]
        })
        .collect();
    assert_eq!(points.len(), vertices);
    assert!(points.iter().all(|[u, v]| (u - 0.5).hypot(v - 0.5) < 0.500_000_1));
    assert_eq!(meshmend(&["check", "--json", &out]).json()["component_kinds"][0]["name"], "disc");
}

#[test]
fn the_report_is_json_too() {
    let folder = Folder::new();
    let (file, out) = (made(&folder, &["torus", "--resolution", "8"]), folder.at("out.obj"));
    let report = meshmend(&["flatten", &file, "-o", &out, "--json", "--boundary", "square"]).json();
    assert_eq!((&report["one_to_one"], &report["boundary"]), (&true.into(), &"square".into()));
    assert_eq!((&report["discs"], &report["opened_edges"]), (&1.into(), &16.into()));
    assert_eq!(report["flipped"], serde_json::json!({"count": 0, "items": []}));
    let again = meshmend(&["flatten", &out, "-o", &out, "--json", "--weights", "harmonic"]).json();
    assert_eq!((&again["replaced_texcoords"], &again["opened_edges"]), (&true.into(), &0.into()));
    assert_eq!(again["weights"], "harmonic");
}

#[test]
fn what_collapses_is_said_and_drawn() {
    let folder = Folder::new();
    let (file, out) = (made(&folder, &["fan", "--count", "40"]), folder.at("out.svg"));
    let run = meshmend(&["flatten", &file, "-o", &out, "--boundary", "square", "--limit", "2"]).succeeds();
    assert!(
        run.stdout.contains("flipped: 0 faces, collapsed: ") && run.stdout.contains("more (--limit)"),
        "{}",
        run.stdout
    );
    let picture = fs::read_to_string(&out).unwrap();
    assert_eq!(picture.matches("<path").count(), 40);
    assert!(picture.contains("class=\"collapsed\""));
}

#[test]
fn what_is_no_surface_is_refused_and_nothing_is_written() {
    let folder = Folder::new();
    let file = made(&folder, &["book"]);
    meshmend(&["flatten", &file, "-o", &folder.at("out.obj")]).fails(5, "only a surface can be cut");
    meshmend(&["flatten", &file, "-o", &folder.at("out.xyz")]).fails(2, "out.xyz");
    meshmend(&["flatten", &folder.at("none.obj"), "-o", &folder.at("out.obj")]).fails(3, "none.obj");
    assert_eq!(folder.names(), ["shape.off"]);
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let folder = Folder::new();
    let file = made(&folder, &["surface", "--cross-caps", "3", "--resolution", "4"]);
    let written = |threads: &str| {
        let out = folder.at("out.obj");
        meshmend(&["--threads", threads, "flatten", &file, "-o", &out]).succeeds();
        fs::read(&out).unwrap()
    };
    let one = written("1");
    assert!(["2", "8"].iter().all(|threads| written(threads) == one));
}
