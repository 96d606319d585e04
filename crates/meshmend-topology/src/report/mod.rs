//! All questions asked at once, and where everything is that is wrong.

mod defect_list;
mod topology_report;

pub use defect_list::DefectList;
pub use topology_report::{
    DuplicateCounts, NonManifoldVertexCounts, Reason, TopologyReport, Undefined, Witness, topology,
    topology_with,
};
