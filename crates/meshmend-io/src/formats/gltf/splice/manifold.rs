//! Which corners are at one vertex, where the file says so.

use crate::ManifoldExtension;
use crate::formats::gltf::accessor::Component;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::primitives::{MANIFOLD, Mesh};
use crate::formats::gltf::splice::closed_manifold::is_closed_manifold;
use crate::formats::gltf::splice::part_change::PartChange;
use crate::formats::gltf::splice::slots::Slots;
use crate::formats::gltf::splice::users::{User, Users};

/// What becomes of the extension of a mesh.
pub(super) struct ManifoldEdit {
    pub(super) mesh: usize,
    /// Whether the mesh did not have it.
    pub(super) is_new: bool,
    /// The accessor of the indices, and that of the positions; `None`: the extension is taken off, as the mesh is no
    /// closed manifold of one pool any more.
    pub(super) stated: Option<(usize, Option<usize>)>,
}

/// What becomes of the extension of a mesh that changed, if it has it or is to have it.
///
/// # Errors
/// If the extension is malformed.
pub(super) fn manifold_edit(
    mesh: &Mesh<'_>,
    change: &PartChange,
    slots: &mut Slots,
    users: &Users,
    wanted: ManifoldExtension,
) -> Result<Option<ManifoldEdit>, Fault> {
    let extensions = mesh.object.object("extensions")?;
    let Some(manifold) = extensions.map(|extensions| extensions.object(MANIFOLD)).transpose()?.flatten()
    else {
        return Ok(if wanted == ManifoldExtension::Add { added(mesh, change, slots, users) } else { None });
    };
    let gone = Some(ManifoldEdit { mesh: change.mesh, is_new: false, stated: None });
    let Some(primitive) = manifold.object("manifoldPrimitive")? else { return Ok(gone) };
    let Some(vertices) = change.vertices.as_ref().filter(|vertices| is_closed_manifold(vertices)) else {
        return Ok(gone);
    };
    let attributes = primitive.object("attributes")?;
    let positions = attributes.and_then(|attributes| attributes.get("POSITION")?.as_count());
    let own = mesh.primitives.iter().flat_map(|primitive| &primitive.attributes);
    let own =
        own.filter(|(semantic, _)| semantic.is_position()).all(|&(_, own)| Some(own as u64) == positions);
    if !own {
        return Ok(gone);
    }
    let positions = slots.renamed_positions(change.mesh);
    let indices = add_indices(vertices, mesh.manifold_indices, change.mesh, slots, users);
    Ok(Some(ManifoldEdit { mesh: change.mesh, is_new: false, stated: Some((indices, positions)) }))
}

/// The extension for a mesh that does not have it, if it is a closed manifold of one pool.
fn added(mesh: &Mesh<'_>, change: &PartChange, slots: &mut Slots, users: &Users) -> Option<ManifoldEdit> {
    let vertices = change.vertices.as_ref().filter(|vertices| is_closed_manifold(vertices))?;
    let mut own = mesh.primitives.iter().flat_map(|primitive| &primitive.attributes);
    let own = own.find(|(semantic, _)| semantic.is_position()).map(|&(_, own)| own);
    let positions = slots.renamed_positions(change.mesh).or(own)?;
    let indices = add_indices(vertices, None, change.mesh, slots, users);
    Some(ManifoldEdit { mesh: change.mesh, is_new: true, stated: Some((indices, Some(positions))) })
}

fn add_indices(vertices: &[u32], old: Option<usize>, mesh: usize, slots: &mut Slots, users: &Users) -> usize {
    let highest = vertices.iter().max().copied().unwrap_or_default();
    let component = if highest < u32::from(u16::MAX) { Component::U16 } else { Component::U32 };
    slots.add_numbers(vertices, component, old, User::Manifold(mesh), users)
}
