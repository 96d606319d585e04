//! The laws of meshmend's kernels, for anybody's kernel.

#![allow(clippy::expect_used, reason = "this crate is for tests, which stop where they fail")]

mod laws;
mod soup;
pub mod worlds;

pub use laws::{heap_law, kernel_laws, refusal_law};
pub use soup::Soup;
