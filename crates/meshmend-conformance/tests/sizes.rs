//! What a kernel says of its size is held against what the allocator gave.

use meshmend_conformance::{Outcome, Settings, Subject};
use meshmend_core::EdgeUse;

#[path = "students/winged_edge.rs"]
#[allow(dead_code, reason = "most mistakes are tested beside it")]
mod winged_edge;
use winged_edge::{FORGETS_AN_ARRAY, NONE, Student, make};

meshmend_conformance::kernel_size!(edge_use: EdgeUse, without_a_mistake: Student<NONE>);

#[test]
fn a_forgotten_array() {
    make(FORGETS_AN_ARRAY);
    let subject = Subject::measured::<Student<NONE>>(|| ALLOCATOR.allocated());
    let verdicts =
        subject.in_test(concat!(module_path!(), "::a_forgotten_array")).verdicts(&Settings::default());
    let verdicts = verdicts.unwrap_or_else(|reason| unreachable!("{reason}"));
    assert_eq!(verdicts.each()[0].outcome, Outcome::Broken);
    let text = verdicts.text("size");
    assert!(text.contains("heap_bytes() is") && text.contains("which is what the allocator gave"), "{text}");
}
