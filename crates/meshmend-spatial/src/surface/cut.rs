//! Larger faces as the triangles that the pass `triangulate` makes of them.

use meshmend_core::{CornerId, Draft, FaceId, FaceTableError, Id, PolygonMesh, VertexId, distinct_count};
use meshmend_geometry::vector::Point;
use meshmend_geometry::{FaceCutter, FreePoints, GatheredRoom, Spacing};

use super::triangle::Triangle;

/// A mesh whose larger faces are cut.
pub(super) struct Cut {
    draft: Draft,
    /// For each face of the mesh where its triangles begin in the draft, and one more.
    starts: Vec<u32>,
}

impl Cut {
    /// Cuts every simple face of more than three corners, in order, as the choice of a diagonal depends on those before it.
    pub(super) fn of(mesh: &PolygonMesh, lowest: &[VertexId]) -> Result<Self, FaceTableError> {
        let mut cutter = FaceCutter::new(mesh, lowest);
        let gather = || FreePoints::beside(Spacing::default(), mesh.positions().iter().copied());
        let mut room = GatheredRoom::new(gather);
        let mut starts = Vec::with_capacity(mesh.counts().faces + 1);
        for face in mesh.faces().faces() {
            starts.push(cutter.face_count() as u32);
            let vertices = mesh.faces().face_vertices(face);
            if vertices.len() <= 3 || distinct_count(vertices) < vertices.len() {
                cutter.keep(face);
            } else {
                cutter.cut(face, &[(0..vertices.len()).collect()], &mut room);
            }
        }
        starts.push(cutter.face_count() as u32);
        Ok(Cut { draft: cutter.into_draft()?, starts })
    }

    /// The points of the vertices on diagonals.
    pub(super) fn created(&self) -> Vec<Point> {
        self.draft.created_vertices.iter().map(|vertex| vertex.position).collect()
    }

    /// The triangles of a larger face, whose corners are named by `place`.
    pub(super) fn triangles_of(
        &self,
        mesh: &PolygonMesh,
        face: FaceId,
        place: impl Fn(VertexId) -> VertexId,
    ) -> impl Iterator<Item = Triangle> {
        let corners = mesh.faces().corner_range(face);
        let known = mesh.counts().vertices;
        let parts = self.starts[face.index()]..self.starts[face.index() + 1];
        parts.filter_map(move |part| {
            let first = self.draft.faces.corner_range(FaceId(part)).start;
            let vertices = <[VertexId; 3]>::try_from(self.draft.faces.face_vertices(FaceId(part))).ok()?;
            let source = |at: usize| self.draft.corner_sources.of(CornerId::new(first + at));
            let places = [0, 1, 2].map(|at| source(at).map(|corner| corner.index() - corners.start));
            let named = vertices.map(|vertex| if vertex.index() < known { place(vertex) } else { vertex });
            Some(Triangle::part(face, named, inside(places, corners.len())))
        })
    }
}

/// The corners and sides of a triangle that lie inside a face with so many corners: the places of its corners in the face are
/// given, where it has such.
fn inside(places: [Option<usize>; 3], count: usize) -> impl Iterator<Item = u8> {
    let corners = (0..3).filter(move |&at| places[at].is_none()).map(|at| 1 << at);
    let is_diagonal = move |at: usize| match (places[at], places[(at + 1) % 3]) {
        (Some(one), Some(other)) => {
            !matches!(one.abs_diff(other), distance if distance == 1 || distance == count - 1)
        }
        _ => true,
    };
    corners.chain((0..3).filter(move |&at| is_diagonal(at)).map(|at| 1 << at | 1 << ((at + 1) % 3)))
}
