//! What is to be said of what was written.

use meshmend_core::counted;

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::splice::part_change::{Change, PartChange};
use crate::text::{one_or_many, shown};
use crate::{Loss, LossKind};

/// What is to be said of a mesh that changed.
///
/// # Errors
/// If the mesh is malformed.
pub(super) fn told_of(
    asset: &Asset<'_>,
    change: &PartChange,
    says_vertices: bool,
) -> Result<Vec<Loss>, Fault> {
    let mesh = asset.mesh(change.mesh)?;
    let called = name_of(change.mesh, mesh.name.as_bytes());
    let mut losses = Vec::new();
    for primitive in &change.primitives {
        let at = primitive.primitive;
        match primitive.change {
            Change::Removed => {
                let material =
                    mesh.primitives[at].material.map(|material| asset.material_names().name(material));
                let of = material.map_or(String::new(), |name| format!(", of material `{}`", shown(name)));
                let message = format!("primitive {at} of {called}{of}, has no face left and is left out");
                losses.push(Loss::new(LossKind::EmptiedName, 1, message));
            }
            Change::Indices { becomes_list: true, .. } => {
                let message = format!("primitive {at} of {called} becomes a list of triangles with indices");
                losses.push(Loss::new(LossKind::Converted, 1, message));
            }
            Change::Indices { .. } => {}
        }
    }
    let told = &change.told;
    losses.extend(Loss::if_any(LossKind::SharedVertices, if says_vertices { 0 } else { told.parted }, |count| {
        let vertices = one_or_many(count, "vertex that was split stands", "vertices that were split stand");
        format!("{vertices} at one place with others: a program that joins vertices by place makes them one again")
    }));
    losses.extend(Loss::if_any(LossKind::Precision, told.rounded.positions, |count| {
        let farthest = told.rounded.farthest;
        format!("{} rounded, by {farthest:e} at most", counted_positions(count))
    }));
    losses.extend(Loss::if_any(LossKind::AbsentValue, told.rounded.absent, |count| {
        one_or_many(
            count,
            "value that a vertex does not have is written as zeros or as a unit",
            "values that vertices do not have are written as zeros or as units",
        )
    }));
    losses.extend(Loss::if_any(LossKind::ShortFaces, told.homeless, |count| {
        format!(
            "{}: {called} has no primitive for faces",
            one_or_many(count, "face is left out", "faces are left out")
        )
    }));
    Ok(losses)
}

fn counted_positions(count: usize) -> String {
    one_or_many(count, "created position is", "created positions are")
}

/// That a mesh stays as it was, as nothing of it would be left.
pub(super) fn emptied(mesh: usize, name: &[u8]) -> Loss {
    let called = name_of(mesh, name);
    Loss::new(LossKind::EmptiedName, 1, format!("{called} stays as it was, as no face of it would be left"))
}

/// How many old bytes stay.
pub(super) fn dead_bytes(count: usize) -> Option<Loss> {
    Loss::if_any(LossKind::StaleData, count, |count| {
        let bytes = counted(count, "byte");
        format!("{bytes} of earlier values stay in the file unused, among others that are used")
    })
}

fn name_of(index: usize, name: &[u8]) -> String {
    match name {
        [] => format!("mesh {index}"),
        name => format!("mesh {index} `{}`", shown(name)),
    }
}
