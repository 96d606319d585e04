//! The face-vertex table: faces list their vertices, vertices list their faces, and edges are looked up.
//!
//! ```text
//!        v3                  f0 : v0 v1 v2         v0 : f0 f1       e0 : v0 v1
//!      ↙ f1 ↖                f1 : v0 v2 v3         v1 : f0          e1 : v0 v2
//!    v0 ───── v2                                   v2 : f0 f1       e2 : v0 v3
//!      ↘ f0 ↗                                      v3 : f1          ...
//!        v1
//!                       which faces are along e1?  Those at v0 that also step to or from v2.
//! ```
//!
//! *Layout*: the face table, which the mesh shares; for each vertex its faces, as the corners by which they touch
//! it (14 bytes a triangle); the edges' ends and where each smaller vertex's edges begin (14 bytes a triangle). No
//! array leads from a side to its edge, from an edge to its sides, or from a corner to its face.
//!
//! *Admits* anything.
//!
//! *Cost*: corners of a face or vertex in constant time each. The edge of a corner is a binary search among the
//! smaller vertex's edges. The sides of an edge are found by looking round that end of it which has fewer corners:
//! about six looks on an ordinary triangle mesh, and even between crowded vertices no more than a power of 3/2 of
//! the mesh's size for all edges together. The face of a corner is a division for triangles, else a binary search.
//!
//! *Choose it* where memory is short and questions are asked of faces and vertices. It is what files and graphics
//! cards hold, and the plainest check on every other kernel.
//!
//! *Source*: course notes on the storage of polygonal meshes; A. Bærentzen, *On the Topology of Polygonal
//! Meshes*, 2025, §2.1.

use std::slice;
use std::sync::Arc;

use meshmend_core::{
    Capabilities, Column, Complex, Connectivity, CornerId, EdgeId, FaceId, FaceTable, Id, Lesson, Lists,
    VertexId,
};

/// The face-vertex table of a complex.
#[derive(Clone, Debug)]
pub struct FaceVertex {
    faces: Arc<FaceTable>,
    /// A face at a vertex is named by its corner there: a corner tells its face, and a face may come back.
    vertex_corners: Lists<VertexId, CornerId>,
    ends: Column<EdgeId, [VertexId; 2]>,
    /// Where the edges of each smaller vertex begin in the list of all, and one more.
    first_edge: Vec<u32>,
}

impl Lesson for FaceVertex {
    const TEXT: &'static str = "Faces list their vertices and vertices list their faces; of edges only \
        the ends are stored, and which faces run along an edge is found by looking round that end of it which \
        has fewer faces. It holds any complex, in 28 bytes a triangle beside the faces themselves, the least of \
        all kernels. The edge of a side takes a binary search, the sides of an edge a look at every face of one \
        vertex. Source: course notes on the storage of polygonal meshes; A. Bærentzen, On the Topology of \
        Polygonal Meshes, 2025, section 2.1.";
}

impl Connectivity for FaceVertex {
    const NAME: &'static str = "face-vertex";
    const CAPABILITIES: Capabilities = Capabilities::PERMISSIVE;

    fn assemble(complex: &Complex) -> Self {
        let faces = complex.shared_faces();
        let corners = faces.corners().map(|c| (faces.corner_vertex(c), c));
        let vertex_corners = Lists::group(faces.vertex_count(), corners);
        let ends: Column<EdgeId, _> = complex.edges().all_ends().to_vec().into();
        let mut first_edge = vec![0u32; faces.vertex_count() + 1];
        ends.values().iter().for_each(|[low, _]| first_edge[low.index() + 1] += 1);
        for vertex in 0..faces.vertex_count() {
            first_edge[vertex + 1] += first_edge[vertex];
        }
        FaceVertex { faces, vertex_corners, ends, first_edge }
    }

    fn vertex_count(&self) -> usize {
        self.vertex_corners.len()
    }
    fn edge_count(&self) -> usize {
        self.ends.len()
    }
    fn face_count(&self) -> usize {
        self.faces.face_count()
    }
    fn corner_count(&self) -> usize {
        self.faces.corner_count()
    }

    #[inline]
    fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.faces.corner_vertex(corner)
    }
    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        let (from, to) = (self.corner_vertex(corner), self.corner_vertex(self.next_corner(corner)));
        let (low, high) = (from.min(to).index(), from.max(to));
        let first = self.first_edge[low] as usize;
        let edges = &self.ends.values()[first..self.first_edge[low + 1] as usize];
        EdgeId::new(first + edges.partition_point(|ends| ends[1] < high))
    }
    #[inline]
    fn corner_face(&self, corner: CornerId) -> FaceId {
        self.faces.corner_face(corner)
    }
    #[inline]
    fn next_corner(&self, corner: CornerId) -> CornerId {
        self.faces.corner_after(self.corner_face(corner), corner)
    }
    #[inline]
    fn prev_corner(&self, corner: CornerId) -> CornerId {
        self.faces.corner_before(self.corner_face(corner), corner)
    }
    #[inline]
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        self.ends[edge]
    }

    #[inline]
    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.faces.face_corners(face)
    }
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let [low, high] = self.ends[edge];
        let (at_low, at_high) = (self.vertex_corners.of(low), self.vertex_corners.of(high));
        let (corners, far) = if at_low.len() <= at_high.len() { (at_low, high) } else { (at_high, low) };
        SidesToward { kernel: self, corners: corners.iter(), far, leaving: None, last_of_face: None }
    }
    #[inline]
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.vertex_corners.of(vertex).iter().copied()
    }

    fn heap_bytes(&self) -> usize {
        self.vertex_corners.heap_bytes()
            + self.ends.heap_bytes()
            + self.first_edge.capacity() * size_of::<u32>()
    }
}

/// The sides between one vertex, whose corners are looked through, and a vertex far from there; ascending.
#[derive(Clone)]
struct SidesToward<'a> {
    kernel: &'a FaceVertex,
    corners: slice::Iter<'a, CornerId>,
    far: VertexId,
    /// The corner last looked at, if its own side is one and has yet to be told.
    leaving: Option<CornerId>,
    /// A side found at the first corner of a face, before which it comes in the face but not in the order.
    last_of_face: Option<CornerId>,
}

impl Iterator for SidesToward<'_> {
    type Item = CornerId;

    fn next(&mut self) -> Option<CornerId> {
        loop {
            if let Some(side) = self.leaving.take() {
                return Some(side);
            }
            let ahead = self.corners.as_slice().first();
            if let Some(side) = self.last_of_face.take_if(|last| ahead.is_none_or(|c| *c > *last)) {
                return Some(side);
            }
            let corner = *self.corners.next()?;
            self.leaving = (self.kernel.corner_target(corner) == self.far).then_some(corner);
            let before = self.kernel.prev_corner(corner);
            if self.kernel.corner_vertex(before) == self.far {
                if before < corner {
                    return Some(before);
                }
                self.last_of_face = Some(before);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::FaceTableBuilder;

    use super::*;

    fn kernel(vertices: usize, faces: &[&[u32]]) -> FaceVertex {
        let mut builder = FaceTableBuilder::default();
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        FaceVertex::assemble(&Complex::of(&Arc::new(builder.build(vertices).unwrap())))
    }

    #[test]
    fn a_side_that_closes_its_face_comes_in_its_place() {
        // v0-v1 is used at the start, in the middle and at the end of the first face, and again in the second.
        let kernel = kernel(5, &[&[0, 1, 2, 1, 0, 3, 1], &[1, 0, 4]]);
        let sides: Vec<_> = kernel.edge_corners(EdgeId(0)).map(|c| c.0).collect();
        assert_eq!(sides, [0, 3, 6, 7]);
    }

    #[test]
    fn the_less_crowded_end_is_looked_round() {
        // A fan about v0: every spoke has a crowded end, so looking round that one would take quadratic time.
        let count = if cfg!(miri) { 200 } else { 200_000u32 };
        let corners = (1..count).flat_map(|v| [0, v, v + 1].map(VertexId)).collect();
        let faces = FaceTable::triangles(count as usize + 1, corners).unwrap();
        let kernel = FaceVertex::assemble(&Complex::of(&Arc::new(faces)));
        let degrees: usize = kernel.edges().map(|e| kernel.edge_degree(e)).sum();
        assert_eq!(degrees, kernel.corner_count());
    }
}
