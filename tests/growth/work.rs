//! What is done with a mesh.

use meshmend_core::{Connectivity, PolygonMesh};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_repair::{Plan, SplitEdges, TriangulateFaces};
use meshmend_topology::{TopologyReport, topology};

/// What is done with a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// Nothing; it is made, as for all work.
    Make,
    /// The whole report.
    Check,
    /// The default pipeline.
    Repair,
    /// The pipeline that cuts where it is not beyond doubt what belongs together.
    Cut,
    /// The pipeline that splits vertices alone.
    PinchOnly,
    /// The pipeline that cuts all faces into triangles.
    Triangulate,
}

impl Work {
    /// All that is compared.
    pub(crate) const ALL: [Work; 5] =
        [Work::Check, Work::Repair, Work::Cut, Work::PinchOnly, Work::Triangulate];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Work::Make => "make",
            Work::Check => "check",
            Work::Repair => "repair",
            Work::Cut => "cut",
            Work::PinchOnly => "pinch-only",
            Work::Triangulate => "triangulate",
        }
    }

    pub(crate) fn named(name: &str) -> Option<Self> {
        Work::ALL.into_iter().chain([Work::Make]).find(|work| work.name() == name)
    }

    /// The work of these names, all if there is none; nothing if one is not known.
    pub(crate) fn all_named(names: &[String]) -> Option<Vec<Self>> {
        if names.is_empty() {
            Some(Work::ALL.to_vec())
        } else {
            names.iter().map(|name| Work::named(name)).collect()
        }
    }

    pub(crate) fn run(self, mesh: &PolygonMesh) {
        match self {
            Work::Make => {}
            Work::Check => {
                KernelKind::EdgeUse.run(mesh.complex(), Report(mesh)).expect("the kernel holds anything");
            }
            Work::Repair => repair(mesh, |_| ()),
            Work::Cut => repair(mesh, |plan| plan.split.edges = SplitEdges::Cut),
            Work::PinchOnly => repair(mesh, |plan| plan.split.edges = SplitEdges::PinchOnly),
            Work::Triangulate => repair(mesh, |plan| plan.triangulate.faces = TriangulateFaces::All),
        }
    }
}

fn repair(mesh: &PolygonMesh, choose: impl FnOnce(&mut Plan)) {
    let mut plan = Plan::default();
    choose(&mut plan);
    plan.pipeline().run(mesh).expect("these policies take any mesh");
}

struct Report<'a>(&'a PolygonMesh);

impl KernelTask for Report<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology(kernel, self.0)
    }
}
