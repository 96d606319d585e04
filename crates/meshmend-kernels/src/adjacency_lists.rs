//! Adjacency lists: every kind of neighbour of every kind of element, written down.
//!
//! ```text
//!        v3                 vertex   edges        corners      edge   ends    sides      face   edges
//!      ↙ f1 ↖               v0       e0 e1 e2     c0 c3        e0     v0 v1   c0         f0     e0 e3 e1
//!    v0 ───── v2            v1       e0 e3        c1           e1     v0 v2   c2 c3      f1     e1 e4 e2
//!      ↘ f0 ↗               v2       e1 e3 e4     c2 c4        e2     v0 v3   c5
//!        v1                 v3       e2 e4        c5           ...
//! ```
//!
//! *Layout*: for each vertex its edges (14 bytes a triangle) and its corners (14); for each edge its ends (12) and
//! its sides (18); for each face its edges, one a corner (12). 70 bytes a triangle in all. Faces of other sizes
//! add 4 bytes a corner for corner → face.
//!
//! *Admits* anything: lists grow as long as they have to.
//!
//! *Cost*: every query is constant time for each answer, the neighbours of a vertex included.
//!
//! *Choose it* where the graph of vertices and edges is asked about as often as the faces. It is the largest of
//! the permissive kernels, and what it says twice must agree.
//!
//! *Source*: the classical adjacency relations, as in course notes on the storage of polygonal meshes.

use meshmend_core::{
    Capabilities, Column, Complex, Connectivity, CornerId, EdgeId, FaceId, FaceIndex, Id, Lesson, Lists,
    VertexId,
};

/// The adjacency lists of a complex.
#[derive(Clone, Debug)]
pub struct AdjacencyLists {
    faces: FaceIndex,
    face_edges: Column<CornerId, EdgeId>,
    edge_ends: Column<EdgeId, [VertexId; 2]>,
    edge_corners: Lists<EdgeId, CornerId>,
    vertex_edges: Lists<VertexId, EdgeId>,
    vertex_corners: Lists<VertexId, CornerId>,
}

impl AdjacencyLists {
    /// The edges that end at a vertex, ascending.
    pub fn vertex_edges(&self, vertex: VertexId) -> impl ExactSizeIterator<Item = EdgeId> + Clone {
        self.vertex_edges.of(vertex).iter().copied()
    }

    /// The vertices that share an edge with a vertex, in the order of those edges.
    pub fn neighbours(&self, vertex: VertexId) -> impl ExactSizeIterator<Item = VertexId> + Clone {
        self.vertex_edges(vertex).map(move |edge| {
            let [low, high] = self.edge_ends[edge];
            if low == vertex { high } else { low }
        })
    }
}

impl Lesson for AdjacencyLists {
    const TEXT: &'static str = "Every kind of neighbour is written down: the edges and corners of each \
        vertex, the ends and sides of each edge, the edges of each face. It holds any complex, since lists grow \
        as long as they have to, in 70 bytes a triangle beside the faces themselves. Every query takes constant \
        time for each answer, the neighbours of a vertex included. Source: the classical adjacency relations, \
        as in course notes on the storage of polygonal meshes.";
}

impl Connectivity for AdjacencyLists {
    const NAME: &'static str = "adjacency-lists";
    const CAPABILITIES: Capabilities = Capabilities::PERMISSIVE;

    fn assemble(complex: &Complex) -> Self {
        let (faces, numbering) = (complex.shared_faces(), complex.edges());
        let mut face_edges = Vec::with_capacity(faces.corner_count());
        face_edges.extend(faces.corners().map(|c| numbering.corner_edge(c)));
        let edge_ends = numbering.all_ends().to_vec();

        let corners_by_edge = face_edges.iter().enumerate().map(|(c, &edge)| (edge, CornerId::new(c)));
        let edge_corners = Lists::group(edge_ends.len(), corners_by_edge);
        let edges_by_end =
            edge_ends.iter().enumerate().flat_map(|(edge, ends)| ends.map(|end| (end, EdgeId::new(edge))));
        let vertex_edges = Lists::group(faces.vertex_count(), edges_by_end);
        let corners_by_vertex = faces.corners().map(|c| (faces.corner_vertex(c), c));
        let vertex_corners = Lists::group(faces.vertex_count(), corners_by_vertex);

        AdjacencyLists {
            face_edges: face_edges.into(),
            edge_ends: edge_ends.into(),
            edge_corners,
            vertex_edges,
            vertex_corners,
            faces: FaceIndex::new(faces),
        }
    }

    fn vertex_count(&self) -> usize {
        self.vertex_corners.len()
    }
    fn edge_count(&self) -> usize {
        self.edge_ends.len()
    }
    fn face_count(&self) -> usize {
        self.faces.faces().face_count()
    }
    fn corner_count(&self) -> usize {
        self.face_edges.len()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.faces.faces().corner_vertex(corner)
    }
    #[inline]
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.face_edges[corner]
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
        self.edge_ends[edge]
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.faces.faces().face_corners(face)
    }
    #[inline]
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        self.edge_corners.of(edge).iter().copied()
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.vertex_corners.of(vertex).iter().copied()
    }

    fn heap_bytes(&self) -> usize {
        self.faces.heap_bytes()
            + self.face_edges.heap_bytes()
            + self.edge_ends.heap_bytes()
            + self.edge_corners.heap_bytes()
            + self.vertex_edges.heap_bytes()
            + self.vertex_corners.heap_bytes()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use meshmend_core::FaceTable;

    use super::*;

    #[test]
    fn neighbours_and_edges_are_those_of_the_picture() {
        let corners = [0, 1, 2, 0, 2, 3].map(VertexId).to_vec();
        let faces = Arc::new(FaceTable::triangles(5, corners).unwrap());
        let kernel = AdjacencyLists::assemble(&Complex::of(&faces));
        let neighbours = |v: u32| kernel.neighbours(VertexId(v)).map(|n| n.0).collect::<Vec<_>>();
        assert_eq!(neighbours(0), [1, 2, 3]);
        assert_eq!(neighbours(2), [0, 1, 3]);
        assert_eq!(neighbours(4), [0u32; 0]);
        let edges: Vec<_> = kernel.vertex_edges(VertexId(2)).map(|e| e.0).collect();
        assert_eq!(edges, [1, 3, 4]);
    }
}
