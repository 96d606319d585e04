//! The boundary of a mesh whose vertices at one position are joined.

use std::sync::Arc;

use meshmend_core::{
    Cancelled, Complex, CornerId, EdgeId, EdgeTable, FaceId, FaceTable, Id, PolygonMesh, VertexId, Watch,
};
use meshmend_geometry::coincident::watched_coincident_vertices;
use meshmend_geometry::vector::{Point, is_finite};

use super::STEP;

/// An edge with one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct BoundaryEdge {
    /// Its ends in the direction of its face.
    pub(crate) ends: [VertexId; 2],
    /// The face that has it.
    pub(crate) face: FaceId,
    /// The corner where its side begins.
    pub(crate) corner: CornerId,
}

/// The edges with one side whose ends are finite, by their ends.
pub(crate) struct Boundary {
    faces: Arc<FaceTable>,
    table: Arc<EdgeTable>,
    edges: Vec<BoundaryEdge>,
    /// Each end of an edge with the edge, ascending.
    at: Vec<(VertexId, u32)>,
}

impl Boundary {
    /// That of a mesh, each vertex being the lowest one at its position.
    ///
    /// # Errors
    /// When whoever watches stops it.
    ///
    /// *Cost*: that of the mesh's edges, and of those of the joined one if vertices share positions.
    pub(crate) fn welded(mesh: &PolygonMesh, watch: &Watch) -> Result<Self, Cancelled> {
        let faces = welded_faces(mesh, STEP, watch)?.map(Arc::new);
        watch.look(STEP, 0, 0)?;
        let of_faces = faces.as_ref().map(Complex::of);
        let complex = of_faces.as_ref().unwrap_or_else(|| mesh.complex());
        watch.look(STEP, 0, 0)?;
        complex.edges();
        watch.look(STEP, 0, 0)?;
        Ok(Self::of(complex, mesh.positions()))
    }

    /// That of a complex.
    ///
    /// *Cost*: linear; O(n log n) in the edges of the boundary.
    pub(crate) fn of(complex: &Complex, positions: &[Point]) -> Self {
        let (table, faces) = (complex.edges(), complex.faces());
        let mut edges = Vec::new();
        for edge in table.edges() {
            let ends = table.ends(edge);
            let [side] = table.edge_sides(edge) else { continue };
            if ends.iter().all(|end| is_finite(&positions[end.index()])) {
                let ends = if side.is_forward() { ends } else { [ends[1], ends[0]] };
                let corner = side.corner();
                edges.push(BoundaryEdge { ends, face: faces.corner_face(corner), corner });
            }
        }
        let ends = (0u32..).zip(&edges).flat_map(|(place, edge)| edge.ends.map(|end| (end, place)));
        let mut at: Vec<(VertexId, u32)> = ends.collect();
        at.sort_unstable();
        Boundary { faces: complex.shared_faces(), table: complex.shared_edges(), edges, at }
    }

    /// The faces, in normal form.
    pub(crate) fn faces(&self) -> &FaceTable {
        &self.faces
    }

    /// All edges of the faces.
    pub(crate) fn table(&self) -> &EdgeTable {
        &self.table
    }

    /// How many sides run between two vertices, the lower one first; 0 where that is an edge of the boundary.
    pub(crate) fn inner_degree(&self, ends: [VertexId; 2]) -> usize {
        let edge = self.table.all_ends().binary_search(&ends).map(EdgeId::new);
        let degree = edge.map_or(0, |edge| self.table.edge_sides(edge).len());
        if degree == 1 { 0 } else { degree }
    }

    /// All edges, by their ends.
    pub(crate) fn edges(&self) -> &[BoundaryEdge] {
        &self.edges
    }

    /// All vertices, ascending.
    pub(crate) fn vertices(&self) -> Vec<VertexId> {
        let mut vertices: Vec<VertexId> = self.at.iter().map(|&(vertex, _)| vertex).collect();
        vertices.dedup();
        vertices
    }

    /// The edges at a vertex, ascending.
    pub(crate) fn edges_at(&self, vertex: VertexId) -> impl Iterator<Item = u32> + '_ {
        let first = self.at.partition_point(|&(other, _)| other < vertex);
        self.at[first..].iter().take_while(move |&&(other, _)| other == vertex).map(|&(_, edge)| edge)
    }

    /// Whether a vertex is a corner of an edge's face.
    pub(crate) fn is_corner(&self, edge: u32, vertex: VertexId) -> bool {
        let face = self.edges[edge as usize].face;
        self.faces.face_vertices(face).contains(&vertex)
    }
}

/// The faces of a mesh, each vertex being the lowest one at its position; `None` if each is already.
///
/// # Errors
/// When whoever watches the step stops it.
pub(crate) fn welded_faces(
    mesh: &PolygonMesh,
    step: &'static str,
    watch: &Watch,
) -> Result<Option<FaceTable>, Cancelled> {
    let lowest = watched_coincident_vertices(mesh, || watch.look(step, 0, 0))?;
    if lowest.iter().enumerate().all(|(vertex, low)| low.index() == vertex) {
        return Ok(None);
    }
    let faces = mesh.faces();
    let corners = faces.corner_vertices().iter().map(|vertex| lowest[vertex.index()]).collect();
    // As many corners as before, and vertices of the same mesh.
    Ok(faces.over(faces.vertex_count(), corners).ok())
}
