//! All questions asked at once.

mod answers;
mod figures;
mod topology_report;
mod totals;

#[cfg(test)]
mod tests;

pub use answers::{topology, topology_watched};
pub use figures::Figures;
pub use topology_report::{
    DuplicateCounts, NonManifoldVertexCounts, Reason, TopologyReport, Undefined, Witness,
};
