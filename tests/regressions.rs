//! What fuzzing ever found, and what it is certain to pass through, once more in `cargo test`.
//!
//! `fuzz/regressions` has a folder a target with the minimised inputs that once broke a promise. Every target is run
//! on random bytes as well, so that a target that always fails, or can't be called, shows here and not on the next
//! day of fuzzing.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use meshmend_fuzz::{TARGETS, Target};

fn fuzz_folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz").join(name)
}

/// The paths in a folder, in order; none where there is no such folder.
fn listed(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

/// The last part of a path without its ending.
fn stem(path: &Path) -> String {
    path.file_stem().unwrap().to_string_lossy().into_owned()
}

#[test]
fn every_find_stays_mended() {
    let mut count = 0;
    for folder in listed(&fuzz_folder("regressions")) {
        let name = stem(&folder);
        let target = TARGETS.iter().find(|target| target.name == name);
        let target = target.unwrap_or_else(|| panic!("{} is of no target", folder.display()));
        for path in listed(&folder) {
            println!("{}", path.display());
            (target.check)(&std::fs::read(&path).unwrap());
            count += 1;
        }
    }
    assert!(count > 0, "no input was replayed");
    println!("{count} inputs replayed");
}

#[test]
fn every_target_takes_random_bytes() {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for Target { name, check } in TARGETS {
        for round in 0..200 {
            let mut random = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 56) as u8
            };
            let length = random() / 2;
            let bytes: Vec<u8> = (0..length).map(|_| random()).collect();
            println!("{name}, round {round}: {bytes:?}");
            check(&bytes);
        }
    }
}

/// A target is a function, a program and an entry in the manifest that builds it.
#[test]
fn every_target_has_its_program() {
    let names: BTreeSet<String> = TARGETS.iter().map(|target| target.name.to_owned()).collect();
    let programs: BTreeSet<String> =
        listed(&fuzz_folder("fuzz_targets")).iter().map(|path| stem(path)).collect();
    let manifest = std::fs::read_to_string(fuzz_folder("Cargo.toml")).unwrap();
    let entries = manifest.lines().filter_map(|line| line.strip_prefix("path = \"fuzz_targets/"));
    let built: BTreeSet<String> = entries.map(|path| stem(Path::new(path))).collect();
    assert_eq!(names, programs);
    assert_eq!(names, built);
}
