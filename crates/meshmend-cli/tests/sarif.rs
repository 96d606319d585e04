//! `check --sarif`, and what the schema of SARIF says of it.

mod common;

use std::fs;
use std::path::Path;
use std::process::Command;

use common::{Folder, example, meshmend};
use serde_json::{Value, json};

#[test]
fn findings_stand_at_the_lines_of_the_file() {
    let folder = Folder::new();
    let twice = folder.with("a b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\nf 2 3 1\n");
    let run = meshmend(&["check", "--sarif", &twice]);
    assert_eq!(run.status, 1);
    let document = run.json();
    let results = document["runs"][0]["results"].as_array().unwrap();
    let duplicate = results.iter().find(|result| result["ruleId"] == "duplicate-face").unwrap();
    let place = &duplicate["locations"][0]["physicalLocation"];
    assert_eq!(place["region"], json!({"startLine": 6}));
    let uri = place["artifactLocation"]["uri"].as_str().unwrap();
    assert!(uri.starts_with("file:///") && uri.ends_with("/a%20b.obj"), "{uri}");
    let rules = document["runs"][0]["tool"]["driver"]["rules"].as_array().unwrap();
    assert!(rules.iter().any(|rule| rule["id"] == "duplicate-face" && rule["help"]["text"].is_string()));
    // STL has no lines, and standard input is read once.
    let soup = meshmend(&["check", "--sarif", &example("soup.stl"), "--fail-on", "boundary-edge"]).json();
    assert!(
        soup["runs"][0]["results"]
            .as_array()
            .unwrap()
            .iter()
            .all(|r| r["locations"][0]["physicalLocation"].get("region").is_none())
    );
    meshmend(&["check", "--sarif", "--json", &twice]).fails(2, "--sarif");
}

#[test]
fn several_files_are_one_document_and_failures_are_in_it() {
    let folder = Folder::new();
    let (bad, missing) = (folder.with("bad.obj", "v 0 0 x\n"), folder.at("none.ply"));
    let run = meshmend(&["check", "--sarif", &example("broken.obj"), &bad, &missing, "--limit", "2"]);
    assert_eq!(run.status, 3);
    let document = run.json();
    let invocation = &document["runs"][0]["invocations"][0];
    assert_eq!(invocation["executionSuccessful"], json!(false));
    let told = invocation["toolExecutionNotifications"].as_array().unwrap();
    assert!(told.len() == 2 && told[0]["message"]["text"].as_str().unwrap().contains("bad.obj:1"));
    let counts = document["runs"][0]["properties"]["counts"].as_array().unwrap();
    assert!(
        counts.iter().any(|count| count["kind"] == "inconsistent-edge" || count["count"].as_u64() > Some(2))
    );
}

#[test]
fn a_repair_tells_what_is_left() {
    let folder = Folder::new();
    let output = folder.at("band.obj");
    let document = meshmend(&["repair", &example("moebius.off"), "-o", &output, "--sarif"]).succeeds().json();
    let rules: Vec<&Value> =
        document["runs"][0]["results"].as_array().unwrap().iter().map(|result| &result["ruleId"]).collect();
    assert!(rules.contains(&&json!("non-orientable-patch")), "{rules:?}");
    let quiet =
        meshmend(&["repair", "-q", &example("moebius.off"), "-o", &output, "--sarif"]).succeeds().json();
    assert_eq!(quiet, document);
    assert!(fs::metadata(&output).is_ok());
}

#[test]
fn the_schema_of_sarif_finds_nothing_wrong() {
    let node = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/node");
    if !node.join("node_modules/ajv").is_dir() {
        eprintln!("skipped: the validator of JSON schemas is not installed (npm ci in tests/node)");
        return;
    }
    let folder = Folder::new();
    let two = folder.at("two.glb");
    let solids =
        "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no b\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 4 5 6\nf 4 5 6\n";
    meshmend(&["convert", &folder.with("two.obj", solids), &two]).succeeds();
    let (bad, broken, band) =
        (folder.with("bad.obj", "v 0 0 x\n"), example("broken.obj"), example("moebius.off"));
    let runs: [&[&str]; 4] = [
        &[&broken, &band, "--geometry"],
        &[&bad, &two, "--limit", "1"],
        &[&example("pinched.ply"), "--fail-on", "boundary-edge,polygon-face"],
        &[&folder.with("empty.obj", "")],
    ];
    let mut files = Vec::new();
    for (number, run) in runs.iter().enumerate() {
        let document = meshmend(&[&["check", "--sarif"], *run].concat());
        files.push(folder.with(&format!("{number}.sarif"), &document.stdout));
    }
    let mut wrong: Value = serde_json::from_str(&fs::read_to_string(&files[0]).unwrap()).unwrap();
    wrong["runs"][0]["results"][0]["level"] = json!("bad");
    files.push(folder.with("wrong.sarif", &wrong.to_string()));
    let schema = node.join("../data/sarif-2.1.0.json");
    let judged = Command::new("node").arg(node.join("sarif.js")).arg(schema).args(&files).output().unwrap();
    assert!(judged.status.success(), "{}", String::from_utf8_lossy(&judged.stderr));
    let answers: Vec<Value> = String::from_utf8(judged.stdout)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(answers[..runs.len()], vec![json!([]); runs.len()]);
    assert_ne!(answers[runs.len()], json!([]), "the schema sees a word that is none");
}
