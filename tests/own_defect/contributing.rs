//! What CONTRIBUTING says of the edits that a new kind of defect takes is what they are.

use meshmend_tests::contributing::Example;

const KIND: Example<'_> = Example {
    files: &["tests/own_defect/crowded_vertex.rs"],
    registry: "tests/own_defect/main.rs",
    rows: &["    crowded_vertex"],
    word: "crowded_vertex",
};

#[test]
fn the_diff_that_is_shown_is_true() {
    KIND.assert_shown();
}

#[test]
fn a_kind_is_one_file_and_one_row() {
    KIND.assert_said_nowhere_else("tests/own_defect/contributing.rs");
}
