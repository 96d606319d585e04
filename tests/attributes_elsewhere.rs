//! Attributes in the eyes of others: an independent checker of files before and after, MeshLab and VTK.

use std::path::{Path, PathBuf};
use std::process::Command;

use meshmend_tests::corpus::corpus;
use meshmend_tests::each::assert_each;
use meshmend_tests::judge::python;
use meshmend_tests::program::run;
use meshmend_tests::scratch::Scratch;
use meshmend_tests::shared::shared;

/// Larger files take the checker too long for each run of the tests.
const MOST_BYTES: u64 = 10_000;
/// `MESHMEND_ATTRIBUTES` set to a number of bytes takes larger files too.
fn most_bytes() -> u64 {
    std::env::var("MESHMEND_ATTRIBUTES").ok().and_then(|bytes| bytes.parse().ok()).unwrap_or(MOST_BYTES)
}

/// A file with attributes that the checker reads.
struct Input {
    path: PathBuf,
    extension: String,
}

fn inputs() -> Vec<Input> {
    let has_attributes = |path: &Path| {
        let file = meshmend_io::read(path, &meshmend_io::ReadOptions::default());
        file.is_ok_and(|file| !file.mesh.layers().is_empty())
    };
    let is_small = |path: &Path| path.metadata().is_ok_and(|data| data.len() <= most_bytes());
    let entries = corpus().unwrap_or_default().into_iter();
    let entries = entries.filter(|entry| entry.is_read_here() && entry.is_well_formed());
    let paths = entries.map(|entry| entry.path).filter(|path| is_small(path) && has_attributes(path));
    let input = |path: PathBuf| {
        let extension = path.extension().unwrap().to_string_lossy().to_lowercase();
        Input { path, extension }
    };
    paths.map(input).collect()
}

/// The names of the layers that a report says are lost or converted.
fn named(report: &str) -> Vec<String> {
    let mut names: Vec<String> = report
        .split("attribute `")
        .skip(1)
        .filter_map(|rest| rest.split_once('`'))
        .map(|(name, _)| name.to_owned())
        .collect();
    if report.contains("statements `solid`") {
        names.push("object".to_owned());
    }
    // A layer of names is gone when the last of them has no face left, which is named.
    let emptied = ["material", "group", "object"].into_iter();
    let is_emptied = |kind: &&str| {
        let mut lines = report.lines().map(str::trim_start);
        lines.any(|line| line.starts_with(&format!("{kind} `")) && line.contains("no face left"))
    };
    names.extend(emptied.filter(is_emptied).map(str::to_owned));
    names
}

/// What the checker says of two files, where each difference in a layer must be one that the report named.
fn compared(checker: &Path, before: &Path, after: &Path, report: &str, options: &[&str]) -> Vec<String> {
    let Some(python) = python() else { return Vec::new() };
    let mut command = Command::new(python);
    command.env("PYTHONDONTWRITEBYTECODE", "1").arg(checker).args(["--json", "--ignore", "materials"]);
    command.args(["--ignore", "mtllib", "--ignore", "comments"]).args(options);
    let names = named(report);
    for name in &names {
        command.args(["--allow-missing", name]);
    }
    let output = command.arg(before).arg(after).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let Ok(findings) = serde_json::from_str::<serde_json::Value>(&said) else {
        // Status 3: it does not read a form of the input that is read here.
        return if output.status.code() == Some(3) { Vec::new() } else { vec![said.into_owned()] };
    };
    let wrong = findings["wrong"].as_array().cloned().unwrap_or_default();
    let what = wrong.iter().filter_map(|wrong| wrong["what"].as_str());
    let is_named = |what: &&str| names.iter().any(|name| what.contains(&format!("`{name}`")));
    // A face that is cut otherwise than the checker knows is no matter of attributes.
    let what = what.filter(|what| !is_named(what) && !what.contains("no face of BEFORE explains"));
    what.map(|what| format!("{} → {}: {what}", before.display(), after.display())).collect()
}

#[test]
fn conversions_keep_every_value_or_name_it() {
    let Some(checker) = shared("tools/check_attributes.py") else { return };
    let scratch = Scratch::new();
    let inputs: Vec<(usize, Input)> = inputs().into_iter().enumerate().collect();
    assert_each(&inputs, |(number, input)| {
        let mut wrong = Vec::new();
        for extension in ["obj", "ply", "off", "stl"] {
            let output = scratch.path().join(format!("{number}.{extension}"));
            let done = run([Path::new("convert"), &input.path, &output]);
            let report = String::from_utf8_lossy(&done.stdout).into_owned();
            let mut options = vec!["--flipped-normals", "keep"];
            if extension != input.extension {
                options.extend(["--numeric", "1e-5"]);
            }
            if extension == "stl" {
                options.extend(["--positions", "f32"]);
            }
            wrong.extend(compared(&checker, &input.path, &output, &report, &options));
        }
        wrong
    });
}

#[test]
fn repairs_with_any_policy_keep_every_value() {
    let Some(checker) = shared("tools/check_attributes.py") else { return };
    let policies: [&[&str]; 8] = [
        &[],
        &["--orient", "outward", "--triangulate", "all"],
        &["--split", "cut", "--non-orientable", "cut"],
        &["--split", "pinch-only", "--clean", "off"],
        &["--weld", "none", "--compact", "off"],
        &["--flipped-normals", "keep"],
        &["--duplicates", "remove-pair", "--orient", "outward-nested"],
        &["--seams", "corners"],
    ];
    let scratch = Scratch::new();
    let all = inputs().into_iter().enumerate().filter(|(_, input)| input.extension != "stl");
    let inputs: Vec<(usize, Input)> = all.collect();
    assert_each(&inputs, |(number, input)| {
        let mut wrong = Vec::new();
        for policy in policies {
            let output = scratch.path().join(format!("{number}.{}", input.extension));
            let words = [Path::new("repair"), &input.path, Path::new("-o"), &output];
            let done = run(words.into_iter().chain(policy.iter().map(Path::new)));
            if done.status.code() == Some(5) {
                continue;
            }
            let report = String::from_utf8_lossy(&done.stdout).into_owned();
            let turned = if policy.contains(&"keep") { "keep" } else { "negate" };
            wrong.extend(compared(&checker, &input.path, &output, &report, &["--flipped-normals", turned]));
        }
        wrong
    });
}

const SOLID: &str = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n\
                     vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 3/3/1 2/2/1 4/4/1\n";

/// What each program sees of colours, normals and texture coordinates, in that order.
const MESHLAB: &str = "import pymeshlab, sys
s = pymeshlab.MeshSet(); s.load_new_mesh(sys.argv[1]); c = s.current_mesh()
n = c.vertex_normal_matrix()
print(c.has_vertex_color(), abs(n[:, 2]).min() > 0.5, c.has_vertex_tex_coord() or c.has_wedge_tex_coord())";
const VTK: &str = "import vtk, sys
r = vtk.vtkPLYReader(); r.SetFileName(sys.argv[1]); r.Update(); p = r.GetOutput().GetPointData()
c = p.GetArray('RGB')
print(c is not None and c.GetTuple3(0) == (255.0, 0.0, 0.0), p.GetNormals() is not None, p.GetTCoords() is not None)";

#[test]
fn meshlab_and_vtk_see_the_attributes_of_an_obj_in_a_ply() {
    let Some(python) = python() else { return };
    let scratch = Scratch::new();
    let seam = SOLID.replace("f 3/3/1 2/2/1", "f 3/4/1 2/1/1");
    let polygon = SOLID.replace("f 1/1/1 2/2/1 3/3/1\nf 3/3/1 2/2/1 4/4/1\n", "f 1/1/1 2/2/1 4/4/1 3/3/1\n");
    for (name, text) in [("smooth", SOLID), ("seam", &seam), ("polygon", &polygon)] {
        let (input, output) =
            (scratch.path().join(format!("{name}.obj")), scratch.path().join(format!("{name}.ply")));
        std::fs::write(&input, text).unwrap();
        for encoding in ["ascii", "le"] {
            let words = [Path::new("convert"), &input, &output, Path::new("--encoding"), Path::new(encoding)];
            assert!(run(words).status.success());
            for (program, module, code) in [("MeshLab", "pymeshlab", MESHLAB), ("VTK", "vtk", VTK)] {
                let is_there = Command::new(python).args(["-c", &format!("import {module}")]).output();
                if !is_there.is_ok_and(|output| output.status.success()) {
                    println!("skipped: {program} is not installed for Python");
                    continue;
                }
                let seen = Command::new(python).args(["-c", code]).arg(&output).output().unwrap();
                let said = String::from_utf8_lossy(&seen.stdout);
                assert_eq!(said.trim(), "True True True", "{program}, {name} as {encoding}");
            }
        }
    }
}
