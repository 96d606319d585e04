//! What is known of STL, and how its content is told.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};
use crate::formats::stl::form::{HEAD, begins_with_solid, claimed_length};
use crate::formats::stl::solid_names::holds_facet;

pub(crate) const FACTS: Facts = Facts {
    name: "STL",
    extensions: &["stl", "stla", "stlb"],
    encodings: &[Encoding::LittleEndian, Encoding::Ascii],
    variant: |encoding| match encoding {
        Encoding::Ascii => "stl-ascii",
        Encoding::LittleEndian | Encoding::BigEndian => "stl-binary",
    },
    holds_polygons: false,
    has_indices: false,
    texture_origin: TextureOrigin::LowerLeft,
    sniff,
};

/// Whether it is a text that begins with `solid` and a facet, or binary of exactly the length of its count.
fn sniff(bytes: &[u8], length: u64) -> bool {
    const START: usize = 1 << 12;
    let is_exact = claimed_length(bytes) == Some(length) && bytes.len() > HEAD;
    is_exact || begins_with_solid(bytes) && holds_facet(&bytes[..bytes.len().min(START)])
}
