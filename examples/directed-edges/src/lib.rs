//! Directed edges: three to a triangle, each with the one that runs back along the same edge.

use meshmend_core::*;

/// Stands where there is no directed edge. There are fewer than 2³¹ corners, so none has this number.
const NONE: CornerId = CornerId(u32::MAX);

/// A directed edge is the side that begins at a corner, and has the corner's number.
pub struct DirectedEdges {
    /// The face table: the vertex at which each directed edge begins, and its face.
    faces: FaceIndex,
    /// The directed edge that runs back, or `NONE` on the boundary.
    across: Column<CornerId, CornerId>,
    /// The edge along which each directed edge runs.
    edge: Column<CornerId, EdgeId>,
    /// The lower directed edge of each edge.
    side: Column<EdgeId, CornerId>,
    /// A directed edge that leaves each vertex: the one on the boundary, or else the lowest; `NONE` if there is none.
    first: Column<VertexId, CornerId>,
}

impl Lesson for DirectedEdges {
    const TEXT: &'static str = include_str!("lesson.md");
}

/// Every edge has one side or two.
impl ManifoldConnectivity for DirectedEdges {}

#[rustfmt::skip]
impl Connectivity for DirectedEdges {
    const NAME: &'static str = "directed-edges";
    const CAPABILITIES: Capabilities = Capabilities { ordered_vertex_stars: true, ..Capabilities::TRIANGLES };

    fn assemble(complex: &Complex) -> Self {
        let (faces, edges) = (complex.shared_faces(), complex.edges());
        let edge = Column::exactly(faces.corners().map(|corner| edges.corner_edge(corner)));
        let mut across = Column::filled(NONE, faces.corner_count());
        let mut side = Column::filled(NONE, edges.edge_count());
        for corner in faces.corners() {
            let other = side[edge[corner]];
            if other == NONE {
                side[edge[corner]] = corner;
            } else {
                (across[corner], across[other]) = (other, corner);
            }
        }
        let mut first = Column::filled(NONE, faces.vertex_count());
        for corner in faces.corners() {
            let vertex = faces.corner_vertex(corner);
            if first[vertex] == NONE || across[corner] == NONE {
                first[vertex] = corner;
            }
        }
        DirectedEdges { faces: FaceIndex::new(faces), across, edge, side, first }
    }

    fn vertex_count(&self) -> usize { self.first.len() }
    fn edge_count(&self) -> usize { self.side.len() }
    fn face_count(&self) -> usize { self.faces.faces().face_count() }
    fn corner_count(&self) -> usize { self.across.len() }

    fn corner_vertex(&self, corner: CornerId) -> VertexId { self.faces.faces().corner_vertex(corner) }
    fn corner_edge(&self, corner: CornerId) -> EdgeId { self.edge[corner] }
    // Not `corner / 3`: degenerate faces have numbers too, and no corners.
    fn corner_face(&self, corner: CornerId) -> FaceId { self.faces.corner_face(corner) }
    fn next_corner(&self, CornerId(c): CornerId) -> CornerId { CornerId(c - c % 3 + (c + 1) % 3) }
    fn prev_corner(&self, CornerId(c): CornerId) -> CornerId { CornerId(c - c % 3 + (c + 2) % 3) }

    fn edge_ends(&self, edge: EdgeId) -> [VertexId; 2] {
        let (from, to) = (self.corner_vertex(self.side[edge]), self.corner_target(self.side[edge]));
        [from.min(to), from.max(to)]
    }
    fn across(&self, corner: CornerId) -> Option<CornerId> {
        Some(self.across[corner]).filter(|&other| other != NONE)
    }

    fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone {
        self.faces.faces().face_corners(face)
    }
    fn edge_corners(&self, edge: EdgeId) -> impl Iterator<Item = CornerId> + Clone {
        let side = self.side[edge];
        [Some(side), self.across(side)].into_iter().flatten()
    }
    fn vertex_corners(&self, vertex: VertexId) -> impl Iterator<Item = CornerId> + Clone {
        // The directed edge that comes in belongs to the same face; the one across it leaves, in the next face.
        let first = self.first[vertex];
        let turned = move |&corner: &CornerId| self.across(self.prev_corner(corner)).filter(|&next| next != first);
        std::iter::successors(Some(first).filter(|&corner| corner != NONE), turned)
    }

    fn heap_bytes(&self) -> usize { self.arrays().iter().map(Array::bytes).sum() }

    fn arrays(&self) -> Vec<Array> {
        let mut arrays = vec![
            Array::of_column("across", Per::Corner, &self.across),
            Array::of_column("edge", Per::Corner, &self.edge),
            Array::of_column("side", Per::Edge, &self.side),
            Array::of_column("first", Per::Vertex, &self.first),
        ];
        arrays.extend(self.faces.array());
        arrays
    }

    fn pointers(&self, of: Cell) -> Vec<Pointer> {
        let corner_or = |nothing, field, corner| match corner {
            NONE => Pointer { field, to: nothing },
            corner => Pointer::new(field, corner),
        };
        match of {
            Cell::Vertex(vertex) => vec![corner_or(Target::Nothing, "first", self.first[vertex])],
            Cell::Edge(edge) => vec![Pointer::new("side", self.side[edge])],
            Cell::Face(_) => Vec::new(),
            Cell::Corner(corner) => vec![
                Pointer::new("vertex", self.corner_vertex(corner)),
                corner_or(Target::Hole, "across", self.across[corner]),
                Pointer::new("edge", self.edge[corner]),
            ],
        }
    }
}
