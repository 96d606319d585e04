#![doc = include_str!("edge_use.md")]

use std::sync::Arc;

use crate::edges::vertex_corners::VertexCorners;
use crate::{
    Array, Capabilities, Cell, Complex, Connectivity, CornerId, EdgeId, EdgeTable, FaceId, FaceIndex, Lesson,
    Pointer, VertexId,
};

/// The edge-use table of a complex.
#[derive(Clone, Debug)]
pub struct EdgeUse {
    faces: FaceIndex,
    edges: Arc<EdgeTable>,
    vertex_corners: Arc<VertexCorners>,
}

impl Lesson for EdgeUse {
    const TEXT: &'static str = include_str!("edge_use.md");
}

impl Connectivity for EdgeUse {
    const NAME: &'static str = "edge-use";
    const CAPABILITIES: Capabilities = Capabilities::PERMISSIVE;

    fn assemble(complex: &Complex) -> Self {
        let faces = FaceIndex::new(complex.shared_faces());
        let (edges, vertex_corners) = (complex.shared_edges(), complex.shared_vertex_corners());
        EdgeUse { edges, faces, vertex_corners }
    }

    fn vertex_count(&self) -> usize {
        self.faces.faces().vertex_count()
    }
    fn edge_count(&self) -> usize {
        self.edges.edge_count()
    }
    fn face_count(&self) -> usize {
        self.faces.faces().face_count()
    }
    fn corner_count(&self) -> usize {
        self.faces.faces().corner_count()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.faces.faces().corner_vertex(corner)
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.edges.corner_edge(corner)
    }
    #[inline]
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.faces.corner_face(corner)
    }
    #[inline]
    fn next_corner(&self, corner: CornerId) -> CornerId {
        self.faces.next_corner(corner)
    }
    #[inline]
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.faces.prev_corner(corner)
    }
    #[inline]
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edges.ends(edge)
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.faces.faces().face_corners(face)
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        self.edges.edge_corners(edge)
    }
    #[inline]
    fn edge_sides(&self, edge: EdgeId) -> impl Iterator<Item = (CornerId, bool)> + Clone {
        self.edges.edge_sides(edge).iter().map(|side| (side.corner(), side.is_forward()))
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.vertex_corners.of(vertex).iter().copied()
    }

    fn heap_bytes(&self) -> usize {
        self.edges.heap_bytes() + self.faces.heap_bytes() + self.vertex_corners.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        let table = self.edges.arrays().map(Array::shared);
        let corners = self.vertex_corners.arrays().map(Array::shared);
        table.into_iter().chain(corners).chain(self.faces.array()).collect()
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        match of {
            Cell::Vertex(vertex) => {
                self.vertex_corners(vertex).map(|corner| Pointer::new("corner", corner)).collect()
            }
            Cell::Edge(edge) => {
                let ends = self.edge_ends(edge).map(|end| Pointer::new("end", end));
                let sides = self.edge_corners(edge).map(|side| Pointer::new("side", side));
                ends.into_iter().chain(sides).collect()
            }
            Cell::Face(face) => {
                self.face_corners(face).map(|corner| Pointer::new("corner", corner)).collect()
            }
            Cell::Corner(corner) => {
                vec![
                    Pointer::new("vertex", self.corner_vertex(corner)),
                    Pointer::new("edge", self.corner_edge(corner)),
                ]
            }
        }
    }
}
