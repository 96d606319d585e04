//! What the end-to-end tests share.
//!
//! The tests judge meshmend by things that it had no hand in: a corpus of files with known figures, a set of hostile
//! files with the outcome that each must have, and a checker of repaired meshes in another language. These lie
//! beside the workspace; where they are not there, a test that needs them says that it was skipped, and passes.
//!
//! * [`contributing`]: the page for contributors beside the files that it shows.
//! * [`corpus`]: the corpus and what its manifest says of each file.
//! * [`each`]: one question to many files, with all that is wrong in one failure.
//! * [`gltf_judges`]: other programs that read glTF.
//! * [`in_process`]: the program in the process of the test.
//! * [`shared`]: the folder beside the workspace.
//! * [`judge`]: the independent checker, over many files in one run.
//! * [`program`]: the `meshmend` binary.
//! * [`scratch`]: folders that are gone afterwards.
//!
//! Environment variables: `MESHMEND_BIN` is the binary to test in place of a fresh build, `MESHMEND_PYTHON` the
//! interpreter with numpy in place of `python3`, and `MESHMEND_BIG` set to anything runs the large hostile files too.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

pub mod contributing;
pub mod corpus;
pub mod each;
pub mod gltf_judges;
pub mod in_process;
pub mod judge;
pub mod program;
pub mod scratch;
pub mod shared;
