//! Mistakes of students, each planted in a winged edge that is correct else: each breaks the law that it should, on a small
//! mesh, soon, and within little memory.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test stops where it fails")]

mod winged_edge;

use std::time::{Duration, Instant};

use meshmend_conformance::{Effort, Opposite, Outcome, SURFACES, Settings, Subject, Verdicts};
use winged_edge::*;

meshmend_conformance::kernel!(without_a_mistake: Student<NONE>, at_least = ORIENTED_SURFACES);

/// How long a question may take: a mistake that never comes back takes this long to be found.
const PATIENCE: Duration = Duration::from_secs(2);

/// The verdicts on a student, which come soon.
fn verdicts(subject: Subject, test: &str, effort: Effort) -> Verdicts {
    let begun = Instant::now();
    let settings = Settings::default().with_patience(PATIENCE).with_effort(effort);
    let verdicts = subject.in_test(test).verdicts(&settings).unwrap();
    let taken = begun.elapsed();
    assert!(taken < Duration::from_secs(if cfg!(debug_assertions) { 60 } else { 10 }), "{taken:?}");
    verdicts
}

/// Asserts how a law is broken, on how many faces, and what is said of it.
fn found(verdicts: &Verdicts, law: &str, outcome: Outcome, faces: Option<usize>, message: &str) {
    let (text, verdict) = (verdicts.text(law), verdicts.on(law).unwrap());
    assert_eq!(verdict.outcome, outcome, "{text}");
    assert!(verdict.message().unwrap().contains(message), "{text}");
    assert_eq!(verdict.faces().map(<[_]>::len), faces, "{text}");
}

macro_rules! students {
    ($($effort:ident $test:ident: $mistake:ident, $claim:ident breaks $law:literal by $outcome:ident on $faces:expr, $message:literal;)*) => {
        $(#[test]
        fn $test() {
            make($mistake);
            let opposite = Opposite::<Student<$claim>>::new().asked();
            let subject = Subject::with_opposite::<Student<$claim>>(opposite).at_least::<Student<$claim>>(SURFACES);
            let test = concat!(module_path!(), "::", stringify!($test));
            let verdicts = verdicts(subject, test, Effort::$effort);
            found(&verdicts, $law, Outcome::$outcome, $faces, $message);
        })*
    };
}

// The commonest.
students! {
    Usual following_the_first_wing: FOLLOWS_FIRST_WING, NONE breaks "next-and-prev" by Panics on Some(1), "next_corner(c2) panics";
    Usual clockwise_for_counter_clockwise: CLOCKWISE, NONE breaks "next-and-prev" by Broken on Some(2), "next_corner(c1) is c4 and should be c2";
    Usual a_walk_that_never_ends: ENDLESS_WALK, NONE breaks "vertex-stars" by Broken on Some(1), "vertex_corners(v0) is c0 c0";
    Usual edges_numbered_as_met: AS_MET, NONE breaks "numbering" by Broken on Some(1), "corner_edge(c1) is e1 and should be e2";
    Usual a_face_that_begins_anywhere: BEGINS_ANYWHERE, NONE breaks "face-stars" by Broken on Some(1), "face_corners(f0) is";
    Usual a_forgotten_boundary_wing: NO_BOUNDARY_WING, NONE breaks "vertex-stars" by Panics on Some(1), "vertex_corners(v0) panics";
    Usual mixed_orientation_that_is_claimed: NONE, CLAIMS_MIXED breaks "refusal" by Broken on Some(2), "mixed_orientation is true";
    Usual memory_without_end: TAKES_MEMORY, NONE breaks "vertex-stars" by Hangs on Some(1), "vertex_corners(v0) takes memory without end";
}

// Variants of them.
students! {
    Quick pinched_vertices_that_are_claimed: NONE, CLAIMS_PINCHED breaks "refusal" by Broken on Some(2), "non_manifold_vertices is true";
    Quick books_that_are_claimed: NONE, CLAIMS_BOOKS breaks "refusal" by Broken on Some(2), "non_manifold_vertices is true";
    Quick memory_without_end_at_once: TAKES_MEMORY_AT_ONCE, NONE breaks "assembly" by Hangs on Some(1), "assemble() takes memory without end";
    Quick a_walk_that_never_answers: SILENT_WALK, NONE breaks "vertex-stars" by Hangs on Some(1), "does not come back within 2 s";
    Quick an_assembly_that_never_ends: ENDLESS_ASSEMBLY, NONE breaks "assembly" by Hangs on Some(1), "assemble() does not come back";
    Quick a_question_that_asks_itself: ENDLESS_RECURSION, NONE breaks "numbering" by Panics on Some(1), "corner_face(c0) calls itself until its stack is full";
    Quick the_end_of_the_process: EXITS, NONE breaks "numbering" by Panics on Some(1), "corner_face(c0) ends the process (exit status: 3)";
    Quick a_face_that_is_a_third: FACE_IS_A_THIRD, NONE breaks "numbering" by Broken on Some(1), "corner_face(c3) is f1 and should be f0";
    Quick an_answer_that_is_wrong_on_large_faces: WRONG_ON_PENTAGONS, NONE breaks "next-and-prev" by Broken on Some(1), "next_corner(c4) is c4 and should be c0";
}

// One for each other law.
students! {
    Quick an_answer_of_its_own: OWN_DEGREE, NONE breaks "derived" by Broken on Some(1), "edge_degree(e0) is 2 and should be 1";
    Quick a_degenerate_face_that_is_forgotten: FORGETS_DEGENERATE, NONE breaks "counts" by Broken on Some(1), "face_count() is 0 and should be 1";
    Quick sides_as_they_are_recorded: AS_RECORDED, NONE breaks "edge-stars" by Broken on Some(2), "edge_corners(e1) is c3 c2 and should be c2 c3";
    Quick a_star_that_begins_at_the_lowest_corner: BEGINS_LOWEST, NONE breaks "rotation" by Broken on Some(2), "and should be c";
    Quick a_boundary_that_leads_to_itself: ACROSS_ITSELF, NONE breaks "across" by Broken on Some(1), "across(c0) is c0 and should be None";
    Quick an_opposite_that_is_the_corner: OPPOSITE_ITSELF, NONE breaks "across" by Broken on Some(1), "opposite(c0) is c0 and should be None";
    Quick two_arrays_of_one_name: ONE_NAME, NONE breaks "arrays" by Broken on Some(0), "the number of arrays that are called `edges` is 2 and should be 1";
    Quick an_array_that_is_left_out: LEAVES_AN_ARRAY_OUT, NONE breaks "arrays" by Broken on Some(0), "the sum of arrays() is";
    Quick a_pointer_that_leads_outside: POINTS_OUTSIDE, NONE breaks "pointers" by Broken on Some(1), "`wing` in pointers(c0) is e3 and should be an edge below 3";
    Quick a_twin_that_is_the_next_corner: TWIN_IS_NEXT, NONE breaks "pointers" by Broken on Some(1), "`twin` in pointers(c0) is c1 and should be None";
    Quick a_search_in_the_whole_list: SEARCHES, NONE breaks "growth" by Broken on None, "should be constant, as COSTS says";
    Quick less_than_it_is_asked_for: NONE, HOLDS_LITTLE breaks "capacity" by Broken on None, "should be that they are held";
}

#[test]
fn the_verdict_is_to_the_letter() {
    let test = concat!(module_path!(), "::the_verdict_is_to_the_letter");
    make(CLOCKWISE);
    let verdicts = verdicts(Subject::of::<Student<NONE>>(), test, Effort::Quick);
    assert_eq!(verdicts.text("next-and-prev"), VERDICT.trim_end());
    assert!(verdicts.text("counts").starts_with("student keeps the law `counts`: "));
    let document: serde_json::Value = serde_json::from_str(&verdicts.document()).unwrap();
    let law = document["laws"].as_array().unwrap().iter().find(|law| law["law"] == "next-and-prev").unwrap();
    let keys: Vec<&String> = law.as_object().unwrap().keys().collect();
    let expected =
        ["expected", "found", "kernel", "law", "meshes", "message", "schema", "smallest", "verdict"];
    assert!(keys.is_sorted() && keys == expected);
    assert_eq!(
        (&law["verdict"], &law["found"], &law["expected"]),
        (&"broken".into(), &"c4".into(), &"c2".into())
    );
    assert_eq!(law["smallest"]["faces"], serde_json::json!([[0, 2, 1], [0, 1, 3]]));
}

const VERDICT: &str = "\
student breaks the law `next-and-prev`: next goes round the face as stored, prev undoes it.

  smallest mesh that breaks it, of 3301 tried (2 faces, 4 vertices):
    f0: v0 v2 v1     c0 c1 c2
    f1: v0 v1 v3     c3 c4 c5

  next_corner(c1) is c4 and should be c2

  often: turned the wrong way at the far end of a side
  the mesh: target/meshmend-conformance/student/next-and-prev.obj
  other laws: 15 kept; it holds 2555 of the 3301 meshes
";
