//! A repair of what was repaired changes nothing, whatever the options are: random meshes with random options, through
//! the program, from every format into every format. The second output is the first to the byte, and the second report
//! says that nothing changed. Neither the number of threads nor the kernel makes a difference.
//!
//! More cases than the usual number: `MESHMEND_SECOND_RUN_CASES=20000`; from another one on:
//! `MESHMEND_SECOND_RUN_FIRST=20000`. What fails is told with its number, as small as it could be made.

use std::ops::Range;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

mod asked;
mod case;
mod meshes;
mod options;
mod random;

use asked::{Asked, Outcome};
use case::Case;

/// How many cases there are, and the number of the first.
fn amount(variable: &str, usual: u64) -> u64 {
    std::env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// What once changed again: a file, the format that it goes into, and the options.
const KEPT: &[(&str, &str, &[&str])] = &[
    // Crowded edges of vertices that are written more than once for their texture coordinates.
    ("texture_seam.obj", "ply", &[]),
    // Edges that coincide were subdivided in one point, and so again when only places told vertices apart.
    ("crowded_edge.obj", "stl", &[]),
    // What was read is what is written, but for the indices that STL does not hold.
    ("stitched.obj", "stl", &[]),
    // The writer cuts polygons, with vertices of its own.
    ("polygons.ply", "stl", &["--triangulate", "auto"]),
    ("not_simple.off", "stl", &["--clean", "off"]),
    // Nothing was changed, but what hung together as stored no longer did.
    ("decal_at_a_seam.obj", "ply", &["--split", "off"]),
    // Whether a shell lies in another one was asked of a point that hung on the way round its face.
    ("shells_of_few_units.obj", "off", &["--orient", "outward-nested", "--split", "off"]),
    // Two seams of one edge each.
    ("seam.obj", "stl", &["--non-orientable", "cut"]),
];

#[test]
fn what_once_changed_again_no_longer_does() {
    for &(file, output, options) in KEPT {
        let stored = Path::new(env!("CARGO_MANIFEST_DIR")).join("data/second_run").join(file);
        let outcome = Asked { output, options: options.to_vec() }.outcome(&stored, true);
        assert!(outcome == Outcome::Right, "{file}: {outcome:?}");
    }
}

#[test]
fn a_second_repair_changes_nothing() {
    let (first, count) = (amount("MESHMEND_SECOND_RUN_FIRST", 0), amount("MESHMEND_SECOND_RUN_CASES", 400));
    let outcomes = outcomes(first..first + count);
    let of = |wanted: fn(&Outcome) -> bool| outcomes.iter().filter(|(_, outcome)| wanted(outcome)).count();
    let refused = of(|outcome| matches!(outcome, Outcome::Refused));
    let wrong: Vec<u64> = outcomes
        .iter()
        .filter(|(_, outcome)| matches!(outcome, Outcome::Wrong(_)))
        .map(|(seed, _)| *seed)
        .collect();
    println!("{count} cases from {first} on: {refused} refused by a policy, {} wrong", wrong.len());
    let told: Vec<String> = wrong
        .iter()
        .take(amount("MESHMEND_SECOND_RUN_TOLD", 12) as usize)
        .map(|&seed| Case::random(seed).shrunk(seed).told(seed))
        .collect();
    assert!(wrong.is_empty(), "{} of {count} change again: {wrong:?}\n{}", wrong.len(), told.join("\n"));
    assert!(refused * 3 < outcomes.len() + 30, "most cases are to be judged");
}

/// What became of each case. Threads of their own take one after the other: each case starts threads itself, and a
/// pool's would take up the next case while they wait for those.
fn outcomes(seeds: Range<u64>) -> Vec<(u64, Outcome)> {
    let (next, outcomes) = (AtomicU64::new(seeds.start), Mutex::new(Vec::new()));
    let work = || {
        while let Some(seed) = Some(next.fetch_add(1, Ordering::Relaxed)).filter(|seed| seeds.contains(seed))
        {
            let outcome = Case::random(seed).outcome(seed);
            outcomes.lock().unwrap().push((seed, outcome));
        }
    };
    std::thread::scope(|scope| (0..4).for_each(|_| drop(scope.spawn(work))));
    let mut outcomes = outcomes.into_inner().unwrap();
    outcomes.sort_by_key(|(seed, _)| *seed);
    outcomes
}
