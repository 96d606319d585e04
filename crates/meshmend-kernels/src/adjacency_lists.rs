#![doc = include_str!("adjacency_lists.md")]

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, EdgeId, FaceId, FaceIndex, Id,
    Lesson, Lists, Per, Pointer, VertexId,
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

impl Lesson for AdjacencyLists {
    const TEXT: &'static str = include_str!("adjacency_lists.md");
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
    #[inline]
    fn vertex_edges(&self, vertex: VertexId) -> impl Iterator<Item = EdgeId> + Clone {
        self.vertex_edges.of(vertex).iter().copied()
    }

    fn heap_bytes(&self) -> usize {
        self.faces.heap_bytes()
            + self.face_edges.heap_bytes()
            + self.edge_ends.heap_bytes()
            + self.edge_corners.heap_bytes()
            + self.vertex_edges.heap_bytes()
            + self.vertex_corners.heap_bytes()
    }

    fn arrays(&self) -> Vec<Array> {
        let mut arrays = vec![
            Array::of_column("face edges", Per::Corner, &self.face_edges),
            Array::of_column("edge ends", Per::Edge, &self.edge_ends),
        ];
        arrays.extend(self.edge_corners.arrays(("edge starts", Per::Edge), ("edge sides", Per::Corner)));
        arrays.extend(
            self.vertex_edges.arrays(("vertex edge starts", Per::Vertex), ("vertex edges", Per::Dart)),
        );
        let names = (("vertex corner starts", Per::Vertex), ("vertex corners", Per::Corner));
        arrays.extend(self.vertex_corners.arrays(names.0, names.1));
        arrays.extend(self.faces.array());
        arrays
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        match of {
            Cell::Vertex(vertex) => {
                let edges = self.vertex_edges(vertex).map(|edge| Pointer::new("edge", edge));
                edges
                    .chain(self.vertex_corners(vertex).map(|corner| Pointer::new("corner", corner)))
                    .collect()
            }
            Cell::Edge(edge) => {
                let ends = self.edge_ends[edge].map(|end| Pointer::new("end", end));
                let sides = self.edge_corners(edge).map(|side| Pointer::new("side", side));
                ends.into_iter().chain(sides).collect()
            }
            Cell::Face(face) => {
                self.face_corners(face).map(|side| Pointer::new("edge", self.face_edges[side])).collect()
            }
            Cell::Corner(corner) => vec![
                Pointer::new("vertex", self.corner_vertex(corner)),
                Pointer::new("edge", self.face_edges[corner]),
            ],
        }
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
        let neighbours = |v: u32| kernel.vertex_neighbours(VertexId(v)).map(|n| n.0).collect::<Vec<_>>();
        assert_eq!(neighbours(0), [1, 2, 3]);
        assert_eq!(neighbours(2), [0, 1, 3]);
        assert_eq!(neighbours(4), [0u32; 0]);
        let edges: Vec<_> = kernel.vertex_edges(VertexId(2)).map(|e| e.0).collect();
        assert_eq!(edges, [1, 3, 4]);
    }
}
