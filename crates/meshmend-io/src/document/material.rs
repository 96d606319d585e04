//! What a surface looks like, as far as files of several formats say it.
//!
//! Colours are the numbers of the file. glTF means linear ones, while most programs that write MTL mean those of the
//! screen (sRGB). No number is converted, as a file does not say which it means.

use std::fmt;
use std::sync::Arc;

/// What a material looks like. What a file does not say is `None`.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// The name by which faces have it.
    pub name: Vec<u8>,
    /// The colour: red, green and blue, from 0 to 1.
    pub base_color: Option<[f64; 3]>,
    /// From 0, which nobody sees, to 1.
    pub opacity: Option<f64>,
    /// The picture that the colour is multiplied with.
    pub base_map: Option<Picture>,
    /// The light that it gives off.
    pub emissive: Option<[f64; 3]>,
    /// The picture that the light is multiplied with.
    pub emissive_map: Option<Picture>,
    /// From 0 to 1, which is metal.
    pub metallic: Option<f64>,
    /// From 0, which is a mirror, to 1.
    pub roughness: Option<f64>,
    /// The picture of the directions of the surface.
    pub normal_map: Option<Picture>,
    /// What else the file says of it, by the words of its format.
    pub others: Vec<String>,
}

/// A picture that a material names.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum Picture {
    /// A file, by its path below the folder of the mesh file.
    File(Vec<u8>),
    /// Bytes within the mesh file.
    Embedded {
        /// What the file calls it; empty if it has no name.
        name: String,
        /// The bytes of a picture file.
        bytes: Arc<[u8]>,
    },
}

impl fmt::Debug for Picture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Picture::File(name) => write!(f, "File({})", String::from_utf8_lossy(name)),
            Picture::Embedded { name, bytes } => write!(f, "Embedded({name}, {} bytes)", bytes.len()),
        }
    }
}

impl Material {
    /// A material of which nothing but the name is known.
    pub fn named(name: impl Into<Vec<u8>>) -> Self {
        Material { name: name.into(), ..Material::default() }
    }

    /// The pictures that it names.
    pub fn pictures(&self) -> impl Iterator<Item = &Picture> {
        [&self.base_map, &self.emissive_map, &self.normal_map].into_iter().flatten()
    }
}

/// The extension of the name of a picture file with these bytes.
pub(crate) fn extension(bytes: &[u8]) -> &'static str {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => "png",
        [0xff, 0xd8, 0xff, ..] => "jpg",
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => "webp",
        [0xab, b'K', b'T', b'X', ..] => "ktx2",
        _ => "bin",
    }
}
