//! What is known of PLY, and how its content is told.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};
use crate::text;

pub(crate) const FACTS: Facts = Facts {
    name: "PLY",
    extensions: &["ply"],
    encodings: &[Encoding::LittleEndian, Encoding::BigEndian, Encoding::Ascii],
    variant: |encoding| match encoding {
        Encoding::Ascii => "ply-ascii",
        Encoding::LittleEndian => "ply-le",
        Encoding::BigEndian => "ply-be",
    },
    holds_polygons: true,
    has_indices: true,
    texture_origin: TextureOrigin::LowerLeft,
    sniff: |head, _| sniff(head),
};

/// Whether a text surely begins as PLY: with its word on a line, and a statement on the next one.
fn sniff(bytes: &[u8]) -> bool {
    const STATEMENTS: [&[u8]; 4] = [b"format", b"comment", b"obj_info", b"element"];
    let start = &bytes[..bytes.len().min(1 << 12)];
    let mut lines = start.split(|&b| text::is_line_end(b)).map(text::trimmed);
    let second = |line: &[u8]| STATEMENTS.contains(&text::word(line, 0));
    lines.next() == Some(b"ply") && lines.find(|line| !line.is_empty()).is_some_and(second)
}
