//! What is sewn to what in a mesh: that is where `split` begins, and `orient` when it looks for one-sided patches.

use meshmend_core::{
    Connectivity, EdgeId, PolygonMesh, VertexClass, VertexId, irregular_vertices, is_inconsistent,
};

use crate::Context;
use crate::copies::Copies;
use crate::matching::{Matching, may_match};
use crate::stored_vertices::StoredVertices;
use crate::telling::Telling;

mod kept;
mod regular_fast_path;

pub(crate) use kept::KeptSewing;

/// The irregular vertices of a mesh, its copied faces, and the matching of its sides by rules 1 and 2.
///
/// It depends on the mesh and its history alone, so it can be kept as long as these stay as they are.
#[derive(Clone, Debug)]
pub(crate) struct Sewing {
    /// The vertices that are neither disc nor half-disc, ascending.
    pub(crate) irregular: Vec<(VertexId, VertexClass)>,
    /// The faces that repeat others and differ from them.
    pub(crate) copies: Option<Copies>,
    /// Made when it is first needed.
    matching: Option<Matching>,
}

impl Sewing {
    /// What is sewn to what in a mesh: as an earlier pass found it out, or afresh. The matching need not be made yet.
    ///
    /// *Cost*: that of [`irregular_vertices`], unless the report says that there are none; and that of
    /// [`Copies::find`] where some layer tells faces apart.
    pub(crate) fn of<K: Connectivity>(kernel: &K, mesh: &PolygonMesh, context: &Context<'_>) -> Self {
        if let Some(sewing) = context.sewing.and_then(|kept| kept.take(mesh)) {
            return sewing;
        }
        let is_manifold = context.known.is_some_and(|report| report.manifold);
        let irregular = if is_manifold { Vec::new() } else { irregular_vertices(kernel) };
        // Where every vertex is regular, copies of a face clash along the edges that they share.
        let may_have_copies = || !irregular.is_empty() || has_clash(kernel);
        let copies = Telling::of(mesh, context.telling)
            .filter(|_| may_have_copies())
            .and_then(|_| Copies::find(kernel, mesh, context));
        Sewing { irregular, copies, matching: None }
    }

    /// Whether every vertex stays whole and in its place when the mesh is taken apart along what is not matched.
    ///
    /// A `true` costs one look at each corner; a `false` does not say that something comes apart.
    pub(crate) fn is_whole<K: Connectivity>(
        &self,
        kernel: &K,
        mesh: &PolygonMesh,
        stored: &StoredVertices<'_>,
    ) -> bool {
        self.irregular.is_empty()
            && self.copies.is_none()
            && regular_fast_path::keeps_vertices(kernel, mesh, stored)
    }

    /// The matching by rules 1 and 2, which is made now unless it was made before.
    ///
    /// *Cost*: that of [`Matching::by_rules`].
    pub(crate) fn take_matching<K: Connectivity>(
        &mut self,
        kernel: &K,
        stored: &StoredVertices<'_>,
    ) -> Matching {
        let copies = self.copies.as_ref();
        self.matching.take().unwrap_or_else(|| Matching::by_rules(kernel, stored, copies))
    }

    /// Gives a matching back, as it was taken.
    pub(crate) fn put_back(&mut self, matching: Matching) {
        self.matching = Some(matching);
    }

    /// Keeps it for the next pass, if there is a place for it.
    pub(crate) fn keep(self, mesh: &PolygonMesh, context: &Context<'_>) {
        if let Some(kept) = context.sewing {
            kept.keep(mesh, self);
        }
    }

    /// The edges that only two copies of a face have, which differ and so come apart.
    pub(crate) fn parted_copies<K: Connectivity>(&self, kernel: &K) -> Vec<EdgeId> {
        let Some(copies) = &self.copies else { return Vec::new() };
        let is_parted = |&edge: &EdgeId| {
            let mut corners = kernel.edge_corners(edge);
            match (corners.next(), corners.next(), corners.next()) {
                (Some(one), Some(other), None) => !may_match(kernel, Some(copies), one, other),
                _ => false,
            }
        };
        kernel.edges().filter(is_parted).collect()
    }
}

/// Whether the two sides along some edge run the same way.
pub(crate) fn has_clash<K: Connectivity>(kernel: &K) -> bool {
    kernel.edges().any(|edge| is_inconsistent(kernel, edge))
}
