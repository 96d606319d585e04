//! The other commands, as a user runs them.

mod common;

use std::fs;

use common::{Folder, example, meshmend};

#[test]
fn a_conversion_changes_nothing_and_names_what_is_lost() {
    let folder = Folder::new();
    let (ply, back) = (folder.at("a.ply"), folder.at("b.obj"));
    meshmend(&["convert", &example("broken.obj"), &ply]).succeeds();
    meshmend(&["convert", &ply, &back]).succeeds();
    let defects = |file: &str| {
        let mut report = meshmend(&["check", "--json", file]).json();
        (report["defects"].take(), report["betti"].take())
    };
    assert_eq!(defects(&back), defects(&example("broken.obj")));
    let run = meshmend(&["convert", &example("broken.obj"), &folder.at("c.stl")]).succeeds();
    assert!(run.stdout.contains("what the output can't carry"), "{}", run.stdout);
}

#[test]
fn an_impossible_conversion_leaves_nothing() {
    let folder = Folder::new();
    meshmend(&["convert", &example("soup.stl"), &folder.at("a.glb")]).fails(2, "a.glb");
    meshmend(&["convert", &folder.at("none.obj"), &folder.at("a.off")]).fails(3, "none.obj");
    meshmend(&["convert", &example("soup.stl"), &folder.at("x/a.off")]).fails(4, "a.off");
    assert!(folder.names().is_empty());
}

#[test]
fn kernels_are_listed_and_tried() {
    let list = meshmend(&["kernels"]).succeeds().stdout;
    assert!(list.contains("edge-use         anything"), "{list}");
    let tried = meshmend(&["kernels", &example("pinched.ply")]).succeeds().stdout;
    assert!(tried.contains("bytes a face") && tried.contains("(v0 joins 2 umbrellas)"), "{tried}");
}

#[test]
fn every_word_of_the_glossary_is_explained() {
    let glossary = meshmend(&["explain"]).succeeds().stdout;
    let words: Vec<&str> = glossary
        .lines()
        .filter(|line| line.starts_with("  "))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(words.len() > 30);
    for word in words {
        assert!(meshmend(&["explain", word]).succeeds().stdout.starts_with(word), "{word}");
    }
    meshmend(&["explain", "spleen"]).fails(2, "spleen");
}

#[test]
fn completions_know_the_options() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = meshmend(&["completions", shell]).succeeds().stdout;
        assert!(script.contains("non-orientable"), "{shell}");
    }
}

#[test]
fn help_and_version_succeed_and_mistakes_do_not() {
    let version = meshmend(&["--version"]).succeeds().stdout;
    assert_eq!(version, format!("meshmend {}\n", env!("CARGO_PKG_VERSION")));
    assert!(meshmend(&["--help"]).succeeds().stdout.contains("Exit status"));
    for wrong in [
        &[] as &[&str],
        &["mend"],
        &["check"],
        &["repair", "a.obj", "b.obj"],
        &["check", "--limit", "-1", "a"],
    ] {
        assert_eq!(meshmend(wrong).status, 2, "{wrong:?}");
    }
}

#[test]
fn the_examples_are_what_their_list_says() {
    let list = fs::read_to_string(example("README.md")).unwrap();
    for (file, status) in [("broken.obj", 1), ("moebius.off", 1), ("pinched.ply", 1), ("soup.stl", 0)] {
        assert!(list.contains(file));
        assert_eq!(meshmend(&["check", &example(file)]).status, status, "{file}");
    }
}
