//! What the command line says of a repair, whichever command makes it: the policies, and what the report shows.

use clap::Args;
use meshmend::Rules;
use meshmend::files::{FileRepair, Maps};

use crate::failure::Failure;
use crate::gate_words::GateWords;
use crate::geometry_words::GeometryWords;
use crate::policies::Policies;
use crate::words;

/// How files are repaired.
#[derive(Clone, Debug, Args)]
pub(crate) struct RepairWords {
    /// Put into the JSON report where each vertex and face of the result came from
    #[arg(long)]
    pub(crate) report_maps: bool,
    /// The structure to compute on; the result is the same, unless it can't hold the mesh
    #[arg(long, default_value = "edge-use")]
    kernel: String,
    /// How many items each list of the report shows at most, also in JSON, by default 10 or as the plan says; counts are always
    /// whole
    #[arg(long, value_name = "N")]
    limit: Option<usize>,
    #[command(flatten)]
    pub(crate) gate: GateWords,
    #[command(flatten)]
    geometry: GeometryWords,
    #[command(flatten)]
    pub(crate) policies: Policies,
}

impl RepairWords {
    /// The repair that they say. What is wrong with the command line is told before anything is read.
    pub(crate) fn repair(&self, rules: Rules) -> Result<FileRepair, Failure> {
        self.repair_showing(FileRepair::default().limit, rules)
    }

    /// The same, with lists of another length unless these words or the plan tell it.
    pub(crate) fn repair_showing(&self, usual_limit: usize, rules: Rules) -> Result<FileRepair, Failure> {
        let mut repair = FileRepair::of(self.policies.plan()?);
        repair.cut_polygons = self.policies.cut_polygons();
        repair.kernel = words::kernel(&self.kernel)?;
        repair.rules = rules;
        repair.limit = self.limit.or(repair.plan.files.limit).unwrap_or(usual_limit);
        repair.gate = self.gate.gate(rules, &repair.plan.files.fail_on)?;
        repair.geometry = self.geometry.options(&repair.gate.defects(), usize::MAX)?;
        repair.maps = if self.report_maps { Maps::Whole } else { Maps::LeftOut };
        Ok(repair)
    }
}
