//! What all steps of `orient` look at.

use meshmend_core::{Connectivity, PolygonMesh};

use super::repeats::Repeats;
use crate::Context;
use crate::stored_vertices::StoredVertices;

/// A mesh that is being oriented.
pub(super) struct Subject<'a, K> {
    pub(super) kernel: &'a K,
    pub(super) mesh: &'a PolygonMesh,
    pub(super) context: &'a Context<'a>,
    pub(super) stored: StoredVertices<'a>,
    pub(super) repeats: Repeats,
}

impl<'a, K: Connectivity> Subject<'a, K> {
    pub(super) fn new(kernel: &'a K, mesh: &'a PolygonMesh, context: &'a Context<'a>) -> Self {
        let stored = StoredVertices::new(mesh, context);
        let repeats = Repeats::of(kernel, mesh, context);
        Subject { kernel, mesh, context, stored, repeats }
    }
}
