//! A kernel of one's own, outside the crates of meshmend: one file and one row. Every law of kernels is kept, and so every
//! question gives the answer that it gives on meshmend's own.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "these are tests")]

use meshmend_tests::contributing::Example;

macro_rules! own_kernels {
    ($($file:ident)*) => {
        $(mod $file;)*

        mod laws {
            $(meshmend_conformance::kernel!($file: crate::$file::Kernel);)*
        }
    };
}

own_kernels! {
    corner_scan
}

fn example() -> Example {
    Example::beside_main("tests/own_kernel", "own_kernels")
}

#[test]
fn the_diff_that_is_shown_is_true() {
    example().assert_shown();
}

#[test]
fn a_kernel_is_one_file_and_one_row() {
    example().assert_said_nowhere_else(&[]);
}
