//! A pass of one's own, outside the crates of meshmend: one file and one row, and plans, the command line, `explain` and
//! reports know it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_cli::{Program, Status};
use meshmend_repair::{PassKind, Passes, Pipeline, Plan};
use meshmend_testkit::Soup;
use meshmend_tests::contributing::Example;
use meshmend_tests::in_process;
use meshmend_tests::scratch::Scratch;
use serde_json::Value;

macro_rules! own_passes {
    ($($file:ident)*) => {
        $(mod $file;)*

        fn passes() -> Passes {
            Passes::with(&[$(&$file::ROW),*]).unwrap()
        }
    };
}

own_passes! {
    stand_by
}

/// The pass of the example, by the name that its row gives it.
fn own() -> PassKind {
    passes().own().next().unwrap()
}

/// How a run of the program with these passes ended, and what it printed.
fn run(arguments: &[&str]) -> (Status, String, String) {
    in_process::run(Program::default().with_passes(passes()), arguments)
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The passes that a dry repair of a triangle with these options runs.
fn passes_run(options: &[&str]) -> Vec<String> {
    let scratch = Scratch::new();
    let triangle = scratch.file("triangle.obj", TRIANGLE);
    let (status, text, errors) = run(&[&["repair", &triangle, "--dry-run", "--json"], options].concat());
    assert_eq!(status, Status::Done, "{errors}");
    let document: Value = serde_json::from_str(&text).unwrap();
    let passes = document["passes"].as_array().unwrap();
    passes.iter().map(|pass| pass["pass"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn its_option_has_it_run_at_its_place() {
    let option = format!("--{}", own().name());
    let usual = ["weld", "clean", "orient", "split", "triangulate", "compact", "verify"];
    assert_eq!(passes_run(&[]), usual);
    assert_eq!(passes_run(&[&option, "off"]), usual);
    let with_it = ["weld", "clean", "orient", "split", "triangulate", own().name(), "compact", "verify"];
    assert_eq!(passes_run(&[&option, "deep"]), with_it);
    let (status, _, errors) = run(&["repair", "x.obj", "--dry-run", &option, "forever"]);
    assert!(status == Status::Usage && errors.contains("light, deep, off"), "{errors}");
    let (_, help, _) = run(&["repair", "--help"]);
    assert!(help.contains(&option) && help.contains(own().row().options[0].help), "{help}");
    assert!(run(&["completions", "bash"]).1.contains(&option));
}

#[test]
fn a_plan_names_it_with_its_options() {
    let scratch = Scratch::new();
    let (name, triangle) = (own().name(), scratch.file("triangle.obj", TRIANGLE));
    let plan = scratch.file("plan.toml", &format!("passes = ['weld', '{name}']\n[{name}]\ndepth = 'deep'\n"));
    assert_eq!(passes_run(&["--plan", &plan]), ["weld", name]);
    let wrong = scratch.file("wrong.toml", &format!("passes = ['{name}']\n\n[{name}]\ndepth = 'forever'\n"));
    let (status, _, errors) = run(&["repair", &triangle, "--dry-run", "--plan", &wrong]);
    assert_eq!(status, Status::Usage);
    assert!(errors.contains("line 3") && errors.contains("unknown variant `forever`"), "{errors}");

    let read = Plan::from_toml_with(&std::fs::read_to_string(&plan).unwrap(), passes()).unwrap();
    let written = toml::to_string(&read).unwrap();
    assert!(written.contains("depth = \"deep\""), "{written}");
    assert_eq!(Plan::from_toml_with(&written, passes()).unwrap(), read);
    let unknown = Plan::from_toml(&written).unwrap_err().to_string();
    assert!(unknown.contains(&format!("there is no pass `{name}`")), "{unknown}");
}

#[test]
fn a_report_and_explain_say_what_it_does() {
    let scratch = Scratch::new();
    let (name, triangle) = (own().name(), scratch.file("triangle.obj", TRIANGLE));
    let (_, text, _) = run(&["repair", &triangle, "--dry-run", &format!("--{name}"), "light"]);
    assert!(text.contains(&format!("  {name:<12}nothing to do")), "{text}");
    let (status, text, _) = run(&["explain", name]);
    assert!(status == Status::Done && text.contains(own().explanation()), "{text}");
    assert!(run(&["explain"]).1.contains(&format!("\n  {name}\n")));
}

#[test]
fn it_enters_a_pipeline() {
    let mesh = Soup::generic(3, [[0, 1, 2]]).mesh();
    let last = Pipeline::default().then(own().with_defaults());
    let at_its_place = Pipeline::default().with(own().with_defaults());
    let names = |pipeline: Pipeline| -> Vec<&str> {
        pipeline.run(&mesh).unwrap().passes.iter().map(|record| record.pass.name()).collect()
    };
    assert_eq!(names(last).last(), Some(&own().name()));
    assert_eq!(names(at_its_place)[5], own().name());
}

fn example() -> Example {
    Example::beside_main("tests/own_pass", "own_passes")
}

#[test]
fn the_diff_that_is_shown_is_true() {
    example().assert_shown();
}

#[test]
fn a_pass_is_one_file_and_one_row() {
    example().assert_said_nowhere_else(&[]);
}
