#![doc = include_str!("face_vertex.md")]

use std::slice;
use std::sync::Arc;

use meshmend_core::{
    Array, Capabilities, Cell, Column, Complex, Connectivity, CornerId, Cost, Costs, EdgeId, FaceId,
    FaceTable, Id, Lesson, Lists, Per, Pointer, VertexId,
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
    const TEXT: &'static str = include_str!("face_vertex.md");
}

impl Connectivity for FaceVertex {
    const NAME: &'static str = "face-vertex";
    const CAPABILITIES: Capabilities = Capabilities::PERMISSIVE;
    const COSTS: Costs =
        Costs { corner: Cost::Degree, edge_star: Cost::Degree, across: Cost::Degree, ..Costs::CONSTANT };

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

    fn arrays(&self) -> Vec<Array> {
        let mut arrays = self
            .vertex_corners
            .arrays(("vertex starts", Per::Vertex), ("vertex corners", Per::Corner))
            .to_vec();
        arrays.push(Array::of_column("edge ends", Per::Edge, &self.ends));
        arrays.push(Array::new("first edge", Per::Vertex, size_of::<u32>(), self.first_edge.capacity()));
        arrays
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        match of {
            Cell::Vertex(vertex) => {
                self.vertex_corners(vertex).map(|corner| Pointer::new("corner", corner)).collect()
            }
            Cell::Edge(edge) => self.ends[edge].map(|end| Pointer::new("end", end)).to_vec(),
            Cell::Face(face) => {
                self.face_vertices(face).map(|vertex| Pointer::new("vertex", vertex)).collect()
            }
            Cell::Corner(corner) => vec![Pointer::new("vertex", self.corner_vertex(corner))],
        }
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
