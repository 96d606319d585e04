//! Attributes in the eyes of others: an independent checker of files before and after, MeshLab and VTK.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use meshmend_tests::corpus::corpus;
use meshmend_tests::each::assert_each;
use meshmend_tests::judge::python;
use meshmend_tests::program::run;
use meshmend_tests::scratch::Scratch;
use meshmend_tests::shared::shared;
use rayon::prelude::*;
use serde_json::Value;

/// How many pairs one run of the checker looks at.
const PAIRS_A_RUN: usize = 60;
/// Larger files take the checker too long for each run of the tests.
const MOST_BYTES: u64 = 10_000;
/// How near numbers must be after a conversion. The checker rounds to multiples of it, so it is none that a file of six
/// or seven decimals has halves of.
const NUMERIC: &str = "7.38913e-6";

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

/// Two files to compare, what the program said when it made the second, and the checker's options.
struct Pair {
    before: PathBuf,
    after: PathBuf,
    report: String,
    options: Vec<&'static str>,
}

impl Pair {
    /// The words of the checker's command line.
    fn words(&self) -> Vec<String> {
        let fixed = ["--ignore", "materials", "--ignore", "mtllib"].into_iter();
        let mut words: Vec<String> = fixed.chain(self.options.iter().copied()).map(str::to_owned).collect();
        words.extend(named(&self.report).into_iter().flat_map(|name| ["--allow-missing".to_owned(), name]));
        words.extend([&self.before, &self.after].map(|path| path.to_string_lossy().into_owned()));
        words
    }

    /// The differences that the report did not name.
    fn unnamed(&self, findings: &Value) -> Vec<String> {
        let names = named(&self.report);
        let is_named = |what: &str| names.iter().any(|name| what.contains(&format!("`{name}`")));
        let wrong = findings["wrong"].as_array().into_iter().flatten();
        let what = wrong.filter_map(|wrong| wrong["what"].as_str());
        // A face that is cut otherwise than the checker knows is no matter of attributes.
        let what = what.filter(|what| !is_named(what) && !what.contains("no face of BEFORE explains"));
        what.map(|what| format!("{} → {}: {what}", self.before.display(), self.after.display())).collect()
    }
}

/// Compares the pairs that come as lines of JSON, and writes a line about each; a file before that the checker does not
/// read is no finding.
const MANY: &str = "import importlib.util, json, sys
spec = importlib.util.spec_from_file_location('checker', sys.argv[1])
checker = importlib.util.module_from_spec(spec); spec.loader.exec_module(checker)
for line in sys.stdin:
    options = checker.parser().parse_args(json.loads(line))
    before, after = options.files
    try:
        before = checker.read(before)
    except checker.Unreadable:
        print('{}'); continue
    try:
        wrong = checker.compare(before, checker.read(after), options).wrong
    except checker.Unreadable as error:
        wrong = [{'what': str(error)}]
    print(json.dumps({'wrong': wrong}))";

/// What the checker says of some pairs of files. Its start is slow, so that it looks at many in one run.
fn compared(python: &str, checker: &Path, pairs: &[Pair]) -> Vec<String> {
    let mut command = Command::new(python);
    command.env("PYTHONDONTWRITEBYTECODE", "1").args(["-c", MANY]).arg(checker);
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let lines = pairs.iter().map(|pair| serde_json::to_string(&pair.words()).unwrap() + "\n");
    let text: String = lines.collect();
    // A thread writes, as the answers may fill their pipe before all is written.
    let mut stdin = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || stdin.write_all(text.as_bytes()));
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let findings: Vec<Value> = said.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(findings.len(), pairs.len(), "the checker gave up");
    pairs.iter().zip(&findings).flat_map(|(pair, findings)| pair.unnamed(findings)).collect()
}

/// Makes the pairs of each input, and has them compared.
fn assert_no_unnamed_difference(inputs: Vec<Input>, pairs_of: impl Fn(usize, &Input) -> Vec<Pair> + Sync) {
    let (Some(checker), Some(python)) = (shared("tools/check_attributes.py"), python()) else { return };
    let pairs: Vec<Pair> =
        inputs.par_iter().enumerate().flat_map_iter(|(number, input)| pairs_of(number, input)).collect();
    println!("{} pairs of files", pairs.len());
    let runs: Vec<&[Pair]> = pairs.chunks(PAIRS_A_RUN).collect();
    assert_each(&runs, |pairs| compared(python, &checker, pairs));
}

#[test]
fn conversions_keep_every_value_or_name_it() {
    let scratch = Scratch::new();
    // The checker knows attributes of scenes and properties of 3MF by names of their own, which no other format has.
    let is_wanted = |input: &Input| !["3mf", "glb", "gltf"].contains(&input.extension.as_str());
    assert_no_unnamed_difference(inputs().into_iter().filter(is_wanted).collect(), |number, input| {
        let pair = |extension| {
            let after = scratch.path().join(format!("{number}.{extension}"));
            let done = run([Path::new("convert"), &input.path, &after]);
            assert!(done.status.success(), "{}", input.path.display());
            let report = String::from_utf8_lossy(&done.stdout).into_owned();
            let mut options = vec!["--flipped-normals", "keep"];
            if extension != input.extension {
                options.extend(["--numeric", NUMERIC]);
            }
            if extension == "stl" {
                options.extend(["--positions", "f32"]);
            }
            if extension == "obj" {
                // Its numbers are the names of materials there.
                options.extend(["--allow-missing", "texnumber"]);
            }
            Pair { before: input.path.clone(), after, report, options }
        };
        ["obj", "ply", "off", "stl"].map(pair).into()
    });
}

/// The words that follow the files of a repair.
const POLICIES: [&[&str]; 8] = [
    &[],
    &["--orient", "outward", "--triangulate", "all"],
    &["--split", "cut", "--non-orientable", "cut"],
    &["--split", "pinch-only", "--clean", "off"],
    &["--weld", "none", "--compact", "off"],
    &["--flipped-normals", "keep"],
    &["--duplicates", "remove-pair", "--orient", "outward-nested"],
    &["--seams", "corners"],
];

#[test]
fn repairs_with_any_policy_keep_every_value() {
    let scratch = Scratch::new();
    let is_wanted = |input: &Input| input.extension != "stl";
    assert_no_unnamed_difference(inputs().into_iter().filter(is_wanted).collect(), |number, input| {
        let pair = |(policy, words): (usize, &&[&str])| {
            let after = scratch.path().join(format!("{number}-{policy}.{}", input.extension));
            let files = [Path::new("repair"), &input.path, Path::new("-o"), &after];
            let done = run(files.into_iter().chain(words.iter().map(Path::new)));
            let report = String::from_utf8_lossy(&done.stdout).into_owned();
            let turned = if words.contains(&"keep") { "keep" } else { "negate" };
            let options = vec!["--flipped-normals", turned];
            let pair = Pair { before: input.path.clone(), after, report, options };
            // Nothing would be left, or a policy refuses what is there: then no file is written.
            (done.status.code() != Some(5)).then_some(pair)
        };
        POLICIES.iter().enumerate().filter_map(pair).collect()
    });
}

const SOLID: &str = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nvt 0.5 0.5\n\
                     vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 3/3/1 2/2/1 4/4/1\n";

/// What each program sees of colours, normals and texture coordinates, in that order, in each file.
const MESHLAB: &str = "import pymeshlab, sys
for name in sys.argv[1:]:
    s = pymeshlab.MeshSet(); s.load_new_mesh(name); c = s.current_mesh()
    n = c.vertex_normal_matrix()
    print(c.has_vertex_color(), abs(n[:, 2]).min() > 0.5, c.has_vertex_tex_coord() or c.has_wedge_tex_coord())";
const VTK: &str = "import vtk, sys
for name in sys.argv[1:]:
    r = vtk.vtkPLYReader(); r.SetFileName(name); r.Update(); p = r.GetOutput().GetPointData()
    c = p.GetArray('RGB')
    is_red = c is not None and c.GetTuple3(0) == (255.0, 0.0, 0.0)
    print(is_red, p.GetNormals() is not None, p.GetTCoords() is not None)";

#[test]
fn meshlab_and_vtk_see_the_attributes_of_an_obj_in_a_ply() {
    let Some(python) = python() else { return };
    let scratch = Scratch::new();
    let seam = SOLID.replace("f 3/3/1 2/2/1", "f 3/4/1 2/1/1");
    let polygon = SOLID.replace("f 1/1/1 2/2/1 3/3/1\nf 3/3/1 2/2/1 4/4/1\n", "f 1/1/1 2/2/1 4/4/1 3/3/1\n");
    let mut outputs = Vec::new();
    for (name, text) in [("smooth", SOLID), ("seam", &seam), ("polygon", &polygon)] {
        let input = scratch.path().join(format!("{name}.obj"));
        std::fs::write(&input, text).unwrap();
        for encoding in ["ascii", "le"] {
            let output = scratch.path().join(format!("{name}_{encoding}.ply"));
            let words = [Path::new("convert"), &input, &output, Path::new("--encoding"), Path::new(encoding)];
            assert!(run(words).status.success());
            outputs.push(output);
        }
    }
    for (program, module, code) in [("MeshLab", "pymeshlab", MESHLAB), ("VTK", "vtk", VTK)] {
        let is_there = Command::new(python).args(["-c", &format!("import {module}")]).output();
        if !is_there.is_ok_and(|output| output.status.success()) {
            println!("skipped: {program} is not installed for Python");
            continue;
        }
        let seen = Command::new(python).args(["-c", code]).args(&outputs).output().unwrap();
        let said = String::from_utf8_lossy(&seen.stdout);
        let seen: Vec<(&PathBuf, &str)> = outputs.iter().zip(said.lines()).collect();
        let all = outputs.iter().map(|output| (output, "True True True")).collect::<Vec<_>>();
        assert_eq!(seen, all, "{program}");
    }
}
