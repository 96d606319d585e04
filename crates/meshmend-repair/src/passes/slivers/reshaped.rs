//! The mesh that comes of mended slivers.

use meshmend_core::{
    Blend, CornerId, Draft, FaceId, FaceTableBuilder, Id, PolygonMesh, Provenance, Sources, VertexId,
};
use meshmend_spatial::{Reshaped, SliverMend, SliverStep};

use crate::PassError;
use crate::fates::{Fates, NewIds};

/// For each vertex the one that it went into in the end, or itself.
pub(super) fn destinations(mesh: &PolygonMesh, steps: &[SliverStep]) -> Vec<VertexId> {
    let mut went: Vec<VertexId> = (0..mesh.counts().vertices).map(VertexId::new).collect();
    // What a vertex went into is known before the vertex is looked at.
    for step in steps.iter().rev() {
        if let SliverMend::Collapse { from, into } = step.mend {
            went[from.index()] = went[into.index()];
        }
    }
    went
}

/// The ids that faces have afterwards.
pub(super) fn new_ids(reshaped: &Reshaped) -> NewIds {
    let mut fates = Fates::unchanged(reshaped.is_gone.len());
    let gone = reshaped.is_gone.iter().enumerate().filter(|(_, is_gone)| **is_gone);
    gone.for_each(|(face, _)| fates.remove(FaceId::new(face)));
    fates.new_ids()
}

/// The mesh whose faces are these, and where its elements come from. A corner that came to another vertex is created, with
/// the attributes of a corner that was there.
pub(super) fn rebuilt(
    mesh: &PolygonMesh,
    reshaped: &Reshaped,
    went: Vec<VertexId>,
) -> Result<(PolygonMesh, Provenance), PassError> {
    let old = mesh.faces();
    let mut sources = Vec::with_capacity(went.len());
    let mut new_vertex = vec![VertexId(0); went.len()];
    for (vertex, &into) in went.iter().enumerate() {
        if into.index() == vertex {
            new_vertex[vertex] = VertexId::new(sources.len());
            sources.push(Some(into));
        }
    }
    let merged: Vec<VertexId> = went.iter().map(|into| new_vertex[into.index()]).collect();
    let mut builder = FaceTableBuilder::default();
    let (mut face_sources, mut corner_sources, mut created) = (Vec::new(), Vec::new(), Vec::new());
    for face in old.faces().filter(|face| !reshaped.is_gone[face.index()]) {
        for corner in old.face_corners(face) {
            let (vertex, origin) = (reshaped.vertices[corner.index()], reshaped.origins[corner.index()]);
            let stays = vertex == old.corner_vertex(corner) && origin == corner;
            if !stays {
                created.push((CornerId::new(corner_sources.len()), at(origin)));
            }
            builder.push_corner(merged[vertex.index()]);
            corner_sources.push(stays.then_some(corner));
        }
        builder.end_face();
        face_sources.push(Some(face));
    }
    let faces = builder.build(sources.len())?;
    let draft = Draft {
        vertex_sources: Sources::listed(sources),
        merged_into: Some(merged),
        created_corners: created,
        ..Draft::of_faces(mesh, faces, Sources::listed(face_sources), Sources::listed(corner_sources))
    };
    Ok(mesh.rebuild(draft)?)
}

/// The place of a corner.
fn at(corner: CornerId) -> Blend {
    Blend::Along { from: corner, to: corner, numerator: 0, denominator: 1 }
}
