//! Laws that are asked in the process of the test, as for a debugger.

use meshmend_conformance::{Effort, LAWS, Outcome, Settings, Subject};
use meshmend_core::{Capabilities, EdgeUse};

#[path = "students/winged_edge.rs"]
#[allow(dead_code, reason = "most mistakes are tested beside it")]
mod winged_edge;
use winged_edge::{NO_BOUNDARY_WING, NONE, Student, make};

/// One test, since a mistake is made by every student of a process.
#[test]
fn the_process_of_the_test_gives_the_same_verdicts() {
    let settings = Settings::default().with_effort(Effort::Quick).in_process();
    let kept = Subject::of::<EdgeUse>().at_least::<EdgeUse>(Capabilities::PERMISSIVE).verdicts(&settings);
    assert!(kept.is_ok_and(|verdicts| verdicts.are_all_kept() && verdicts.each().len() + 1 == LAWS.len()));
    make(NO_BOUNDARY_WING);
    let broken = Subject::of::<Student<NONE>>().verdicts(&settings).ok();
    let stars = broken.as_ref().and_then(|verdicts| verdicts.on("vertex-stars"));
    assert_eq!(stars.map(|verdict| verdict.outcome), Some(Outcome::Panics));
    assert_eq!(stars.and_then(|verdict| verdict.faces()), Some([vec![0, 1, 2]].as_slice()));
}
