//! Opens the seams of patches that have no consistent orientation, and says what that added.

use meshmend_core::{Connectivity, CornerId, Defect, PolygonMesh};
use petgraph::unionfind::UnionFind;
use serde::Serialize;

use super::sheets::PatchSides;
use crate::apart::{NewVertices, corners_that_meet};
use crate::matching::{Matching, run_the_same_way};

/// What cutting non-orientable patches open along their seams took.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SeamFigures {
    /// How many edges were cut.
    pub edges: u64,
    /// How long they are together. Absent if one of them has no finite length.
    pub length: Option<f64>,
    /// How many edges there are now that would not be if the seams had been kept.
    pub edges_added: u64,
    /// How many vertices there are now that would not be if the seams had been kept.
    pub vertices_added: u64,
}

/// A pair of sides that were matched before they were parted.
pub(super) type Parted = (CornerId, CornerId);

/// Parts matched sides that run the same way, in patches that have no consistent orientation.
pub(super) fn part_seams<K: Connectivity>(kernel: &K, matching: &mut Matching) -> Vec<Parted> {
    let patches = PatchSides::patches(kernel, matching);
    let clashing: Vec<Parted> = matching
        .pairs()
        .filter(|&(one, other)| {
            run_the_same_way(kernel, one, other) && patches.is_twisted(kernel.corner_face(one))
        })
        .collect();
    clashing.iter().for_each(|&(one, other)| matching.part(one, other));
    clashing
}

/// The edges that were cut, as defects.
pub(super) fn seam_edges<K: Connectivity>(kernel: &K, seam: &[Parted]) -> impl Iterator<Item = Defect> {
    let edges = seam.iter().map(|&(one, _)| kernel.corner_edge(one));
    edges.map(|edge| Defect::seam_edge(edge, kernel.edge_ends(edge)))
}

/// What a seam took, when the corners are at these new vertices. Returns `None` where there is no seam.
///
/// *Cost*: linear in the vertices if there is one.
pub(super) fn seam_figures<K: Connectivity>(
    kernel: &K,
    mesh: &PolygonMesh,
    matching: &Matching,
    vertices: &NewVertices,
    seam: &[Parted],
) -> Option<SeamFigures> {
    if seam.is_empty() {
        return None;
    }
    let length: f64 = seam.iter().map(|&(one, _)| length(kernel, mesh, one)).sum();
    // If the seam were sewn up again, these edges would go, and one vertex for each two classes that meet.
    let open: Vec<&Parted> =
        seam.iter().filter(|&&(one, other)| matching.is_free(one) && matching.is_free(other)).collect();
    let mut sewn = UnionFind::<u32>::new(vertices.present.len());
    let corners = open.iter().flat_map(|&&(one, other)| corners_that_meet(kernel, one, other));
    let vertices_added = corners
        .filter(|&(one, other)| sewn.union(vertices.of_corner[one].0, vertices.of_corner[other].0))
        .count() as u64;
    Some(SeamFigures {
        edges: seam.len() as u64,
        length: length.is_finite().then_some(length),
        edges_added: open.len() as u64,
        vertices_added,
    })
}

/// The length of a side.
fn length<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, side: CornerId) -> f64 {
    let [from, to] = [kernel.corner_vertex(side), kernel.corner_target(side)].map(|v| mesh.position(v));
    let [x, y, z] = [0, 1, 2].map(|axis| to[axis] - from[axis]);
    x.hypot(y).hypot(z)
}
