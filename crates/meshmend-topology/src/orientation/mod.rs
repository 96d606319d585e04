//! Patches, whether they have two sides, the strip that shows when they don't, and the seam that cuts them open.

pub(crate) mod crossings;
pub(crate) mod dual_graph;
mod one_sided;
mod orientability;
mod patches;
pub(crate) mod seam;

pub use dual_graph::DualEdge;
pub use one_sided::{ONE_SIDED_BUDGET, OneSidedLoop, one_sided_loops, one_sided_loops_by_length};
pub use orientability::{OneSidedStrip, Orientability, orientability};
pub use patches::{Patches, Side, patches};
pub use seam::{Seam, seams, seams_by_length, short_seam};
