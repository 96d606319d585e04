//! How a pass describes the mesh that it wants.
//!
//! A pass fills a [`Draft`]: the new faces, and where each new face, corner and vertex came from. From that
//! [`PolygonMesh::rebuild`] makes the mesh, carries all attributes and loose elements along, and returns the
//! [`Provenance`], so that no pass has attribute code and no record can differ from what was done.

use std::sync::Arc;

use thiserror::Error;

use crate::{
    Blend, CornerId, FaceId, FaceTable, FaceTableError, FilledHole, FlippedNormals, MeshError, PolygonMesh,
    Sources, VertexId, counted,
};

/// A vertex that a pass creates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexDraft {
    /// Its point.
    pub position: [f64; 3],
    /// Where that is in terms of the old mesh. None where nothing of the old mesh is near: it then has no attributes.
    pub place: Option<Blend>,
}

/// The mesh that a pass wants, in terms of the one that it was given.
#[derive(Clone, Debug)]
pub struct Draft {
    /// The new faces over the new vertices.
    pub faces: FaceTable,
    /// For each new face the old one that it is or is a part of.
    pub face_sources: Sources<FaceId>,
    /// For each new corner the old one that it is.
    pub corner_sources: Sources<CornerId>,
    /// The new faces that run the other way round than their sources, ascending.
    pub flipped: Vec<FaceId>,
    /// For each new vertex the old one whose place and attributes it has. The created ones come last.
    pub vertex_sources: Sources<VertexId>,
    /// Where the kept vertices are, if not all of them are where their sources are.
    pub kept_positions: Option<Arc<Vec<[f64; 3]>>>,
    /// The created vertices, in order.
    pub created_vertices: Vec<VertexDraft>,
    /// The created corners with the old corners that they lie between, ascending.
    pub created_corners: Vec<(CornerId, Blend)>,
    /// The holes that new faces fill.
    pub filled: Vec<FilledHole>,
    /// For each old vertex the new one that loose elements use instead, where that is not the first new vertex
    /// whose source it is.
    pub merged_into: Option<Vec<VertexId>>,
    /// Whether loose edges and points are left out.
    pub drop_loose: Loose,
    /// Whether stored normals turn with the faces that are flipped.
    pub flipped_normals: FlippedNormals,
}

/// Which loose elements a pass leaves out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Loose {
    /// Leave out the loose edges.
    pub edges: bool,
    /// Leave out the loose points.
    pub points: bool,
}

/// Why a draft makes no mesh: a mistake of the pass, never of the input.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum DraftError {
    /// A list does not have one entry for each element.
    #[error("a draft has {}, but needs {expected}", counted(found, what))]
    Count {
        /// What it lists, in the singular.
        what: &'static str,
        /// How many entries it has.
        found: usize,
        /// How many it needs.
        expected: usize,
    },
    /// A loose element's vertex is no longer there.
    #[error("a draft drops {0}, which a loose element uses")]
    LooseVertex(VertexId),
    /// The parts don't fit together.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// There would be more elements than a mesh holds.
    #[error(transparent)]
    Table(#[from] FaceTableError),
}

impl Draft {
    /// A draft that keeps every vertex: the usual start, with new faces over the old vertices.
    pub fn of_faces(
        mesh: &PolygonMesh,
        faces: FaceTable,
        face_sources: Sources<FaceId>,
        corner_sources: Sources<CornerId>,
    ) -> Self {
        Draft {
            faces,
            face_sources,
            corner_sources,
            flipped: Vec::new(),
            vertex_sources: Sources::same(mesh.counts().vertices),
            kept_positions: None,
            created_vertices: Vec::new(),
            created_corners: Vec::new(),
            filled: Vec::new(),
            merged_into: None,
            drop_loose: Loose::default(),
            flipped_normals: FlippedNormals::default(),
        }
    }
}
