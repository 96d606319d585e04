//! The other commands, as a user runs them.

mod common;

use std::fs;

use common::{Folder, example, meshmend, program};

#[test]
fn a_conversion_changes_nothing_and_names_what_is_lost() {
    let folder = Folder::new();
    let (ply, back) = (folder.at("a.ply"), folder.at("b.obj"));
    // Vertices split for texture coordinates are another mesh by index.
    meshmend(&["convert", &example("broken.obj"), &ply, "--seams", "corners"]).succeeds();
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
fn kernels_are_timed_on_a_file() {
    let bench = ["kernels", &example("pinched.ply"), "--bench", "--runs", "1"];
    let report = meshmend(&[&bench[..], &["--json"]].concat()).json();
    assert_eq!((report["schema"].as_u64(), report["runs"].as_u64()), (Some(2), Some(1)));
    let faces = report["faces"].as_u64();
    assert!(faces > Some(0) && report["file"].is_string(), "{report}");
    let kernels = report["kernels"].as_array().unwrap();
    let times = |name: &str| {
        let kernel = kernels.iter().find(|kernel| kernel["name"] == name).unwrap();
        let seconds = kernel["seconds"].as_object().unwrap();
        assert!(seconds.values().all(|time| time.as_f64() >= Some(0.0)), "{kernel}");
        assert_eq!(kernel["refusal"].is_string(), seconds.is_empty(), "{kernel}");
        assert_eq!(kernel["bytes_a_face"].is_number(), !seconds.is_empty(), "{kernel}");
        seconds.keys().cloned().collect::<Vec<_>>()
    };
    let questions = [
        "boundary-walk",
        "build",
        "components",
        "edge-walk",
        "face-walk",
        "one-rings",
        "orientation",
        "report",
        "vertex-neighbours",
    ];
    assert_eq!(times("edge-use"), questions);
    assert_eq!(times("face-vertex"), questions);
    assert!(times("half-edge").is_empty());
    let page = meshmend(&bench).succeeds().stdout;
    for word in ["edge-use", "one-rings", "refuses", "(v0 joins 2 umbrellas)", "best of 1"] {
        assert!(page.contains(word), "{word}: {page}");
    }
    meshmend(&["kernels", "--bench"]).fails(2, "FILE");
    meshmend(&["kernels", &example("pinched.ply"), "--json"]).fails(2, "--bench");
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

/// What a word suggests to try works as it stands, one command after the other.
#[test]
fn what_words_suggest_to_try_works() {
    let mut count = 0;
    for word in meshmend::words::WORDS {
        let folder = Folder::new();
        let page = meshmend(&["explain", word.name]).succeeds().stdout;
        for line in page.lines().filter_map(|line| line.trim_start().strip_prefix("meshmend ")) {
            let run = program().args(line.split(' ')).current_dir(folder.at("")).output().unwrap();
            // A check may find what the word is about.
            let is_well = matches!(run.status.code(), Some(0 | 1)) && run.stderr.is_empty();
            assert!(is_well, "{line}: {}", String::from_utf8_lossy(&run.stderr));
            count += 1;
        }
    }
    assert!(count >= 2 * meshmend::words::WORDS.len(), "{count}");
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
