//! The corners of each vertex beside a kernel that has to search for them.

use std::ops::Deref;

use crate::{Capabilities, Complex, Connectivity, CornerId, Cost, Costs, EdgeId, FaceId, Lists, VertexId};

/// A kernel with the corners of each vertex grouped once, ascending.
///
/// Questions about all vertices ask it in place of a kernel whose vertex stars take [linear](Cost::Linear) time each, and
/// so stay near-linear. Everything else is the kernel's own answer.
///
/// *Cost*: 14 bytes a triangle, and two passes over the corners.
#[derive(Clone, Debug)]
pub struct Grouped<'a, K> {
    kernel: Held<'a, K>,
    vertex_corners: Lists<VertexId, CornerId>,
}

#[derive(Clone, Debug)]
enum Held<'a, K> {
    Borrowed(&'a K),
    Owned(K),
}

impl<K> Deref for Held<'_, K> {
    type Target = K;
    fn deref(&self) -> &K {
        match self {
            Held::Borrowed(kernel) => kernel,
            Held::Owned(kernel) => kernel,
        }
    }
}

impl<'a, K: Connectivity> Grouped<'a, K> {
    /// A kernel with the corners of its vertices grouped.
    pub fn of(kernel: &'a K) -> Self {
        Self::grouping(Held::Borrowed(kernel))
    }

    fn grouping(kernel: Held<'a, K>) -> Self {
        let at_vertices = kernel.corners().map(|corner| (kernel.corner_vertex(corner), corner));
        let vertex_corners = Lists::group(kernel.vertex_count(), at_vertices);
        Grouped { kernel, vertex_corners }
    }
}

impl<K: Connectivity> Connectivity for Grouped<'_, K> {
    const NAME: &'static str = K::NAME;
    const CAPABILITIES: Capabilities = Capabilities { ordered_vertex_stars: false, ..K::CAPABILITIES };
    const COSTS: Costs = Costs { vertex_star: Cost::Constant, ..K::COSTS };

    fn assemble(complex: &Complex) -> Self {
        Self::grouping(Held::Owned(K::assemble(complex)))
    }

    fn vertex_count(&self) -> usize {
        self.kernel.vertex_count()
    }
    fn edge_count(&self) -> usize {
        self.kernel.edge_count()
    }
    fn face_count(&self) -> usize {
        self.kernel.face_count()
    }
    fn corner_count(&self) -> usize {
        self.kernel.corner_count()
    }

    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.kernel.corner_vertex(corner)
    }
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        self.kernel.corner_edge(corner)
    }
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.kernel.corner_face(corner)
    }
    fn next_corner(&self, corner: CornerId) -> CornerId {
        self.kernel.next_corner(corner)
    }
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.kernel.prev_corner(corner)
    }
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.kernel.edge_ends(edge)
    }

    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.kernel.face_corners(face)
    }
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        self.kernel.edge_corners(edge)
    }
    fn edge_sides(&self, edge: EdgeId) -> impl Iterator<Item = (CornerId, bool)> + Clone {
        self.kernel.edge_sides(edge)
    }
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.vertex_corners.of(vertex).iter().copied()
    }
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        self.kernel.across(corner)
    }

    fn heap_bytes(&self) -> usize {
        self.kernel.heap_bytes() + self.vertex_corners.heap_bytes()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::{EdgeUse, FaceTable, VertexClass, vertex_classes};

    #[test]
    fn the_corners_are_those_of_the_kernel() {
        let corners = [0, 1, 2, 0, 3, 4, 0, 4, 5, 0, 5, 3].map(VertexId).to_vec();
        let complex = Complex::of(&Arc::new(FaceTable::triangles(7, corners).unwrap()));
        let (plain, grouped) = (EdgeUse::assemble(&complex), Grouped::<EdgeUse>::assemble(&complex));
        for vertex in plain.vertices() {
            assert!(plain.vertex_corners(vertex).eq(grouped.vertex_corners(vertex)));
        }
        assert_eq!(vertex_classes(&plain), vertex_classes(&grouped));
        let pinched = VertexClass::Pinched { umbrellas: 2, boundary_only: false };
        assert_eq!(vertex_classes(&grouped)[VertexId(0)], pinched);
        assert!(grouped.heap_bytes() > plain.heap_bytes());
        assert_eq!(Grouped::of(&plain).heap_bytes(), grouped.heap_bytes());
    }
}
