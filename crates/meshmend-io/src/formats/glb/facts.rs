//! What is known of GLB, and how its content is told.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};

pub(crate) const FACTS: Facts = Facts {
    name: "GLB",
    extensions: &["glb"],
    encodings: &[Encoding::LittleEndian],
    variant: |_| "glb",
    holds_polygons: false,
    has_indices: false,
    texture_origin: TextureOrigin::UpperLeft,
    sniff: |bytes, _| bytes.starts_with(b"glTF"),
};
