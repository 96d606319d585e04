//! How a mesh hangs together, for the viewer's layers: components, generators, trees and seams.

use meshmend::mesh::EdgeId;
use meshmend::{CheckReport, VertexId};
use meshmend_render::Overlay;
use serde::Serialize;

use crate::packed::Packed;

/// Generators and their trees are looked for in meshes of at most so many faces.
const MOST_FACES: usize = 50_000;

/// How a mesh hangs together; what there is nothing of is absent.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct LoopData {
    /// For each vertex as stored the number of its component, or 2³² − 1; absent where there is only one.
    #[serde(skip_serializing_if = "Option::is_none")]
    components: Option<Packed>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    generators: Vec<Vec<u32>>,
    /// How many generators are not drawn.
    more_generators: usize,
    /// Edges by their ends.
    #[serde(skip_serializing_if = "Option::is_none")]
    tree: Option<Packed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cotree: Option<Packed>,
    #[serde(skip_serializing_if = "Option::is_none")]
    seam: Option<Packed>,
}

impl LoopData {
    /// How the mesh of a report hangs together, where that is worth a layer.
    pub(crate) fn of(report: &CheckReport, stored_vertices: usize) -> Self {
        let mut data = LoopData::default();
        if report.topology.components > 1 {
            data.components = Some(components(report, stored_vertices));
        }
        if report.mesh.faces().face_count() > MOST_FACES {
            return data;
        }
        if report.topology.non_orientable_patches > 0
            && let Overlay::Seam { edges } = meshmend_render::seam(&report.mesh)
        {
            data.seam = Some(ends(report, &edges));
        }
        if report.topology.betti.z2.is_some_and(|betti| betti[1] > 0)
            && let Ok(found) = meshmend_render::loops(&report.mesh)
            && let Overlay::Generators { loops, more } = found.generators
        {
            let name = |vertex: &VertexId| report.stored_vertex(*vertex).0;
            data.generators = loops.iter().map(|path| path.iter().map(name).collect()).collect();
            data.more_generators = more;
            let edges = |overlay| match overlay {
                Overlay::Tree { edges } | Overlay::Cotree { edges } => Some(ends(report, &edges)),
                _ => None,
            };
            (data.tree, data.cotree) = (edges(found.tree), edges(found.cotree));
        }
        data
    }
}

fn components(report: &CheckReport, stored_vertices: usize) -> Packed {
    let mut numbers = vec![u32::MAX; stored_vertices];
    if let Overlay::Components { of_vertex } = meshmend_render::components(&report.mesh) {
        for (vertex, component) in (0..).map(VertexId).zip(of_vertex) {
            let stored = report.stored_vertex(vertex).0 as usize;
            if let (Some(number), Some(component)) = (numbers.get_mut(stored), component) {
                *number = component;
            }
        }
    }
    Packed::Numbers(numbers)
}

fn ends(report: &CheckReport, edges: &[EdgeId]) -> Packed {
    let ends = |&edge: &EdgeId| report.mesh.complex().edges().ends(edge);
    edges.iter().flat_map(ends).map(|end| report.stored_vertex(end).0).collect()
}
