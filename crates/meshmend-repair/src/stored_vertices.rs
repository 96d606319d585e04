//! The vertices as stored behind the corners of a mesh under repair.

use meshmend_core::{Complex, CornerId, Id, PolygonMesh, VertexId};

use crate::{Context, History};

/// The vertex as stored behind each corner of a mesh.
///
/// An id below the number of stored vertices is that of a stored vertex; ids beyond belong to vertices that an earlier
/// pass created.
pub(crate) struct StoredVertices<'a> {
    mesh: &'a PolygonMesh,
    complex: &'a Complex,
    history: Option<&'a History>,
}

impl<'a> StoredVertices<'a> {
    pub(crate) fn new(mesh: &'a PolygonMesh, context: &Context<'a>) -> Self {
        let history = context.history.filter(|h| !h.provenance().is_same());
        StoredVertices { mesh, complex: mesh.complex(), history }
    }

    /// Whether the mesh is as stored, so that its own vertices are the stored ones.
    pub(crate) fn are_present(&self) -> bool {
        self.history.is_none()
    }

    /// How many ids there are.
    pub(crate) fn count(&self) -> usize {
        self.stored_count() + self.history.map_or(0, |_| self.mesh.counts().vertices)
    }

    fn stored_count(&self) -> usize {
        self.history.map_or(self.mesh.counts().vertices, |h| h.stored().counts().vertices)
    }

    /// The vertex behind a corner of the complex.
    #[inline]
    pub(crate) fn of(&self, corner: CornerId) -> VertexId {
        let present = self.complex.faces().corner_vertex(corner);
        let Some(history) = self.history else { return present };
        match history.provenance().corners.of(self.complex.stored_corner(corner)) {
            Some(stored) => history.stored().faces().corner_vertex(stored),
            None => self.of_created(present),
        }
    }

    /// The vertex behind a vertex that has no corner.
    pub(crate) fn of_vertex(&self, present: VertexId) -> VertexId {
        let Some(history) = self.history else { return present };
        history.provenance().vertices.of(present).unwrap_or_else(|| self.of_created(present))
    }

    fn of_created(&self, present: VertexId) -> VertexId {
        VertexId::new(self.stored_count() + present.index())
    }

    /// The point at which a vertex was stored or created.
    pub(crate) fn position(&self, stored: VertexId) -> [f64; 3] {
        match (self.history, stored.index().checked_sub(self.stored_count())) {
            (Some(_), Some(present)) => self.mesh.position(VertexId::new(present)),
            (Some(history), None) => history.stored().position(stored),
            (None, _) => self.mesh.position(stored),
        }
    }
}
