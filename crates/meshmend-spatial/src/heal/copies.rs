//! Which of several vertices in one place becomes a corner.

use meshmend_core::{CornerId, Id, PolygonMesh, VertexId};

use crate::t_junctions::Boundary;

/// The vertices of a mesh in which several share a place, where healing counts them as one.
pub(super) struct Copies<'a> {
    pub(super) mesh: &'a PolygonMesh,
    /// For each corner of the healed faces the one that it was at first; `None` for a new one.
    pub(super) sources: &'a [Option<CornerId>],
    /// The boundary of the healed faces.
    pub(super) boundary: &'a Boundary,
}

impl Copies<'_> {
    /// The vertex for a new corner: the lowest of those at which a side across from the corner's two begins or ends, so that
    /// they meet there; the lowest in the place if all of those are new too.
    pub(super) fn at(&self, corner: CornerId) -> VertexId {
        let (faces, edges) = (self.boundary.faces(), self.boundary.table());
        let place = faces.corner_vertex(corner);
        let sides = [faces.corner_before(faces.corner_face(corner), corner), corner];
        let along = sides.into_iter().flat_map(|side| edges.edge_corners(edges.corner_edge(side)));
        let ends = along.flat_map(|side| [side, faces.corner_after(faces.corner_face(side), side)]);
        let here = ends.filter(|&end| faces.corner_vertex(end) == place);
        let stored = here.filter_map(|end| self.sources[end.index()]);
        stored.map(|stored| self.mesh.faces().corner_vertex(stored)).min().unwrap_or(place)
    }
}
