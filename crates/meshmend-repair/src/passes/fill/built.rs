//! The mesh that comes of covering holes.

use meshmend_core::{
    CornerId, Draft, FaceTableBuilder, FilledHole, Id, PolygonMesh, Provenance, Sources, VertexDraft,
    VertexId,
};

use super::hole::{Cover, Hole};
use crate::PassError;

/// The mesh with fills as it is built.
pub(super) struct Built<'a> {
    mesh: &'a PolygonMesh,
    builder: FaceTableBuilder,
    faces: usize,
    corners: usize,
    created: Vec<VertexDraft>,
    holes: Vec<FilledHole>,
    closed: Vec<CornerId>,
}

impl<'a> Built<'a> {
    pub(super) fn of(mesh: &'a PolygonMesh) -> Self {
        let mut builder = FaceTableBuilder::default();
        mesh.faces().faces().for_each(|f| builder.push_face(mesh.faces().face_vertices(f).iter().copied()));
        let counts = mesh.counts();
        let (faces, corners) = (counts.faces, counts.corners);
        let (created, holes, closed) = (Vec::new(), Vec::new(), Vec::new());
        Built { mesh, builder, faces, corners, created, holes, closed }
    }

    /// Adds what covers a hole.
    pub(super) fn add(&mut self, hole: &Hole<'_>, cover: &Cover) {
        let centre = cover.centre.map(|position| {
            self.created.push(VertexDraft { position, place: None });
            VertexId::new(self.mesh.counts().vertices + self.created.len() - 1)
        });
        let first = self.faces;
        let mut corners = Vec::with_capacity(3 * cover.triangles.len());
        for triangle in &cover.triangles {
            let vertices = triangle.map(|corner| hole.vertices.get(corner).copied().or(centre));
            self.builder.push_face(vertices.into_iter().flatten());
            for (at, corner) in triangle.iter().enumerate() {
                let beside = hole.sides.get(*corner).map(|side| side.corners);
                corners.extend(beside.map(|beside| (CornerId::new(self.corners + at), beside)));
            }
            self.faces += 1;
            self.corners += 3;
        }
        let beside = hole.sides.iter().map(|side| side.face).collect();
        self.holes.push(FilledHole { faces: first..self.faces, beside, corners });
        self.closed.extend(hole.sides.iter().map(|side| side.side));
    }

    /// The sides of the boundary that were closed, in the mesh's complex.
    pub(super) fn take_closed(&mut self) -> Vec<CornerId> {
        std::mem::take(&mut self.closed)
    }

    /// The mesh and where its elements come from, if any hole is covered.
    pub(super) fn mesh(self) -> Result<Option<(PolygonMesh, Provenance)>, PassError> {
        if self.holes.is_empty() {
            return Ok(None);
        }
        let counts = self.mesh.counts();
        let faces = self.builder.build(counts.vertices + self.created.len())?;
        fn with_created<I: Id>(kept: usize, created: usize) -> Sources<I> {
            Sources::listed((0..kept).map(|at| Some(I::new(at))).chain(std::iter::repeat_n(None, created)))
        }
        let face_sources = with_created(counts.faces, self.faces - counts.faces);
        let corner_sources = with_created(counts.corners, self.corners - counts.corners);
        let draft = Draft {
            vertex_sources: with_created(counts.vertices, self.created.len()),
            created_vertices: self.created,
            filled: self.holes,
            ..Draft::of_faces(self.mesh, faces, face_sources, corner_sources)
        };
        Ok(Some(self.mesh.rebuild(draft)?))
    }
}
