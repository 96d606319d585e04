//! What a run comes to: a verdict on each law, in words, as JSON and as a mesh to look at.

mod document;
mod files;
mod text;
mod verdicts;

pub use verdicts::{Outcome, Verdict, Verdicts};
