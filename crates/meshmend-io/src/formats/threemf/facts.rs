//! What is known of 3MF.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};

pub(crate) const FACTS: Facts = Facts {
    name: "3MF",
    extensions: &["3mf"],
    encodings: &[Encoding::Ascii],
    variant: |_| "3mf",
    holds_polygons: false,
    has_indices: true,
    texture_origin: TextureOrigin::LowerLeft,
    sniff,
};

/// Whether a zip archive begins with one of the entries that a package has. Such an archive can be something else if
/// they come later, so others are known by their names alone.
fn sniff(head: &[u8], _: u64) -> bool {
    let has = |name: &[u8]| head.windows(name.len()).any(|window| window == name);
    head.starts_with(b"PK\x03\x04")
        && [&b"3D/3dmodel"[..], b"3D/_rels", b"3dmanufacturing"].iter().any(|name| has(name))
}
