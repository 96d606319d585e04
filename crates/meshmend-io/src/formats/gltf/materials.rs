//! What the materials of a file look like, as far as other formats say it too.

use crate::formats::gltf::asset::Asset;
use crate::formats::gltf::buffers::Held;
use crate::formats::gltf::fault::{Fault, Pointer};
use crate::formats::gltf::file::File;
use crate::formats::gltf::json::{Object, Value};
use crate::formats::gltf::uri::{self, Named};
use crate::shell::{NamedContent, NamedFile};
use crate::{Material, Picture};

/// The materials of a file, by the names that faces have. Of one that is malformed only the name is known.
///
/// *Cost*: that of reading the JSON, and of copying the pictures within the file.
pub(super) fn materials(file: &File) -> Result<Vec<Material>, Fault> {
    let asset = file.asset()?;
    let pictures = Pictures {
        file,
        asset: &asset,
        textures: asset.root.items("textures")?,
        images: asset.root.items("images")?,
    };
    let material = |(index, &value): (usize, &Value<'_>)| {
        let name = asset.material_names().name(index).to_vec();
        let material = Object::of(value, Pointer::item("materials", index));
        material
            .and_then(|material| described(&material, &pictures, name.clone()))
            .unwrap_or_else(|_| Material::named(name))
    };
    Ok(asset.materials.iter().enumerate().map(material).collect())
}

/// The files that a file names: its buffers, and its pictures.
pub(super) fn named_files(file: &File) -> Result<Vec<NamedFile>, Fault> {
    let mut files: Vec<NamedFile> = Vec::new();
    let mut add = |name: Vec<u8>, content| {
        if !files.iter().any(|file| file.name == name) {
            files.push(NamedFile { name, content });
        }
    };
    for held in &file.held {
        if let Held::File(name, _) = held {
            add(name.clone(), NamedContent::Buffer);
        }
    }
    let asset = file.asset()?;
    for (index, image) in asset.root.items("images")?.into_iter().enumerate() {
        let uri = Object::of(image, Pointer::item("images", index)).and_then(|image| image.text("uri"));
        if let Ok(Named::File(name)) = uri.ok().flatten().as_deref().map_or(Err(String::new()), uri::named) {
            add(name, NamedContent::Picture);
        }
    }
    Ok(files)
}

/// The members of a material that are understood, and those that say nothing of how it looks.
const KNOWN: [&str; 9] = [
    "name",
    "pbrMetallicRoughness",
    "normalTexture",
    "emissiveTexture",
    "emissiveFactor",
    "alphaMode",
    "alphaCutoff",
    "doubleSided",
    "extensions",
];

fn described(object: &Object<'_>, pictures: &Pictures<'_>, name: Vec<u8>) -> Result<Material, Fault> {
    let mut material = Material::named(name);
    let others = &mut material.others;
    others.extend(
        object.members.iter().map(|member| member.name.clone()).filter(|name| !KNOWN.contains(&&**name)),
    );
    if let Some(extensions) = object.object("extensions")? {
        others.extend(extensions.members.iter().map(|member| member.name.clone()));
    }
    let is_double_sided = object.get("doubleSided").is_some_and(|value| value.raw() == "true");
    others.extend(is_double_sided.then(|| "doubleSided".to_owned()));
    let (mut color, mut metal, mut rough) = ([1.0; 4], 1.0, 1.0);
    if let Some(surface) = object.object("pbrMetallicRoughness")? {
        color = numbers(&surface, "baseColorFactor").unwrap_or(color);
        metal = number(&surface, "metallicFactor").unwrap_or(metal);
        rough = number(&surface, "roughnessFactor").unwrap_or(rough);
        material.base_map = pictures.of(&surface, "baseColorTexture", others)?;
        let is_mixed = surface.get("metallicRoughnessTexture").is_some();
        others.extend(is_mixed.then(|| "metallicRoughnessTexture".to_owned()));
    }
    material.emissive_map = pictures.of(object, "emissiveTexture", others)?;
    material.normal_map = pictures.of(object, "normalTexture", others)?;
    let light = numbers(object, "emissiveFactor").unwrap_or([0.0; 3]);
    match object.text("alphaMode")?.as_deref() {
        Some("BLEND") => material.opacity = Some(color[3]),
        Some("MASK") => others.push("alphaMode MASK".to_owned()),
        _ => {}
    }
    let [red, green, blue, _] = color;
    material.base_color = Some([red, green, blue]);
    (material.metallic, material.roughness) = (Some(metal), Some(rough));
    material.emissive = (light != [0.0; 3]).then_some(light);
    Ok(material)
}

fn number(object: &Object<'_>, name: &str) -> Option<f64> {
    object.get(name)?.as_number()
}

fn numbers<const N: usize>(object: &Object<'_>, name: &str) -> Option<[f64; N]> {
    let items: Option<Vec<f64>> = object.get(name)?.items()?.into_iter().map(Value::as_number).collect();
    items?.try_into().ok()
}

/// The pictures of a file.
struct Pictures<'a> {
    file: &'a File,
    asset: &'a Asset<'a>,
    textures: Vec<Value<'a>>,
    images: Vec<Value<'a>>,
}

/// Where extensions name the picture of a texture, for programs that know its format.
const SOURCES: [&str; 2] = ["EXT_texture_webp", "KHR_texture_basisu"];

impl Pictures<'_> {
    /// The picture of a member. How it is laid on the surface goes to the other words.
    fn of(
        &self,
        object: &Object<'_>,
        member: &str,
        others: &mut Vec<String>,
    ) -> Result<Option<Picture>, Fault> {
        let Some(info) = object.object(member)? else { return Ok(None) };
        let ways = ["texCoord", "scale", "strength", "extensions"];
        let is_used =
            |way: &&str| info.get(way).is_some_and(|value| !matches!(value.raw(), "0" | "1" | "1.0"));
        others.extend(ways.iter().filter(|way| is_used(way)).map(|way| format!("{member} {way}")));
        let Some(texture) = info.index("index", self.textures.len(), "texture")? else { return Ok(None) };
        let texture = Object::of(self.textures[texture], Pointer::item("textures", texture))?;
        others.extend(texture.get("sampler").map(|_| "sampler".to_owned()));
        let mut source = texture.index("source", self.images.len(), "image")?;
        if let (None, Some(extensions)) = (source, texture.object("extensions")?) {
            for name in SOURCES {
                if let Some(extension) = extensions.object(name)? {
                    source = source.or(extension.index("source", self.images.len(), "image")?);
                }
            }
        }
        source.map_or(Ok(None), |image| self.image(image))
    }

    fn image(&self, index: usize) -> Result<Option<Picture>, Fault> {
        let image = Object::of(self.images[index], Pointer::item("images", index))?;
        let name = image.text("name")?.unwrap_or_default();
        if let Some(uri) = image.text("uri")? {
            return Ok(match uri::named(&uri) {
                Ok(Named::File(name)) => Some(Picture::File(name)),
                Ok(Named::Data(data)) => {
                    uri::decoded(data).ok().map(|bytes| Picture::Embedded { name, bytes: bytes.into() })
                }
                Err(_) => None,
            });
        }
        let Some(view) = image.index("bufferView", self.asset.views.len(), "buffer view")? else {
            return Ok(None);
        };
        let view = self.asset.view(view)?;
        let (start, end) = (view.offset as usize, (view.offset + view.length) as usize);
        let bytes = self.file.buffers().buffer(view.buffer).and_then(|bytes| bytes.get(start..end));
        Ok(bytes.map(|bytes| Picture::Embedded { name, bytes: bytes.into() }))
    }
}
