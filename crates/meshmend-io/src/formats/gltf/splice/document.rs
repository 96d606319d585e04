//! The file as it was read, with the meshes that its parts have now.

use std::io;

use crate::document::Document;
use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::fault::Fault;
use crate::formats::gltf::file::File;
use crate::formats::gltf::splice::contents::{Contents, companions};
use crate::formats::gltf::splice::layout::Layout;
use crate::formats::gltf::splice::manifold::{ManifoldEdit, manifold_edit};
use crate::formats::gltf::splice::part_change::{Outcome, PartChange, compared};
use crate::formats::gltf::splice::slots::Slots;
use crate::formats::gltf::splice::text::edits_of;
use crate::formats::gltf::splice::told::{dead_bytes, emptied, told_of};
use crate::formats::gltf::splice::triangulated::triangulated;
use crate::formats::gltf::splice::users::Users;
use crate::shell::{Splice, Spliced};
use crate::{Loss, ManifoldExtension, PartStatus, WriteErrorKind};

/// The file as it was read, with the meshes that its parts have now.
///
/// # Errors
/// If a GLB file would be too large.
///
/// *Cost*: that of reading the file again, and of writing what changed.
pub(in crate::formats::gltf) fn splice(
    file: &File,
    document: &Document,
    splice: &Splice<'_>,
) -> Result<Spliced, WriteErrorKind> {
    let mut losses = Vec::new();
    let asset = file.asset().map_err(again)?;
    let wanted = splice.options.manifold_extension;
    let changes = changes(file, &asset, (document, wanted), &mut losses)?;
    if changes.is_empty() && splice.format == file.format() {
        let bytes = file.bytes.clone();
        return Ok(Spliced { bytes, losses, companions: companions(file, splice.format) });
    }
    let contents = contents(file, &asset, (&changes, wanted), &mut losses).map_err(again)?;
    let bytes = contents.written(file, &asset, splice.format, &mut losses)?;
    Ok(Spliced { bytes, losses, companions: companions(file, splice.format) })
}

/// What is wrong with a file that was read before: nothing, so that this is never seen.
fn again(fault: Fault) -> WriteErrorKind {
    io::Error::new(io::ErrorKind::InvalidData, format!("{}: {}", fault.place, fault.kind)).into()
}

/// The meshes that differ from those of the file.
fn changes(
    file: &File,
    asset: &Asset<'_>,
    (document, wanted): (&Document, ManifoldExtension),
    losses: &mut Vec<Loss>,
) -> Result<Vec<PartChange>, WriteErrorKind> {
    let bytes = file.buffers();
    let mut changes = Vec::new();
    for (index, part) in document.parts.iter().enumerate().take(asset.meshes.len()) {
        if part.status != PartStatus::Editable {
            continue;
        }
        let now = triangulated(&part.mesh, losses)?;
        let compared = compared(asset, index, &bytes, &now, wanted).map_err(again)?;
        losses.extend(compared.losses);
        match compared.outcome {
            Outcome::Unchanged(_) => {}
            Outcome::Changed(change) => changes.push(*change),
            Outcome::Emptied => losses.push(emptied(index, &part.name)),
        }
    }
    Ok(changes)
}

fn contents(
    file: &File,
    asset: &Asset<'_>,
    (changes, wanted): (&[PartChange], ManifoldExtension),
    losses: &mut Vec<Loss>,
) -> Result<Contents, Fault> {
    if changes.is_empty() {
        return Ok(Contents::unchanged());
    }
    let users = Users::of(asset)?;
    let mut slots = Slots::new(asset.accessors.len());
    let mut manifolds: Vec<ManifoldEdit> = Vec::new();
    for change in changes {
        slots.add(change, &users);
        let mesh = asset.mesh(change.mesh)?;
        for primitive in &change.primitives {
            let old = mesh.primitives[primitive.primitive].indices;
            slots.add_indices(change.mesh, primitive, old, &users);
        }
        let manifold = manifold_edit(&mesh, change, &mut slots, &users, wanted)?;
        let says_vertices = manifold.as_ref().is_some_and(|edit| edit.stated.is_some());
        losses.extend(told_of(asset, change, says_vertices)?);
        manifolds.extend(manifold);
    }
    let layout = Layout::of(asset, file, &slots, &users)?;
    losses.extend(dead_bytes(layout.dead));
    let edits = edits_of(asset, changes, &slots, &layout, &manifolds)?;
    Ok(Contents::changed(file, layout, edits))
}
