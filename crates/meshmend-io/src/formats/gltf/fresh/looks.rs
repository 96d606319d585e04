//! What materials look like: which of it the format can hold.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::Read;
use std::sync::Arc;

use meshmend_core::counted;

use super::objects::FaceNames;
use crate::input::folder::{Folder, Lead};
use crate::output::material_losses::other_words_loss;
use crate::shell::NamedContent;
use crate::{Loss, LossKind, Material, Picture, Prepared, text};

/// Leaves of the materials what the file will hold: those that faces use, with pictures that the format knows, and
/// factors from 0 to 1. What is left out is named.
pub(super) fn take(prepared: &mut Prepared) {
    let described = prepared.materials();
    let names = FaceNames::of(&prepared.mesh).used_materials(prepared.mesh.counts().faces);
    let used: BTreeSet<&[u8]> = names.iter().copied().collect();
    let is_used = |name: &[u8]| used.contains(name);
    let mut taken: Vec<Material> = Vec::new();
    let mut known: BTreeSet<&[u8]> = BTreeSet::new();
    for material in described.iter().filter(|material| is_used(&material.name)) {
        // The first description of a name counts.
        if known.insert(&material.name) {
            taken.push(material.clone());
        }
    }
    let unused = described.iter().filter(|material| !is_used(&material.name)).count();
    let unknown = names.iter().filter(|name| !known.contains(**name)).count();
    let mut losses: Vec<Loss> = [
        Loss::if_any(LossKind::Material, unused, |n| {
            format!("{} that no face uses", counted(n, "described material"))
        }),
        Loss::if_any(LossKind::Material, unknown, |n| {
            let (look, them) = if n == 1 { ("looks", "it") } else { ("look", "them") };
            format!("what {} {look} like: no file describes {them}", counted(n, "material"))
        }),
    ]
    .into_iter()
    .flatten()
    .collect();
    losses.extend(without_pictures(&mut taken, prepared));
    losses.extend(clamped(&mut taken));
    losses.extend(other_words_loss(&taken, "glTF"));
    let libraries = prepared.options.shell.companions().into_iter();
    let libraries = libraries.filter(|file| file.content == NamedContent::Materials).map(|file| file.name);
    prepared.held.extend(libraries);
    let pictures = taken.iter().flat_map(Material::pictures).filter_map(file_name);
    prepared.named.extend(pictures);
    prepared.losses.extend(losses);
    prepared.options.materials = Some(taken.into());
}

fn file_name(picture: &Picture) -> Option<Vec<u8>> {
    match picture {
        Picture::File(name) => Some(name.clone()),
        Picture::Embedded { .. } => None,
    }
}

/// Takes pictures away that are neither PNG nor JPEG.
fn without_pictures(materials: &mut [Material], prepared: &Prepared) -> Vec<Loss> {
    let folder = prepared.options.shell.folder().map(Folder::at);
    let mut losses = Vec::new();
    for material in materials {
        for slot in [&mut material.base_map, &mut material.emissive_map, &mut material.normal_map] {
            let is_known =
                slot.as_ref().is_none_or(|picture| kind_in(picture, folder.as_ref()) != Kind::Other);
            if let Some(picture) = slot.take_if(|_| !is_known) {
                let name = match &picture {
                    Picture::File(name) => text::shown(name),
                    Picture::Embedded { name, .. } => text::shown(name.as_bytes()),
                };
                let message = format!("the picture `{name}`, which is neither PNG nor JPEG");
                losses.push(Loss::new(LossKind::Material, 1, message));
            }
        }
    }
    losses.dedup();
    losses
}

/// What a picture is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Png,
    Jpeg,
    Other,
    /// Its bytes can't be looked at.
    Unseen,
}

impl Kind {
    pub(super) fn of(bytes: &[u8]) -> Self {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => Kind::Png,
            [0xff, 0xd8, 0xff, ..] => Kind::Jpeg,
            _ => Kind::Other,
        }
    }
}

fn kind_in(picture: &Picture, folder: Option<&Folder>) -> Kind {
    let name = match picture {
        Picture::Embedded { bytes, .. } => return Kind::of(bytes),
        Picture::File(name) => name,
    };
    let Some(Lead::There(path)) = folder.map(|folder| folder.find(name)) else { return Kind::Unseen };
    let mut start = Vec::new();
    let read = File::open(path).and_then(|file| file.take(4).read_to_end(&mut start));
    if read.is_ok() { Kind::of(&start) } else { Kind::Unseen }
}

/// Brings factors into the range from 0 to 1.
fn clamped(materials: &mut [Material]) -> Option<Loss> {
    let mut moved = 0;
    let mut clamp = |x: &mut f64| {
        let inside = x.clamp(0.0, 1.0);
        moved += usize::from(inside != *x);
        *x = inside;
    };
    for material in materials {
        let colors = [&mut material.base_color, &mut material.emissive].into_iter().flatten().flatten();
        colors.for_each(&mut clamp);
        let factors = [&mut material.opacity, &mut material.metallic, &mut material.roughness];
        factors.into_iter().flatten().for_each(&mut clamp);
    }
    Loss::if_any(LossKind::Converted, moved, |n| {
        format!("{} of materials beyond 0 to 1: written as the nearest one within", counted(n, "factor"))
    })
}

/// The different pictures of some materials, in their order.
pub(super) fn pictures(materials: &Arc<[Material]>) -> Vec<&Picture> {
    let mut pictures: Vec<&Picture> = Vec::new();
    for picture in materials.iter().flat_map(Material::pictures) {
        if !pictures.contains(&picture) {
            pictures.push(picture);
        }
    }
    pictures
}
