//! Faces and the faces at each vertex: what most files hold, and no more. Edges are looked for where two vertices meet.

use std::sync::Arc;

use meshmend_core::*;

/// The face table itself, the corners of each vertex, and the ends of each edge.
pub struct MyKernel {
    faces: FaceIndex,
    corners_at: Lists<VertexId, CornerId>,
    ends: Column<EdgeId, [VertexId; 2]>,
}

impl Lesson for MyKernel {
    const TEXT: &'static str = "# My kernel: faces list their vertices, and vertices their corners\n\n\
        It holds anything. Source: the indexed face set of most file formats.\n";
}

#[rustfmt::skip]
impl Connectivity for MyKernel {
    const NAME: &'static str = "my-kernel";
    const CAPABILITIES: Capabilities = Capabilities::PERMISSIVE;
    const COSTS: Costs = Costs { edge_star: Cost::Degree, across: Cost::Degree, ..Costs::CONSTANT };

    fn assemble(complex: &Complex) -> Self {
        let faces: Arc<FaceTable> = complex.shared_faces();
        let at_vertices = faces.corners().map(|corner| (faces.corner_vertex(corner), corner));
        let corners_at = Lists::group(faces.vertex_count(), at_vertices);
        let ends = complex.edges().all_ends().to_vec().into();
        MyKernel { faces: FaceIndex::new(faces), corners_at, ends }
    }

    fn vertex_count(&self) -> usize { self.corners_at.len() }
    fn edge_count(&self) -> usize { self.ends.len() }
    fn face_count(&self) -> usize { self.faces.faces().face_count() }
    fn corner_count(&self) -> usize { self.faces.faces().corner_count() }

    fn corner_vertex(&self, corner: CornerId) -> VertexId { self.faces.faces().corner_vertex(corner) }
    fn corner_face(&self, corner: CornerId) -> FaceId { self.faces.corner_face(corner) }
    fn next_corner(&self, corner: CornerId) -> CornerId { self.faces.next_corner(corner) }
    fn prev_corner(&self, corner: CornerId) -> CornerId { self.faces.prev_corner(corner) }
    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] { self.ends[edge] }

    fn corner_edge(&self, corner: CornerId) -> EdgeId {
        // Edges are numbered by their ends, the smaller one first.
        let (from, to) = (self.corner_vertex(corner), self.corner_target(corner));
        EdgeId::new(self.ends.values().partition_point(|ends| *ends < [from.min(to), from.max(to)]))
    }

    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.faces.faces().face_corners(face)
    }
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        self.corners_at.of(vertex).iter().copied()
    }
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let [low, high] = self.ends[edge];
        let is_low_crowded = self.corners_at.of(low).len() > self.corners_at.of(high).len();
        let (here, there) = if is_low_crowded { (high, low) } else { (low, high) };
        let both = self.vertex_corners(here).flat_map(|corner| [corner, self.prev_corner(corner)]);
        let mut sides: Vec<_> = both.filter(|&side| {
            [self.corner_vertex(side), self.corner_target(side)].contains(&there)
        }).collect();
        sides.sort_unstable();
        sides.into_iter()
    }

    fn heap_bytes(&self) -> usize {
        self.faces.heap_bytes() + self.corners_at.heap_bytes() + self.ends.heap_bytes()
    }
}
