//! Which edges do neither a tree of the vertices nor a tree of the faces use?
//!
//! In the *dual* the faces are the nodes, and each edge joins the two faces along it. A boundary edge has one face,
//! so each boundary loop is a node as well, as if it were a face: a tree of the vertices that touches a boundary
//! twice would otherwise cut faces off. Edges are offered to the tree of the dual in an order, and each that joins
//! two parts is taken (J. B. Kruskal, 1956): what is neither in one tree nor in the other is left over.

use meshmend_core::{Cancelled, Column, Connectivity, EdgeId, VertexId, Watch};
use petgraph::unionfind::UnionFind;
use serde::Serialize;

use super::STEP;
use super::surfaces::Surfaces;

/// In which order edges are offered to the tree of the faces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum CoTree {
    /// By number.
    #[default]
    Lowest,
    /// Those whose loops through the root are the longest first, so that what is left is the shortest system of
    /// loops at the root. *Source*: J. Erickson, K. Whittlesey, *Greedy optimal homotopy and homology generators*,
    /// 2005.
    Greedy,
}

/// The faces, and the boundary loops as if they were faces.
pub(super) struct Dual<'a, K> {
    kernel: &'a K,
    /// The boundary loop through each vertex; empty where there is no boundary.
    loop_of_vertex: Column<VertexId, u32>,
    loop_count: usize,
}

impl<'a, K: Connectivity> Dual<'a, K> {
    pub(super) fn new(kernel: &'a K, surfaces: &Surfaces) -> Self {
        let loops = &surfaces.boundary;
        let mut loop_of_vertex = Column::default();
        if loops.count() > 0 {
            loop_of_vertex = Column::filled(u32::MAX, kernel.vertex_count());
        }
        for (place, vertices) in (0..).zip(loops.iter()) {
            vertices.iter().for_each(|&vertex| loop_of_vertex[vertex] = place);
        }
        Dual { kernel, loop_of_vertex, loop_count: loops.count() }
    }

    /// The boundary loop that a boundary edge of a surface is in.
    pub(super) fn boundary_loop(&self, edge: EdgeId) -> u32 {
        self.loop_of_vertex[self.kernel.edge_ends(edge)[0]]
    }

    /// The two faces along an edge of a surface, which may be one and the same; a boundary loop comes after all
    /// faces.
    fn ends(&self, edge: EdgeId) -> Option<[u32; 2]> {
        let mut faces = self.kernel.edge_faces(edge).map(|face| face.0);
        let first = faces.next()?;
        let beyond = || self.kernel.face_count() as u32 + self.boundary_loop(edge);
        Some([first, faces.next().unwrap_or_else(beyond)])
    }

    /// The edges that a tree of the faces and the boundary loops takes of those that it is offered, and those that it
    /// leaves over, ascending.
    ///
    /// *Cost*: near-linear; 5 bytes a face and 4 an edge.
    ///
    /// # Errors
    /// If the watch stops it.
    pub(super) fn split(&self, order: &[EdgeId], watch: &Watch) -> Result<[Vec<EdgeId>; 2], Cancelled> {
        let mut parts = UnionFind::<u32>::new(self.kernel.face_count() + self.loop_count);
        let (mut taken, mut left) = (Vec::new(), Vec::new());
        for (place, &edge) in order.iter().enumerate() {
            watch.look_at_times(STEP, place, order.len())?;
            let joins = self.ends(edge).is_some_and(|[one, other]| parts.union(one, other));
            if joins { taken.push(edge) } else { left.push(edge) }
        }
        taken.sort_unstable();
        left.sort_unstable();
        Ok([taken, left])
    }

    /// For each edge whether a tree of the faces alone crosses it.
    ///
    /// *Cost*: near-linear; 5 bytes a face and 1 an edge.
    ///
    /// # Errors
    /// If the watch stops it.
    pub(super) fn crossed(
        &self,
        order: impl Iterator<Item = EdgeId>,
        watch: &Watch,
    ) -> Result<Column<EdgeId, bool>, Cancelled> {
        let mut parts = UnionFind::<u32>::new(self.kernel.face_count());
        let mut is_crossed = Column::filled(false, self.kernel.edge_count());
        for (place, edge) in order.enumerate() {
            watch.look_at_times(STEP, place, self.kernel.edge_count())?;
            let mut faces = self.kernel.edge_faces(edge);
            if let (Some(one), Some(other)) = (faces.next(), faces.next()) {
                is_crossed[edge] = parts.union(one.0, other.0);
            }
        }
        Ok(is_crossed)
    }
}
