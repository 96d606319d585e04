//! What CONTRIBUTING says of the edits that a new format takes is what they are.
//!
//! That the example is told by its content, listed, read and written is asked by the tests of the registry beside it, and
//! of every other row, too.

use meshmend_tests::contributing::Example;

const FORMAT: Example<'_> = Example {
    files: &["crates/meshmend-io/src/formats/toy/facts.rs", "crates/meshmend-io/src/formats/toy/mod.rs"],
    registry: "crates/meshmend-io/src/formats/rows.rs",
    rows: &[
        "            /// The example of CONTRIBUTING.",
        "            #[cfg(test)]",
        "            Toy => toy,",
    ],
    word: "toy",
};

#[test]
fn the_diff_that_is_shown_is_true() {
    FORMAT.assert_shown();
}

#[test]
fn a_format_is_one_folder_and_one_row() {
    FORMAT.assert_said_nowhere_else("tests/own_format.rs");
}
