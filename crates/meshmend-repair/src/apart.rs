//! A mesh taken apart along every side that is not matched.
//!
//! The new vertices are the classes of corners that are joined across matched sides ([`parts`]), in the order of the
//! vertices as stored ([`new_vertices`]). So a vertex has exactly one umbrella, and the result is manifold by
//! construction. Edges that would coincide by index are subdivided ([`subdivide`]).
//!
//! `split` makes its result this way, and `orient` takes a mesh apart to see its patches one by one.

use meshmend_core::{Connectivity, CornerId, EdgeId, PolygonMesh, Provenance};
use meshmend_kernels::KernelTask;

use crate::matching::Matching;
use crate::sewing::Sewing;
use crate::stored_vertices::StoredVertices;
use crate::{Context, PassError};

mod draft;
mod new_vertices;
mod parts;
mod subdivide;

pub(crate) use new_vertices::NewVertices;
pub(crate) use parts::{ClassedVertex, VertexParts, corners_that_meet, with_ends};

/// What happens to edges that would join the same two vertices.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Coinciding {
    /// Each gets a vertex of its own in its middle.
    Subdivided,
    /// They become one edge.
    Joined,
}

/// A mesh under way to be taken apart.
pub(crate) struct Apart {
    pub(crate) parts: VertexParts,
    pub(crate) vertices: NewVertices,
    inserted: subdivide::Inserted,
}

/// What is matched, and what else decides where a mesh comes apart.
pub(crate) struct Separation<'a> {
    pub(crate) matching: &'a Matching,
    /// Sides that stay together although they are not matched.
    pub(crate) joined: &'a [(CornerId, CornerId)],
    /// The vertices that may come apart, ascending.
    pub(crate) vertices: Vec<ClassedVertex>,
    pub(crate) coinciding: Coinciding,
}

impl Apart {
    /// Takes a mesh apart along every side that is neither matched nor joined.
    ///
    /// *Cost*: linear, and O(Σ d log d) over the degrees d of the edges and vertices that may come apart.
    pub(crate) fn of<K: Connectivity>(
        kernel: &K,
        mesh: &PolygonMesh,
        context: &Context<'_>,
        separation: Separation<'_>,
    ) -> Result<Self, PassError> {
        let stored = StoredVertices::new(mesh, context);
        let parts = VertexParts::of(kernel, separation.matching, separation.joined, separation.vertices);
        context.check_cancelled()?;
        let vertices = NewVertices::of(kernel, &stored, &parts);
        context.check_cancelled()?;
        let inserted = match separation.coinciding {
            Coinciding::Subdivided => {
                subdivide::subdivide(kernel, mesh, separation.matching, &vertices, context)?
            }
            Coinciding::Joined => subdivide::Inserted::default(),
        };
        Ok(Apart { parts, vertices, inserted })
    }

    /// The edges that were subdivided, ascending.
    pub(crate) fn subdivided_edges(&self) -> &[EdgeId] {
        &self.inserted.edges
    }

    /// Whether the new vertices are the present ones, to the bit.
    pub(crate) fn is_unchanged<K: Connectivity>(&self, kernel: &K, mesh: &PolygonMesh) -> bool {
        let new = &self.vertices;
        let same_bits = |a: &[f64; 3], b: &[f64; 3]| a.map(f64::to_bits) == b.map(f64::to_bits);
        self.inserted.vertices.is_empty()
            && new.present.iter().zip(0..).all(|(present, place)| present.0 == place)
            && new.positions.iter().zip(mesh.positions()).all(|(a, b)| same_bits(a, b))
            && kernel.corners().all(|c| new.of_corner[c] == kernel.corner_vertex(c))
    }

    /// The mesh with its new vertices.
    pub(crate) fn rebuild(
        self,
        mesh: &PolygonMesh,
        context: &Context<'_>,
    ) -> Result<(PolygonMesh, Provenance), PassError> {
        let draft = draft::draft(mesh, self.vertices, self.inserted)?;
        context.check_cancelled()?;
        Ok(mesh.rebuild(draft)?)
    }
}

/// A mesh taken apart along everything that rules 1 and 2 leave unmatched.
///
/// # Errors
/// When the kernel can't hold the mesh.
pub(crate) fn along_rules(
    mesh: &PolygonMesh,
    context: &Context<'_>,
) -> Result<(PolygonMesh, Provenance), PassError> {
    context.kernel.run_on_all_vertices(mesh.complex(), AlongRules { mesh, context })?
}

struct AlongRules<'a> {
    mesh: &'a PolygonMesh,
    context: &'a Context<'a>,
}

impl KernelTask for AlongRules<'_> {
    type Output = Result<(PolygonMesh, Provenance), PassError>;

    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        let AlongRules { mesh, context } = self;
        let stored = StoredVertices::new(mesh, context);
        context.check_cancelled()?;
        let mut sewing = Sewing::of(kernel, mesh, context);
        context.check_cancelled()?;
        let unchanged = || (mesh.clone(), Provenance::same(mesh.counts()));
        if sewing.is_whole(kernel, mesh, &stored) {
            sewing.keep(mesh, context);
            return Ok(unchanged());
        }
        let matching = sewing.take_matching(kernel, &stored);
        context.check_cancelled()?;
        let cut = sewing.parted_copies(kernel);
        let vertices = with_ends(kernel, sewing.irregular.clone(), &cut);
        let separation =
            Separation { matching: &matching, joined: &[], vertices, coinciding: Coinciding::Subdivided };
        let apart = Apart::of(kernel, mesh, context, separation)?;
        sewing.put_back(matching);
        sewing.keep(mesh, context);
        if apart.is_unchanged(kernel, mesh) { Ok(unchanged()) } else { apart.rebuild(mesh, context) }
    }
}
