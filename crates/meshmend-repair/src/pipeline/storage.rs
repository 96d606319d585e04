//! How a result is stored, and so what it will be when it is read again.

use std::fmt;
use std::sync::Arc;

use meshmend_core::{
    CornerId, Draft, DraftError, FaceId, FaceTableBuilder, Id, Loose, PolygonMesh, Provenance, Sources,
    VertexId,
};
use rayon::prelude::*;

use crate::{Context, Pass, PassError, Triangulate, TriangulateFaces};

/// How the faces of a result are stored: by the vertices that they share, unless a constructor says otherwise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceStorage {
    corners: Corners,
    writing: Option<Writing>,
}

/// What tells that two corners are at one vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Corners {
    /// The vertex that they name.
    #[default]
    Named,
    /// Their places alone.
    Placed,
}

/// What a writer makes of a mesh before it stores it: that mesh and where its elements were, or `None` if it stores
/// the mesh as it is.
#[derive(Clone)]
pub struct Writing(Arc<Make>);

type Make = dyn Fn(&PolygonMesh) -> Result<Option<(PolygonMesh, Provenance)>, DraftError> + Send + Sync;

impl Writing {
    /// What this function makes of a mesh. It must keep the positions of vertices to the bit.
    pub fn by(
        make: impl Fn(&PolygonMesh) -> Result<Option<(PolygonMesh, Provenance)>, DraftError>
        + Send
        + Sync
        + 'static,
    ) -> Self {
        Writing(Arc::new(make))
    }
}

impl fmt::Debug for Writing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Writing")
    }
}

impl PartialEq for Writing {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl FaceStorage {
    /// As triangles, each with points of its own, as in STL.
    pub fn apart() -> Self {
        FaceStorage { corners: Corners::Placed, writing: None }
    }

    /// The same, of what a writer makes of the result first: it may store vertices once for each value of their
    /// attributes, or cut faces in its own way.
    pub fn written_by(self, writing: Writing) -> Self {
        FaceStorage { writing: Some(writing), ..self }
    }

    /// Whether each corner is stored with a point of its own.
    pub(crate) fn is_apart(&self) -> bool {
        self.corners == Corners::Placed
    }

    /// Whether vertices of a mesh are stored more than once, so that only their places tell that they are one.
    pub(crate) fn takes_apart(&self, mesh: &PolygonMesh) -> Result<bool, PassError> {
        Ok(self.is_apart() || self.made_of(mesh)?.is_some())
    }

    fn made_of(&self, mesh: &PolygonMesh) -> Result<Option<(PolygonMesh, Provenance)>, PassError> {
        match &self.writing {
            Some(writing) => Ok((writing.0)(mesh)?),
            None if self.is_apart() && !mesh.faces().is_all_triangles() => {
                let cut = Triangulate { faces: TriangulateFaces::All }.apply(mesh, &Context::default())?;
                Ok(Some((cut.mesh, cut.provenance)))
            }
            None => Ok(None),
        }
    }

    /// A mesh as it is read again when it was stored this way.
    pub(crate) fn read_again(&self, mesh: &PolygonMesh) -> Result<(PolygonMesh, Provenance), PassError> {
        let made = self.made_of(mesh)?;
        let (made, record) = made.unwrap_or_else(|| (mesh.with_own_cache(), Provenance::same(mesh.counts())));
        if !self.is_apart() {
            return Ok((made, record));
        }
        let (apart, parting) = made.rebuild(apart(&made)?)?;
        let whole = record.then(&parting, mesh.faces(), apart.faces());
        Ok((apart, whole))
    }

    /// Whether a mesh that was read is what will be read when the other one was stored this way.
    pub(crate) fn is_read_again(&self, read: &PolygonMesh, mesh: &PolygonMesh) -> Result<bool, PassError> {
        let made = self.made_of(mesh)?;
        let written = made.as_ref().map_or(mesh, |(made, _)| made);
        if !self.is_apart() {
            return Ok(are_the_same(read, written));
        }
        let corners = triangle_corners(written);
        Ok(is_apart(read)
            && read.counts().corners == corners.len()
            && are_in_place(corners.len(), |at| {
                [point(read, CornerId::new(at)), point(written, corners[at])]
            }))
    }

    /// Whether what was read and what is written have the same faces with the same points, apart from the format.
    pub(crate) fn are_alike(&self, read: &PolygonMesh, mesh: &PolygonMesh) -> Result<bool, PassError> {
        if !self.is_apart() {
            return self.is_read_again(read, mesh);
        }
        let corners = read.counts().corners;
        let same_range = |face| read.faces().corner_range(face) == mesh.faces().corner_range(face);
        Ok(corners == mesh.counts().corners
            && read.counts().faces == mesh.counts().faces
            && read.faces().faces().all(same_range)
            && are_in_place(corners, |at| [read, mesh].map(|mesh| point(mesh, CornerId::new(at)))))
    }
}

/// Whether two meshes have the same vertices, faces and loose elements.
fn are_the_same(one: &PolygonMesh, other: &PolygonMesh) -> bool {
    one.counts() == other.counts()
        && one.faces() == other.faces()
        && are_in_place(one.counts().vertices, |v| [one, other].map(|mesh| mesh.positions()[v]))
        && one.loose_edges() == other.loose_edges()
        && one.loose_points() == other.loose_points()
}

/// Whether all faces are triangles and each corner has a vertex of its own, in order.
fn is_apart(mesh: &PolygonMesh) -> bool {
    let names = mesh.faces().corner_vertices();
    let is_own = |(at, vertex): (usize, &VertexId)| vertex.index() == at;
    mesh.faces().is_all_triangles()
        && names.len() == mesh.counts().vertices
        && names.iter().enumerate().all(is_own)
}

/// The corners of the triangles of a mesh.
fn triangle_corners(mesh: &PolygonMesh) -> Vec<CornerId> {
    triangles(mesh).flat_map(|face| mesh.faces().face_corners(face)).collect()
}

/// The faces of three corners: no others are stored.
fn triangles(mesh: &PolygonMesh) -> impl Iterator<Item = FaceId> {
    mesh.faces().faces().filter(|&face| mesh.faces().corner_range(face).len() == 3)
}

fn point(mesh: &PolygonMesh, corner: CornerId) -> [f64; 3] {
    mesh.position(mesh.faces().corner_vertex(corner))
}

/// Whether all pairs of points are equal to the bit.
fn are_in_place(count: usize, pair: impl Fn(usize) -> [[f64; 3]; 2] + Sync) -> bool {
    (0..count).into_par_iter().all(|at| {
        let [one, other] = pair(at).map(|point| point.map(f64::to_bits));
        one == other
    })
}

/// The triangles of a mesh, each corner at a vertex of its own.
fn apart(mesh: &PolygonMesh) -> Result<Draft, PassError> {
    let corners = triangle_corners(mesh);
    let mut faces = FaceTableBuilder::default();
    for corner in 0..corners.len() {
        faces.push_corner(VertexId::new(corner));
        if corner % 3 == 2 {
            faces.end_face();
        }
    }
    let vertices = corners.iter().map(|&corner| Some(mesh.faces().corner_vertex(corner)));
    let vertex_sources = Sources::listed(vertices);
    let face_sources = Sources::listed(triangles(mesh).map(Some));
    let corner_sources = Sources::listed(corners.iter().copied().map(Some));
    Ok(Draft {
        vertex_sources,
        drop_loose: Loose { edges: true, points: true },
        ..Draft::of_faces(mesh, faces.build(corners.len())?, face_sources, corner_sources)
    })
}
