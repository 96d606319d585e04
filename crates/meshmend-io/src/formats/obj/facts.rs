//! What is known of OBJ, and how its content is told.

use crate::Encoding;
use crate::formats::facts::{Facts, TextureOrigin};
use crate::text::{self, is_line_end};

pub(crate) const FACTS: Facts = Facts {
    name: "OBJ",
    extensions: &["obj"],
    encodings: &[Encoding::Ascii],
    variant: |_| "obj",
    holds_polygons: true,
    has_indices: true,
    texture_origin: TextureOrigin::LowerLeft,
    sniff: |head, _| sniff(head),
};

/// Whether a text surely is OBJ: it begins with a usual statement, and has a vertex, a texture coordinate or a
/// normal.
fn sniff(bytes: &[u8]) -> bool {
    const FIRST: [&[u8]; 8] = [b"v", b"mtllib", b"o", b"g", b"vn", b"vt", b"usemtl", b"s"];
    let start = &bytes[..bytes.len().min(1 << 16)];
    let lines = start.split(|&b| is_line_end(b)).map(text::trimmed);
    let mut statements = lines.filter(|line| !line.is_empty() && !line.starts_with(b"#")).peekable();
    let begins_so = statements.peek().is_some_and(|line| FIRST.contains(&text::word(line, 0)));
    begins_so && statements.any(is_values)
}

/// Whether a line has the word of a vertex, a texture coordinate or a normal, and numbers alone behind it.
fn is_values(line: &[u8]) -> bool {
    let mut words = text::words(line);
    let least = match words.next() {
        Some(b"v" | b"vn") => 3,
        Some(b"vt") => 1,
        _ => return false,
    };
    let is_number = |word: &[u8]| text::real::<f64>(word).is_some_and(|(_, length)| length == word.len());
    let mut count = 0;
    let are_numbers = words.take_while(|word| !word.starts_with(b"#")).inspect(|_| count += 1).all(is_number);
    are_numbers && count >= least
}
