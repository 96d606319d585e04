//! Materials, textures and images as members of the JSON.

use std::collections::BTreeMap;

use super::json::{Image, Material as JsonMaterial, MetallicRoughness, Texture, TextureInfo};
use super::looks::{Kind, pictures};
use crate::input::folder::below;
use crate::{Material, Picture, Prepared};

/// The members of a file that say what faces look like.
pub(super) struct Members {
    pub(super) materials: Vec<JsonMaterial>,
    pub(super) textures: Vec<Texture>,
    pub(super) images: Vec<Image>,
}

/// The members for materials of these names. `first_view` is the number of the first buffer view of a picture.
pub(super) fn members<'a>(
    prepared: &Prepared,
    names: impl Iterator<Item = &'a [u8]>,
    first_view: usize,
) -> Members {
    let described = prepared.materials();
    let pictures = pictures(&described);
    let by_name: BTreeMap<&[u8], &Material> =
        described.iter().rev().map(|material| (&material.name[..], material)).collect();
    let materials = names.map(|name| match by_name.get(name) {
        Some(material) => described_by(material, &pictures),
        None => JsonMaterial { name: super::losses::utf8(name), ..JsonMaterial::default() },
    });
    let mut view = first_view;
    let images = pictures.iter().map(|picture| match picture {
        Picture::File(name) => Image { uri: Some(uri(name)), ..Image::default() },
        Picture::Embedded { name, bytes } => {
            view += 1;
            let mime_type = if Kind::of(bytes) == Kind::Png { "image/png" } else { "image/jpeg" };
            let name = (!name.is_empty()).then(|| name.clone());
            Image { name, buffer_view: Some(view - 1), mime_type: Some(mime_type), uri: None }
        }
    });
    Members {
        materials: materials.collect(),
        images: images.collect(),
        textures: (0..pictures.len()).map(|source| Texture { source }).collect(),
    }
}

fn described_by(material: &Material, pictures: &[&Picture]) -> JsonMaterial {
    let texture = |picture: &Option<Picture>| {
        let index = pictures.iter().position(|other| Some(*other) == picture.as_ref())?;
        Some(TextureInfo { index })
    };
    let opacity = material.opacity.unwrap_or(1.0);
    let has_color = material.base_color.is_some() || opacity < 1.0;
    let [red, green, blue] = material.base_color.unwrap_or([1.0; 3]);
    let emissive_texture = texture(&material.emissive_map);
    // A picture alone gives off its own light.
    let light = material.emissive.or(emissive_texture.is_some().then_some([1.0; 3]));
    JsonMaterial {
        name: super::losses::utf8(&material.name),
        pbr_metallic_roughness: Some(MetallicRoughness {
            base_color_factor: has_color.then_some([red, green, blue, opacity]),
            base_color_texture: texture(&material.base_map),
            // What says nothing of metal is none. In the format it would be.
            metallic_factor: Some(material.metallic.unwrap_or(0.0)),
            roughness_factor: material.roughness,
        }),
        normal_texture: texture(&material.normal_map),
        emissive_texture,
        emissive_factor: light.filter(|light| *light != [0.0; 3]),
        alpha_mode: (opacity < 1.0).then_some("BLEND"),
    }
}

/// A path below the folder of the file as a URI.
fn uri(name: &[u8]) -> String {
    let path = below(name).map_or_else(
        || String::from_utf8_lossy(name).into_owned(),
        |path| path.to_string_lossy().into_owned(),
    );
    let is_plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let spelled = path
        .bytes()
        .map(|byte| if is_plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") });
    spelled.collect()
}
