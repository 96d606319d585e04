//! Which faces are shown about an element, and in which order they are laid out.

use meshmend_core::{Cell, Connectivity, CornerId, EdgeUse, FaceId, VertexId};

/// The faces about an element, each after one that it has an edge with, if there is one.
pub(super) struct Patch {
    pub(super) faces: Vec<FaceId>,
    /// The vertices of elements that are in no face.
    pub(super) alone: Vec<VertexId>,
}

impl Patch {
    /// The star of an element, and a face for each target that is not in it.
    pub(super) fn about(kernel: &EdgeUse, at: Cell, targets: impl Iterator<Item = Cell>) -> Self {
        let mut patch = Patch { faces: Vec::new(), alone: Vec::new() };
        patch.add_all(star(kernel, at));
        for cell in std::iter::once(at).chain(targets) {
            let around = star(kernel, cell);
            if !around.iter().any(|face| patch.faces.contains(face)) {
                patch.add_all(around.into_iter().take(1));
            }
            if let Cell::Vertex(vertex) = cell
                && !kernel.is_referenced(vertex)
                && !patch.alone.contains(&vertex)
            {
                patch.alone.push(vertex);
            }
        }
        patch
    }

    fn add_all(&mut self, faces: impl IntoIterator<Item = FaceId>) {
        for face in faces {
            if !self.faces.contains(&face) {
                self.faces.push(face);
            }
        }
    }

    /// The corners of all faces.
    pub(super) fn corners<'a>(&'a self, kernel: &'a EdgeUse) -> impl Iterator<Item = CornerId> + 'a {
        self.faces.iter().flat_map(|&face| kernel.face_corners(face))
    }
}

/// The faces about an element, its own first.
fn star(kernel: &EdgeUse, cell: Cell) -> Vec<FaceId> {
    match cell {
        Cell::Vertex(vertex) => kernel.vertex_faces(vertex).collect(),
        Cell::Edge(edge) => kernel.edge_faces(edge).collect(),
        Cell::Face(face) => Some(face).filter(|&face| kernel.is_proper_face(face)).into_iter().collect(),
        Cell::Corner(corner) => {
            let across = kernel.edge_faces(kernel.corner_edge(corner));
            std::iter::once(kernel.corner_face(corner)).chain(across).collect()
        }
    }
}
