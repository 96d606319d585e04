//! What CONTRIBUTING says of the edits that a new format takes is what they are.
//!
//! That the example is told by its content, listed, read and written is asked by the tests of the registry beside it, and
//! of every other row, too.

use meshmend_tests::contributing::Example;

fn example() -> Example {
    let folder = "crates/meshmend-io/src/formats";
    let rows = ["/// The example of CONTRIBUTING.", "#[cfg(test)]", "Toy => toy,"];
    Example {
        files: ["facts", "mod"].map(|file| format!("{folder}/toy/{file}.rs")).to_vec(),
        registry: format!("{folder}/rows.rs"),
        above: "            ThreeMf => threemf,".to_owned(),
        rows: rows.map(|row| format!("            {row}")).to_vec(),
        word: "toy".to_owned(),
    }
}

#[test]
fn the_diff_that_is_shown_is_true() {
    example().assert_shown();
}

#[test]
fn a_format_is_one_folder_and_one_row() {
    example().assert_said_nowhere_else(&["tests/own_format.rs"]);
}
