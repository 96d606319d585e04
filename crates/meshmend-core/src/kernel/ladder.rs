//! The ladder of structures: what can be said without faces, and what without corners.
//!
//! A *view* stores less than a kernel. It stands on a lower rung, and has no method for what it can't say: a question
//! names in its bound the least rung that it needs, so asking too little a structure does not compile. Every kernel
//! stands on every rung.
//!
//! | rung | trait | knows |
//! |---|---|---|
//! | 1 | [`Adjacency`] | which vertices are joined |
//! | 2 | [`Incidence`] | which vertices, edges and faces touch, as sets |
//! | 3 | [`Connectivity`] | corners: the order round a face, repeated use, direction |
//!
//! The names differ from those of [`Connectivity`], so that all traits may be in scope together.

use crate::{Connectivity, EdgeId, FaceId, VertexId};

/// A graph: which vertices are joined by edges.
pub trait Adjacency {
    /// What the structure is called.
    const VIEW: &'static str;

    /// How many vertices and edges there are, unreferenced vertices included.
    fn graph_counts(&self) -> [usize; 2];

    /// The vertices that are joined to a vertex, each once, ascending.
    fn neighbours(&self, vertex: VertexId) -> impl Iterator<Item = VertexId>;
}

/// Which vertices, edges and faces touch: sets, without an order and without a direction.
pub trait Incidence: Adjacency {
    /// How many vertices, edges and faces there are, unreferenced vertices and degenerate faces included.
    fn cell_counts(&self) -> [usize; 3];

    /// The two vertices of an edge, the smaller one first.
    fn ends(&self, edge: EdgeId) -> [VertexId; 2];

    /// The edges at a vertex, each once, ascending.
    fn edges_at(&self, vertex: VertexId) -> impl Iterator<Item = EdgeId>;

    /// The faces along an edge, each once, ascending.
    fn faces_along(&self, edge: EdgeId) -> impl Iterator<Item = FaceId>;

    /// The edges of a face, each once, ascending; none for a degenerate face.
    fn edges_of(&self, face: FaceId) -> impl Iterator<Item = EdgeId>;
}

impl<K: Connectivity> Adjacency for K {
    const VIEW: &'static str = K::NAME;

    fn graph_counts(&self) -> [usize; 2] {
        [self.vertex_count(), self.edge_count()]
    }

    fn neighbours(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> {
        self.vertex_neighbours(vertex)
    }
}

impl<K: Connectivity> Incidence for K {
    fn cell_counts(&self) -> [usize; 3] {
        [self.vertex_count(), self.edge_count(), self.face_count()]
    }

    fn ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.edge_ends(edge)
    }

    fn edges_at(&self, vertex: VertexId) -> impl Iterator<Item = EdgeId> {
        self.vertex_edges(vertex)
    }

    fn faces_along(&self, edge: EdgeId) -> impl Iterator<Item = FaceId> {
        // The corners of an edge ascend, and so do their faces.
        let mut last = None;
        self.edge_faces(edge).filter(move |&face| last.replace(face) != Some(face))
    }

    fn edges_of(&self, face: FaceId) -> impl Iterator<Item = EdgeId> {
        let mut edges: Vec<EdgeId> = self.face_corners(face).map(|corner| self.corner_edge(corner)).collect();
        edges.sort_unstable();
        edges.dedup();
        edges.into_iter()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{Build, Complex, EdgeUse, FaceTableBuilder};

    fn kernel(vertices: usize, faces: &[&[u32]]) -> EdgeUse {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        EdgeUse::build(&Complex::of(&Arc::new(builder.build(vertices).unwrap()))).unwrap()
    }

    #[test]
    fn lower_rungs_name_each_neighbour_once() {
        // A face that comes back along an edge, a doubled triangle, a degenerate face and a vertex in no face.
        let kernel = kernel(7, &[&[0, 1, 2, 3, 2], &[3, 4, 5], &[4, 3, 5], &[0, 0, 1]]);
        assert_eq!(kernel.graph_counts(), [7, 7]);
        assert_eq!(kernel.cell_counts(), [7, 7, 4]);
        let neighbours = |v| kernel.neighbours(VertexId(v)).map(|n| n.0).collect::<Vec<_>>();
        assert_eq!([neighbours(2), neighbours(3), neighbours(6)], [vec![0, 1, 3], vec![2, 4, 5], vec![]]);
        let edges_of =
            |f| kernel.edges_of(FaceId(f)).map(|e| kernel.ends(e).map(|v| v.0)).collect::<Vec<_>>();
        assert_eq!(edges_of(0), [[0, 1], [0, 2], [1, 2], [2, 3]]);
        assert_eq!(edges_of(3), [[0; 2]; 0]);
        let spike = kernel.edges().find(|&e| kernel.ends(e) == [2, 3].map(VertexId)).unwrap();
        assert_eq!(kernel.faces_along(spike).collect::<Vec<_>>(), [FaceId(0)]);
        let shared = kernel.edges_at(VertexId(4)).next().unwrap();
        assert_eq!(kernel.faces_along(shared).collect::<Vec<_>>(), [FaceId(1), FaceId(2)]);
    }
}
