//! The boundary of a mesh whose vertices at one position are joined.

use std::sync::Arc;

use meshmend_core::{Complex, FaceId, FaceTable, Id, PolygonMesh, VertexId};
use meshmend_geometry::coincident::coincident_vertices;
use meshmend_geometry::vector::{Point, is_finite};

/// An edge with one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct BoundaryEdge {
    /// Its ends in the direction of its face.
    pub(super) ends: [VertexId; 2],
    /// The face that has it.
    pub(super) face: FaceId,
}

/// The edges with one side whose ends are finite, by their ends.
pub(super) struct Boundary {
    faces: Arc<FaceTable>,
    edges: Vec<BoundaryEdge>,
    /// Each end of an edge with the edge, ascending.
    at: Vec<(VertexId, u32)>,
}

impl Boundary {
    /// That of a mesh, each vertex being the lowest one at its position.
    ///
    /// *Cost*: that of the mesh's edges, and of those of the joined one if vertices share positions.
    pub(super) fn welded(mesh: &PolygonMesh) -> Self {
        match welded(mesh) {
            Some(faces) => Self::of(&Complex::of(&Arc::new(faces)), mesh.positions()),
            None => Self::of(mesh.complex(), mesh.positions()),
        }
    }

    /// That of a complex.
    ///
    /// *Cost*: linear; O(n log n) in the edges of the boundary.
    pub(super) fn of(complex: &Complex, positions: &[Point]) -> Self {
        let (table, faces) = (complex.edges(), complex.faces());
        let mut edges = Vec::new();
        for edge in table.edges() {
            let ends = table.ends(edge);
            let [side] = table.edge_sides(edge) else { continue };
            if ends.iter().all(|end| is_finite(&positions[end.index()])) {
                let ends = if side.is_forward() { ends } else { [ends[1], ends[0]] };
                edges.push(BoundaryEdge { ends, face: faces.corner_face(side.corner()) });
            }
        }
        let ends = (0u32..).zip(&edges).flat_map(|(place, edge)| edge.ends.map(|end| (end, place)));
        let mut at: Vec<(VertexId, u32)> = ends.collect();
        at.sort_unstable();
        Boundary { faces: complex.shared_faces(), edges, at }
    }

    /// All edges, by their ends.
    pub(super) fn edges(&self) -> &[BoundaryEdge] {
        &self.edges
    }

    /// All vertices, ascending.
    pub(super) fn vertices(&self) -> Vec<VertexId> {
        let mut vertices: Vec<VertexId> = self.at.iter().map(|&(vertex, _)| vertex).collect();
        vertices.dedup();
        vertices
    }

    /// The edges at a vertex, ascending.
    pub(super) fn edges_at(&self, vertex: VertexId) -> impl Iterator<Item = u32> + '_ {
        let first = self.at.partition_point(|&(other, _)| other < vertex);
        self.at[first..].iter().take_while(move |&&(other, _)| other == vertex).map(|&(_, edge)| edge)
    }

    /// Whether a vertex is a corner of an edge's face.
    pub(super) fn is_corner(&self, edge: u32, vertex: VertexId) -> bool {
        let face = self.edges[edge as usize].face;
        self.faces.face_vertices(face).contains(&vertex)
    }
}

/// The faces of a mesh, each vertex being the lowest one at its position; `None` if each is already.
fn welded(mesh: &PolygonMesh) -> Option<FaceTable> {
    let lowest = coincident_vertices(mesh);
    if lowest.iter().enumerate().all(|(vertex, low)| low.index() == vertex) {
        return None;
    }
    let faces = mesh.faces();
    let corners = faces.corner_vertices().iter().map(|vertex| lowest[vertex.index()]).collect();
    // As many corners as before, and vertices of the same mesh.
    faces.over(faces.vertex_count(), corners).ok()
}
