//! Nothing but corners: who meets at an edge or a vertex is found by looking at all of them.

use meshmend_core::{
    Capabilities, Column, Complex, Connectivity, CornerId, Cost, Costs, EdgeId, FaceId, FaceIndex, VertexId,
};

/// The corners of a complex.
#[derive(Clone, Debug)]
pub(crate) struct Kernel {
    faces: FaceIndex,
    corner_edges: Column<CornerId, EdgeId>,
    edge_ends: Column<EdgeId, [VertexId; 2]>,
}

impl Connectivity for Kernel {
    const NAME: &'static str = "corner-scan";
    const CAPABILITIES: Capabilities = Capabilities::PERMISSIVE;
    const COSTS: Costs =
        Costs { edge_star: Cost::Linear, vertex_star: Cost::Linear, across: Cost::Linear, ..Costs::CONSTANT };

    fn assemble(complex: &Complex) -> Self {
        let (faces, edges) = (complex.shared_faces(), complex.edges());
        let corner_edges: Vec<EdgeId> = faces.corners().map(|corner| edges.corner_edge(corner)).collect();
        let edge_ends = edges.all_ends().to_vec();
        Kernel {
            faces: FaceIndex::new(faces),
            corner_edges: corner_edges.into(),
            edge_ends: edge_ends.into(),
        }
    }

    fn vertex_count(&self) -> usize {
        self.faces.faces().vertex_count()
    }
    fn edge_count(&self) -> usize {
        self.edge_ends.len()
    }
    fn face_count(&self) -> usize {
        self.faces.faces().face_count()
    }
    fn corner_count(&self) -> usize {
        self.corner_edges.len()
    }

    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.faces.faces().corner_vertex(corner)
    }
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.corner_edges[corner]
    }
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.faces.corner_face(corner)
    }
    fn next_corner(&self, corner: CornerId) -> CornerId {
        self.faces.next_corner(corner)
    }
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.faces.prev_corner(corner)
    }
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edge_ends[edge]
    }

    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.faces.faces().face_corners(face)
    }
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        self.corners().filter(move |&corner| self.corner_edge(corner) == edge)
    }
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.corners().filter(move |&corner| self.corner_vertex(corner) == vertex)
    }

    fn heap_bytes(&self) -> usize {
        self.faces.heap_bytes() + self.corner_edges.heap_bytes() + self.edge_ends.heap_bytes()
    }
}
