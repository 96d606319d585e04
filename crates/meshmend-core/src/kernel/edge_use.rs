//! The edge-use table: each edge lists the sides that run along it. The fast default.
//!
//! ```text
//!            v1                 edge v0-v1 : c0 c4 c9      any number of sides
//!          ↗ ↑ ↖                edge v0-v2 : c2
//!        c0  c4  c9             ...
//!            v0                 vertex v0  : c0 c4 c9      corners that stand there
//! ```
//!
//! *Layout*: the canonical edge table (ends, corner → edge, edge → corners: 42 bytes a triangle), which the complex
//! shares as well as the corners of each vertex (14 bytes a triangle). Faces of other sizes add 4 bytes a corner for
//! corner → face.
//!
//! *Admits* anything: a use is a record of its own, so an edge with three sides is not a special case.
//!
//! *Cost*: every query is constant time for each answer.
//!
//! *Choose it* unless another structure is the point. It does not order the sides of an edge by angle: that is
//! geometry, and this is an index.
//!
//! *Source*: the uses of K. Weiler, *The radial edge structure*, 1988.

use std::sync::Arc;

use crate::edges::vertex_corners::VertexCorners;
use crate::{
    Capabilities, Complex, Connectivity, CornerId, EdgeId, EdgeTable, FaceId, FaceIndex, Lesson, VertexId,
};

/// The edge-use table of a complex.
#[derive(Clone, Debug)]
pub struct EdgeUse {
    faces: FaceIndex,
    edges: Arc<EdgeTable>,
    vertex_corners: Arc<VertexCorners>,
}

impl Lesson for EdgeUse {
    const TEXT: &'static str = "Each edge lists the face sides that run along it, and each vertex the \
        corners that stand at it. It holds any complex: a side is a record of its own, so an edge with three \
        sides is no special case. Every query takes constant time for each answer; 42 bytes a triangle are \
        shared with the mesh and 14 are its own. The default. Source: the edge uses of K. Weiler, The radial \
        edge structure, 1988, without the order by angle, which is geometry.";
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
}
