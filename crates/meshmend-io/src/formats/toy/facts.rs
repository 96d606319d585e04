//! What is known of the example of CONTRIBUTING: a line `toy`, then vertices `v x y z` and faces `f i j …`, counted
//! from 0.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};

pub(crate) const FACTS: Facts = Facts {
    name: "TOY",
    extensions: &["toy"],
    encodings: &[Encoding::Ascii],
    variant: |_| "toy",
    holds_polygons: true,
    has_indices: true,
    texture_origin: TextureOrigin::LowerLeft,
    sniff: |head, _| head.starts_with(b"toy\n"),
};
