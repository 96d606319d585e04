//! What is true of every pass and of every pipeline, tested for each one in the registry without naming any.
//!
//! The laws themselves are the testkit's; here they meet the passes, with every value of every option, on meshes of all
//! kinds.
//!
//! * [`options`]: every pass with every choice of its options, found by asking.
//! * [`passes`]: a pass alone keeps its promise, tells the truth, and does nothing a second time.
//! * [`pipelines`]: so do passes in a row.
//! * [`sameness`]: threads and kernels make no difference.
//!
//! More random meshes than the usual number: `MESHMEND_LAW_CASES=20` makes it twenty times as many.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test stops where it fails")]

mod options;
mod passes;
mod pipelines;
mod sameness;

/// How many random cases a law is asked for, where so many are usual.
fn many(usual: u32) -> u32 {
    let factor = std::env::var("MESHMEND_LAW_CASES").ok().and_then(|factor| factor.parse().ok());
    usual * factor.unwrap_or(1)
}
