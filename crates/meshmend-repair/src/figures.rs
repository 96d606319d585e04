//! The three figures by which a pass's effect on the topology is told.

use meshmend_core::{Connectivity, EdgeUse, PolygonMesh, is_manifold};
use meshmend_topology::{TopologyReport, boundary_loops, components};
use serde::Serialize;

/// χ, the number of components, and the number of boundary loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Figures {
    /// V − E + F.
    pub euler_characteristic: i64,
    /// Classes of faces joined by shared vertices.
    pub components: u64,
    /// Boundary loops; absent where the mesh is not manifold.
    pub boundary_loops: Option<u64>,
}

impl Figures {
    /// The figures of a mesh.
    ///
    /// *Cost*: builds the edge-use kernel, then linear.
    pub fn of(mesh: &PolygonMesh) -> Self {
        let kernel = EdgeUse::assemble(mesh.complex());
        let components = components(&kernel);
        let faces = mesh.complex().proper_face_count() as i64;
        Figures {
            euler_characteristic: components.referenced_vertices() as i64 - kernel.edge_count() as i64
                + faces,
            components: components.count() as u64,
            boundary_loops: is_manifold(&kernel).then(|| boundary_loops(&kernel).count() as u64),
        }
    }

    /// The figures that are in a report. *Cost*: O(1).
    pub(crate) fn of_report(report: &TopologyReport) -> Self {
        Figures {
            euler_characteristic: report.euler_characteristic,
            components: report.components,
            boundary_loops: report.boundary_loops,
        }
    }
}
