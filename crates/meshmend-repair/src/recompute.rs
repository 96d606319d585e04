//! Looks at the whole mesh afresh, and changes nothing. A mesh that was looked at already, and to which nothing was done
//! since, is not looked at again.
//!
//! *Why*: what a repair claims is not what it did but what is there now. A pipeline ends with it and checks the
//! promises of its passes against the figures: a promise that does not hold is an error of the program.

use meshmend_core::{Connectivity, DefectKind, PolygonMesh, Severity};
use meshmend_kernels::KernelTask;
use meshmend_topology::{TopologyReport, topology};
use serde::{Deserialize, Serialize};

use crate::{Context, Outcome, Pass, PassError};

/// Looks at the whole mesh afresh, and changes nothing.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Recompute {}

struct Task<'a> {
    mesh: &'a PolygonMesh,
}

impl KernelTask for Task<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology(kernel, self.mesh)
    }
}

impl Pass for Recompute {
    fn name(&self) -> &'static str {
        "recompute"
    }
    fn removes(&self) -> &'static [DefectKind] {
        &[]
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let report = match context.report {
            Some(report) => report.clone(),
            None => context.kernel.run(mesh.complex(), Task { mesh })?,
        };
        let wrong = DefectKind::ALL.iter().filter(|kind| kind.severity() == Severity::Defect);
        let left = wrong.flat_map(|&kind| report.defects.of_kind(kind)).collect();
        Ok(Outcome { left, report: Some(Box::new(report)), ..Outcome::unchanged(mesh) })
    }
}
