//! What a new package does not carry.

use meshmend_core::{Layer, PolygonMesh, counted};

use super::model::spelled;
use super::objects::{Materials, Objects};
use crate::output::layer_losses::{layer_losses, loose_losses};
use crate::output::statements::metadata_losses;
use crate::text::one_or_many;
use crate::{Loss, LossKind, Material, Prepared};

pub(in crate::formats::threemf) fn losses(prepared: &Prepared) -> Vec<Loss> {
    let mesh = prepared.mesh();
    let objects = Objects::of(mesh);
    let materials = Materials::of(mesh, &objects);
    let written = [objects.layer, materials.as_ref().map(|materials| materials.layer)];
    let written: Vec<&Layer> = written.into_iter().flatten().collect();
    let mut losses = layer_losses(mesh, &written);
    let names = materials.as_ref().map_or(&[][..], |materials| &materials.names);
    losses.extend(material_loss(names, &prepared.materials()));
    losses.extend(geometry_losses(mesh, &objects));
    losses.extend(loose_losses(mesh));
    losses.extend(metadata_losses(mesh, &[]));
    losses.extend(name_loss(&objects, names));
    losses
}

fn geometry_losses(mesh: &PolygonMesh, objects: &Objects<'_>) -> impl Iterator<Item = Loss> {
    let faces = mesh.faces();
    let short = faces.faces().filter(|&face| faces.corner_range(face).len() < 3).count();
    let mut is_used = vec![false; mesh.counts().vertices];
    let vertices = objects.list.iter().flat_map(|object| &object.vertices);
    vertices.for_each(|vertex| is_used[vertex.0 as usize] = true);
    let used = is_used.iter().filter(|&&is_used| is_used).count();
    let copies = objects.vertex_count() - used;
    // Where vertices are written twice they stand at other numbers anyway.
    let [faces_moved, vertices_moved] = objects.moved();
    let moved = faces_moved + if copies == 0 { vertices_moved } else { 0 };
    [
        Loss::if_any(LossKind::ShortFaces, short, |n| {
            format!("{} of fewer than three corners", counted(n, "face"))
        }),
        Loss::if_any(LossKind::UnusedVertices, is_used.len() - used, |n| {
            format!("{} that no object uses", counted(n, "vertex"))
        }),
        Loss::if_any(LossKind::Converted, moved, |_| {
            "faces and vertices stand in another order: those of an object follow one another".to_owned()
        }),
        Loss::if_any(LossKind::SharedVertices, copies, |n| {
            one_or_many(
                n,
                "vertex that several objects share: each object has a vertex of its own",
                "vertices that several objects share: each object has vertices of its own",
            )
        }),
    ]
    .into_iter()
    .flatten()
}

/// The loss of what materials are beside a name and a colour.
fn material_loss(names: &[&[u8]], known: &[Material]) -> Option<Loss> {
    let plain = |material: &Material| Material {
        name: material.name.clone(),
        base_color: material.base_color,
        opacity: material.opacity,
        ..Material::default()
    };
    let used = known.iter().filter(|material| names.contains(&material.name.as_slice()));
    let richer = used.filter(|material| **material != plain(material)).count();
    Loss::if_any(LossKind::Material, richer, |n| {
        one_or_many(
            n,
            "material is more than a name and a colour, which 3MF shows it in",
            "materials are more than a name and a colour, which 3MF shows them in",
        )
    })
}

/// The loss of names that XML can't spell.
fn name_loss(objects: &Objects<'_>, materials: &[&[u8]]) -> Option<Loss> {
    let names = objects.list.iter().map(|object| object.name).chain(materials.iter().copied());
    let other = names.filter(|name| !spelled(name).is_exact).count();
    Loss::if_any(LossKind::Names, other, |n| {
        one_or_many(n, "name is spelled differently", "names are spelled differently")
    })
}
