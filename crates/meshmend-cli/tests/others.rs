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
    meshmend(&["convert", &example("soup.stl"), &folder.at("a.fbx")]).fails(2, "a.fbx");
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
    let folder = Folder::new();
    let bars = folder.at("bars.svg");
    meshmend(&[&bench[..], &["--svg", &bars]].concat()).succeeds();
    let drawn = fs::read_to_string(&bars).unwrap();
    assert!(
        drawn.contains(">face-vertex</text>") && drawn.contains("<title>points: 24 bytes a corner</title>")
    );
    assert!(!drawn.contains(">half-edge</text>"), "it refuses the mesh");
    meshmend(&["kernels", "--bench"]).fails(2, "FILE");
    meshmend(&["kernels", &example("pinched.ply"), "--json"]).fails(2, "--bench");
}

#[test]
fn records_are_shown_and_drawn() {
    let folder = Folder::new();
    let (cube, picture) = (folder.at("cube.obj"), folder.at("c0.svg"));
    meshmend(&["make", "cube", "-o", &cube]).succeeds();
    let shown =
        meshmend(&["pointers", &cube, "--kernel", "half-edge", "--at", "c0", "-o", &picture]).succeeds();
    for field in ["next", "prev", "twin", "origin", "face", "edge"] {
        assert!(shown.stdout.contains(&format!("  {field}")), "{}", shown.stdout);
        assert!(fs::read_to_string(&picture).unwrap().contains(&format!(">{field}</text>")), "{field}");
    }
    let all = meshmend(&["pointers", &cube, "--all"]).succeeds().stdout;
    assert!(all.contains("v7 in edge-use") && all.contains("e11 in edge-use"), "{all}");
    let permutations = meshmend(&["pointers", &cube, "--permutations"]).succeeds().stdout;
    for line in
        ["24 half-edges", "σ, round each vertex: 8 cycles", "α, along each edge: 12 cycles", "6 cycles"]
    {
        assert!(permutations.contains(line), "{permutations}");
    }
    meshmend(&["pointers", &cube, "--at", "e12"]).fails(2, "has no e12: it has 8 vertices, 12 edges");
    meshmend(&["pointers", &cube, "--at", "x12"]).fails(2, "v, e, f or c and a number");
    meshmend(&["pointers", &cube]).fails(2, "--at");
    meshmend(&["pointers", &cube, "--kernel", "no-such", "--at", "v0"]).fails(2, "the kernels are edge-use");
    let pinched = example("pinched.ply");
    meshmend(&["pointers", &pinched, "--kernel", "half-edge", "--at", "v0"]).fails(5, "v0 joins 2 umbrellas");
    meshmend(&["pointers", &pinched, "--permutations"]).fails(5, "v0 joins 2 umbrellas");
    meshmend(&["pointers", &cube, "--at", "v0", "-o", &cube]).fails(2, "cube.obj");
    meshmend(&["pointers", &cube, "--all", "-o", &picture]).fails(2, "--all");
}

#[test]
fn a_kernel_is_explained_on_a_file() {
    let pinched = example("pinched.ply");
    let refuses = meshmend(&["explain", "half-edge", &pinched]).succeeds().stdout;
    assert!(
        refuses.contains("refuses: v0 joins 2 umbrellas") && refuses.contains("who holds it"),
        "{refuses}"
    );
    let holds = meshmend(&["explain", "edge-use", &pinched]).succeeds().stdout;
    assert!(holds.contains("holds it: 8 faces, "), "{holds}");
    let why = meshmend(&["explain", "half-edge", &pinched]).succeeds().stdout;
    assert!(why.contains("a vertex has one half-edge") && why.contains("simple-record"), "{why}");
    let defect = meshmend(&["explain", "pinched-vertex", &pinched]).succeeds().stdout;
    assert!(defect.contains("pinched.ply: 1\n  v0 joins 2 umbrellas"), "{defect}");
    let genus = meshmend(&["explain", "genus", &example("soup.stl")]).succeeds().stdout;
    assert!(
        genus.contains("soup.stl\n  boundary loops            0\n  genus                     0\n"),
        "{genus}"
    );
    let law = meshmend(&["explain", "law:next-and-prev"]).succeeds().stdout;
    assert!(law.contains("next goes round the face") && law.contains("cargo test next_and_prev"), "{law}");
    for pageless in ["weld", "law:size", "adjacency-matrix"] {
        meshmend(&["explain", pageless, &pinched]).fails(2, "is explained without a file");
    }
    meshmend(&["explain", "law:no-such"]).fails(2, "there is no kind of defect");
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
