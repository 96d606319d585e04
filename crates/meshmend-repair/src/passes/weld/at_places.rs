//! The weld of a soup whose reader has told which vertices share a place.
//!
//! The welded mesh then has those places as its vertices, and its corners are what the reader told. It is the mesh that the
//! general way gives, without a look at the points of all vertices.

use meshmend_core::{Domain, Draft, Id, PolygonMesh, SharedPlaces, Sources, VertexId};
use meshmend_geometry::coincident::Coincidence;
use meshmend_geometry::vector::is_finite;

use crate::fixed::Fixed;
use crate::{Context, Outcome, PassError};

/// The mesh in which vertices in one place are one. `None` where the general way has to tell: no places are known, a vertex is
/// more than one corner or none, some are at positions that equal each other and are not the same to the bit, or are not finite,
/// or a layer is of vertices or corners.
///
/// *Cost*: linear in the places, and one pass over the corners.
pub(super) fn joined_at_places(
    mesh: &PolygonMesh,
    context: &Context<'_>,
) -> Result<Option<Outcome>, PassError> {
    let (Some(places), Some(faces)) = (mesh.shared_places(), mesh.faces_at_places()) else { return Ok(None) };
    let has_loose = !mesh.loose_edges().is_empty() || !mesh.loose_points().is_empty();
    if has_loose || mesh.layers().iter().any(|layer| layer.domain() != Domain::Face) {
        return Ok(None);
    }
    if !are_apart(places, context)? || places.points().len() == mesh.counts().vertices {
        return Ok(None);
    }
    let first = places.first_vertices();
    let counts = mesh.counts();
    let draft = Draft {
        vertex_sources: Sources::listed(first.iter().copied().map(Some)),
        kept_positions: Some(places.shared_points()),
        ..Draft::of_faces(mesh, faces, Sources::same(counts.faces), Sources::same(counts.corners))
    };
    context.check_cancelled()?;
    Ok(Some(Outcome::changed(mesh.rebuild(draft)?, Fixed::sharing(places.clone(), first))))
}

/// Whether all places are finite, and no two are equal.
fn are_apart(places: &SharedPlaces, context: &Context<'_>) -> Result<bool, PassError> {
    if !places.points().iter().all(is_finite) {
        return Ok(false);
    }
    let Coincidence { exactly, .. } = Coincidence::watched(places.points(), || context.check_cancelled())?;
    Ok(exactly.iter().enumerate().all(|(place, low): (usize, &VertexId)| low.index() == place))
}
