//! The mesh without the faces that go, and with others flipped. A flipped face keeps its first corner first and reverses
//! the rest.

use meshmend_core::{
    CornerId, Draft, FaceId, FaceTableBuilder, FlippedNormals, Id, PolygonMesh, Provenance, Sources,
};

use crate::PassError;
use crate::fates::Fates;

/// The mesh that its faces' fates make of it.
pub(crate) fn turned(
    mesh: &PolygonMesh,
    fates: &Fates,
    flipped_normals: FlippedNormals,
) -> Result<(PolygonMesh, Provenance), PassError> {
    let draft = if fates.all_stay() { in_place(mesh, fates)? } else { without_some(mesh, fates)? };
    Ok(mesh.rebuild(Draft { flipped_normals, ..draft })?)
}

/// The draft where all faces stay.
fn in_place(mesh: &PolygonMesh, fates: &Fates) -> Result<Draft, PassError> {
    let old = mesh.faces();
    let flips = |&face: &FaceId| fates.is_flipped(face) && old.corner_range(face).len() > 1;
    let flipped: Vec<FaceId> = old.faces().filter(flips).collect();
    let mut corners = old.corner_vertices().to_vec();
    let mut sources: Vec<CornerId> = old.corners().collect();
    for &face in &flipped {
        let range = old.corner_range(face);
        corners[range.start + 1..range.end].reverse();
        sources[range.start + 1..range.end].reverse();
    }
    let faces = old.over(old.vertex_count(), corners)?;
    let faces_from = Sources::same(old.face_count());
    Ok(Draft { flipped, ..Draft::of_faces(mesh, faces, faces_from, sources.into()) })
}

/// The draft where some faces go.
fn without_some(mesh: &PolygonMesh, fates: &Fates) -> Result<Draft, PassError> {
    let old = mesh.faces();
    let mut builder = FaceTableBuilder::default();
    let (mut face_sources, mut flipped) = (Vec::new(), Vec::new());
    let mut corner_sources = Vec::with_capacity(old.corner_count());
    for face in fates.staying() {
        let range = old.corner_range(face);
        let flips = fates.is_flipped(face) && range.len() > 1;
        if flips {
            flipped.push(FaceId::new(face_sources.len()));
        }
        for place in range.clone() {
            let is_first = place == range.start;
            let corner = if flips && !is_first { range.start + range.end - place } else { place };
            let corner = CornerId::new(corner);
            builder.push_corner(old.corner_vertex(corner));
            corner_sources.push(Some(corner));
        }
        builder.end_face();
        face_sources.push(Some(face));
    }
    let faces = builder.build(old.vertex_count())?;
    let (faces_from, corners_from) = (Sources::listed(face_sources), Sources::listed(corner_sources));
    Ok(Draft { flipped, ..Draft::of_faces(mesh, faces, faces_from, corners_from) })
}
