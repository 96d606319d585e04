//! A mesh that was looked at before it is repaired, so that nothing is found out twice.

use meshmend_core::{Connectivity, PolygonMesh, Sources, VertexId};
use meshmend_kernels::{KernelKind, KernelTask};
use meshmend_topology::{TopologyReport, Witness, topology_with};

use crate::{Context, Outcome, Pass, PassError, Weld};

/// A mesh with its topology, as stored or as welded.
///
/// ```
/// # use meshmend_core::{FaceTable, PolygonMesh, VertexId};
/// # use meshmend_repair::{Examined, Pipeline, Weld};
/// # use meshmend_topology::Witness;
/// # let positions = [[0, 0], [1, 0], [0, 1], [1, 0], [0, 1], [1, 1]].map(|[x, y]| [x.into(), y.into(), 0.0]);
/// # let faces = FaceTable::triangles(6, (0..6).map(VertexId).collect())?;
/// # let mesh = PolygonMesh::new(positions.to_vec(), faces)?;
/// let examined = Examined::of(&mesh, Some(Weld::default()), Default::default(), Witness::default())?;
/// println!("{} components before", examined.report().components);
/// let repaired = Pipeline::default().run_examined(examined, None, |_| {})?;
/// # assert_eq!(repaired.mesh.positions().len(), 4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Examined {
    pub(crate) stored: PolygonMesh,
    /// The mesh that the report is on, with the tables that were built for it.
    pub(crate) mesh: PolygonMesh,
    /// What made it of the mesh as stored, if anything did.
    pub(crate) weld: Option<(Weld, Outcome)>,
    pub(crate) kernel: KernelKind,
    pub(crate) report: TopologyReport,
}

struct Analyse<'a> {
    mesh: &'a PolygonMesh,
    witness: Witness,
}

impl KernelTask for Analyse<'_> {
    type Output = TopologyReport;
    fn run<K: Connectivity>(self, kernel: &K) -> TopologyReport {
        topology_with(kernel, self.mesh, self.witness)
    }
}

impl Examined {
    /// Looks at a mesh as it is stored, or as a weld makes it.
    ///
    /// # Errors
    /// When the kernel can't hold the mesh, or the weld's distance is none.
    ///
    /// *Cost*: that of the weld and of [`topology_with`].
    pub fn of(
        mesh: &PolygonMesh,
        weld: Option<Weld>,
        kernel: KernelKind,
        witness: Witness,
    ) -> Result<Self, PassError> {
        let welded = weld.map(|weld| weld.apply(mesh, &Context::default()).map(|outcome| (weld, outcome)));
        let weld = welded.transpose()?;
        // What is built for it goes when a repair has made another mesh of it.
        let viewed = weld.as_ref().map_or(mesh, |(_, outcome)| &outcome.mesh).with_own_cache();
        let report = kernel.run(viewed.complex(), Analyse { mesh: &viewed, witness })?;
        Ok(Examined { stored: mesh.clone(), mesh: viewed, weld, kernel, report })
    }

    /// The mesh that was looked at.
    pub fn mesh(&self) -> &PolygonMesh {
        &self.mesh
    }

    /// The vertex as stored that each of its vertices is: of those that a weld joined, the lowest.
    pub fn vertex_sources(&self) -> Sources<VertexId> {
        let same = || Sources::same(self.mesh.counts().vertices);
        self.weld.as_ref().map_or_else(same, |(_, outcome)| outcome.provenance.vertices.clone())
    }

    /// Its topology.
    pub fn report(&self) -> &TopologyReport {
        &self.report
    }
}
