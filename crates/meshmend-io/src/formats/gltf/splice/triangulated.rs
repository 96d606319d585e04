//! A mesh of triangles alone, as the format holds no other faces.

use meshmend_core::{Draft, DraftError, FaceId, FaceTable, PolygonMesh, Sources, VertexId, counted};

use crate::output::triangles::cut_polygons;
use crate::{Encoding, Format, Loss, LossKind, Prepared, WriteErrorKind, WriteOptions};

/// A mesh with its larger faces cut into triangles, and without smaller ones.
///
/// # Errors
/// If there are more triangles than a table can hold.
pub(super) fn triangulated(
    mesh: &PolygonMesh,
    losses: &mut Vec<Loss>,
) -> Result<PolygonMesh, WriteErrorKind> {
    if mesh.faces().is_all_triangles() {
        return Ok(mesh.clone());
    }
    let options = WriteOptions::default();
    let mut prepared = Prepared::as_given(mesh, Format::Glb, Encoding::LittleEndian, options);
    cut_polygons(&mut prepared)?;
    losses.append(&mut prepared.losses);
    let mesh = prepared.mesh;
    let is_triangle = |face: &FaceId| mesh.faces().corner_range(*face).len() == 3;
    let short = mesh.faces().faces().filter(|face| !is_triangle(face)).count();
    losses.extend(Loss::if_any(LossKind::ShortFaces, short, |count| {
        format!("{} of fewer than three corners", counted(count, "face"))
    }));
    without_short_faces(&mesh).map_err(WriteErrorKind::from)
}

fn without_short_faces(mesh: &PolygonMesh) -> Result<PolygonMesh, DraftError> {
    let faces = mesh.faces();
    let kept: Vec<FaceId> = faces.faces().filter(|&face| faces.corner_range(face).len() == 3).collect();
    let corners = || kept.iter().flat_map(|&face| faces.face_corners(face));
    let vertices: Vec<VertexId> = corners().map(|corner| faces.corner_vertex(corner)).collect();
    let table = FaceTable::triangles(faces.vertex_count(), vertices)?;
    let face_sources = Sources::listed(kept.iter().map(|&face| Some(face)));
    let corner_sources = Sources::listed(corners().map(Some));
    Ok(mesh.rebuild(Draft::of_faces(mesh, table, face_sources, corner_sources))?.0)
}
