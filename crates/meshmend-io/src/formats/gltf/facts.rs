//! What is known of glTF, and how its content is told.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};
use crate::text::{trimmed_start, without_mark};

pub(crate) const FACTS: Facts = Facts {
    name: "glTF",
    extensions: &["gltf"],
    encodings: &[Encoding::LittleEndian],
    variant: |_| "gltf",
    holds_polygons: false,
    has_indices: false,
    texture_origin: TextureOrigin::UpperLeft,
    sniff,
};

/// Whether it is a JSON object that says near its start what asset it is.
fn sniff(bytes: &[u8], _: u64) -> bool {
    const NAME: &[u8] = b"\"asset\"";
    trimmed_start(without_mark(bytes)).starts_with(b"{") && bytes.windows(NAME.len()).any(|at| at == NAME)
}
