//! What a package does not carry as it was, in words.

use meshmend_core::{Layer, PolygonMesh, counted};

use super::object::Told;
use crate::formats::threemf::parts::Origin;
use crate::output::layer_losses::{layer_losses, loose_losses};
use crate::output::statements::metadata_losses;
use crate::text::{one_or_many, shown};
use crate::{Loss, LossKind, Part};

/// An object as messages name it.
pub(super) fn object(part: &Part, id: u32) -> String {
    if part.name.is_empty() { format!("object {id}") } else { format!("object {id} `{}`", shown(&part.name)) }
}

/// What has to be said of an object that was written with another mesh.
pub(super) fn of_object(part: &Part, origin: &Origin, told: &Told) -> Vec<Loss> {
    let name = object(part, origin.id);
    let Told { needed, stretched, lost_members } = *told;
    let slices = usize::from(origin.has_slices);
    let losses = [
        Loss::if_any(LossKind::CopiedProperty, stretched.copied, |n| {
            let corners = one_or_many(n, "created corner has", "created corners have");
            format!("{name}: {corners} the property of the nearest corner of the triangle that was cut")
        }),
        Loss::if_any(LossKind::StaleData, stretched.cut, |n| {
            let triangles = one_or_many(n, "triangle that was cut keeps", "triangles that were cut keep");
            format!("{name}: {triangles} what was said of the whole triangle")
        }),
        Loss::if_any(LossKind::StaleData, lost_members, |n| {
            let members =
                one_or_many(n, "member of a set of triangles is", "members of sets of triangles are");
            format!("{name}: {members} gone with the triangles")
        }),
        Loss::if_any(LossKind::StaleData, slices, |_| {
            format!("{name}: the slices were made of its mesh as it was before")
        }),
        Loss::if_any(LossKind::TextLayout, needed, |n| {
            let vertices = counted(n, "vertex");
            let stay = if n == 1 { "stays" } else { "stay" };
            format!(
                "{name}: {vertices} that no triangle uses {stay} in the file, as beams need {}",
                if n == 1 { "it" } else { "them" }
            )
        }),
    ];
    losses.into_iter().flatten().collect()
}

/// What a mesh has that no object of a model can have, and that was not read from it.
pub(super) fn not_of_the_file(mesh: &PolygonMesh, before: &PolygonMesh) -> Vec<Loss> {
    let is_read = |layer: &&Layer| {
        let key = |layer: &Layer| (layer.name().to_owned(), layer.home());
        before.layers().iter().any(|old| key(old) == key(layer))
    };
    let read: Vec<&Layer> = mesh.layers().iter().filter(is_read).collect();
    let short = mesh.faces().faces().filter(|&face| mesh.faces().corner_range(face).len() < 3).count();
    let short = Loss::if_any(LossKind::ShortFaces, short, |n| {
        format!("{} of fewer than three corners", counted(n, "face"))
    });
    let mut losses: Vec<Loss> = short.into_iter().collect();
    losses.extend(layer_losses(mesh, &read));
    losses.extend(loose_losses(mesh));
    losses.extend(metadata_losses(mesh, &[]));
    losses
}

/// An object that is given back as it was.
pub(super) fn kept(part: &Part, origin: &Origin, reason: &str) -> Loss {
    Loss::new(LossKind::ScenePart, 1, format!("{} is as it was: {reason}", object(part, origin.id)))
}

/// A model whose text has another encoding now.
pub(super) fn encoding(entry: &str) -> Loss {
    let message = format!("`{}` is written in UTF-8; it was in UTF-16", shown(entry.as_bytes()));
    Loss::new(LossKind::TextLayout, 1, message)
}
