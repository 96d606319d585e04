//! On which lines of a text file its vertices and faces stand.
//!
//! Readers don't keep this: few need it, and of few elements. It is found in a second pass over the text, for OBJ, OFF and text
//! PLY that have one element a line. Where the lines don't come out even, none is told: a wrong line would be worse.

use std::collections::BTreeMap;

use meshmend_core::{FaceId, VertexId};

use crate::Format;
use crate::text::{after_line_end, line_end, trimmed, without_mark, word, words};

/// The lines of some elements of a text file, counted from 1.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ElementLines {
    vertices: BTreeMap<u32, u64>,
    faces: BTreeMap<u32, u64>,
}

impl ElementLines {
    /// Finds the lines of these vertices and faces in a file that has so many of each. None is told of other formats, of binary
    /// files, and where elements don't have a line each.
    ///
    /// *Cost*: linear in the text.
    pub fn find(
        text: &[u8],
        format: Format,
        (vertices, faces): (usize, usize),
        wanted: (&[VertexId], &[FaceId]),
    ) -> Self {
        let text = without_mark(text);
        let mut asked = Asked {
            seen: [0; 2],
            wanted: [sorted(wanted.0, |v| v.0), sorted(wanted.1, |f| f.0)],
            found: Default::default(),
        };
        let is_even = match format {
            Format::Obj => in_obj(text, &mut asked),
            Format::Off => in_off(text, (vertices, faces), &mut asked),
            Format::Ply => in_ply(text, (vertices, faces), &mut asked),
            _ => None,
        };
        if is_even.is_none() || asked.seen != [vertices, faces].map(|count| count as u64) {
            return ElementLines::default();
        }
        let [vertices, faces] = asked.found;
        ElementLines { vertices, faces }
    }

    /// The line of a vertex, if it was asked for and is known.
    pub fn vertex(&self, vertex: VertexId) -> Option<u64> {
        self.vertices.get(&vertex.0).copied()
    }

    /// The line of a face, if it was asked for and is known.
    pub fn face(&self, face: FaceId) -> Option<u64> {
        self.faces.get(&face.0).copied()
    }
}

fn sorted<I: Copy>(ids: &[I], number: impl Fn(I) -> u32) -> Vec<u32> {
    let mut numbers: Vec<u32> = ids.iter().map(|&id| number(id)).collect();
    numbers.sort_unstable();
    numbers
}

/// What was seen of vertices and faces, and what is asked of them.
struct Asked {
    seen: [u64; 2],
    wanted: [Vec<u32>; 2],
    found: [BTreeMap<u32, u64>; 2],
}

const VERTEX: usize = 0;
const FACE: usize = 1;

impl Asked {
    fn see(&mut self, kind: usize, line: u64) {
        let number = self.seen[kind];
        self.seen[kind] += 1;
        let number = u32::try_from(number).unwrap_or(u32::MAX);
        if self.wanted[kind].binary_search(&number).is_ok() {
            self.found[kind].insert(number, line);
        }
    }
}

/// The lines of a text with their numbers, without blanks round them.
fn lines(text: &[u8]) -> impl Iterator<Item = (u64, &[u8])> {
    let mut at = 0;
    let next = move || {
        let begin = (at < text.len()).then_some(at)?;
        let end = line_end(text, begin);
        at = after_line_end(text, end);
        Some(trimmed(&text[begin..end]))
    };
    (1..).zip(std::iter::from_fn(next))
}

/// The lines that say something: all but empty ones and comments.
fn content(text: &[u8]) -> impl Iterator<Item = (u64, &[u8])> {
    lines(text).filter(|(_, line)| !line.is_empty() && !line.starts_with(b"#"))
}

fn in_obj(text: &[u8], asked: &mut Asked) -> Option<()> {
    let mut is_continued = false;
    for (number, line) in lines(text) {
        if !is_continued {
            match word(line, 0) {
                b"v" => asked.see(VERTEX, number),
                b"f" => asked.see(FACE, number),
                _ => {}
            }
        }
        is_continued = line.ends_with(b"\\") && !line.starts_with(b"#");
    }
    Some(())
}

fn in_off(text: &[u8], (vertices, faces): (usize, usize), asked: &mut Asked) -> Option<()> {
    let mut rows = content(text).skip_while(|(_, line)| !line[0].is_ascii_digit() && !has_counts(line));
    // The counts.
    rows.next()?;
    for (kind, count) in [(VERTEX, vertices), (FACE, faces)] {
        for _ in 0..count {
            asked.see(kind, rows.next()?.0);
        }
    }
    rows.next().is_none().then_some(())
}

/// Whether a line of letters also has the counts.
fn has_counts(line: &[u8]) -> bool {
    line.iter().any(u8::is_ascii_digit) && line.iter().filter(|b| b.is_ascii_alphabetic()).count() >= 3
}

fn in_ply(text: &[u8], counts: (usize, usize), asked: &mut Asked) -> Option<()> {
    let mut rows = lines(text);
    let (mut elements, mut is_text) = (Vec::new(), false);
    loop {
        let (_, line) = rows.next()?;
        let mut said = words(line);
        match (said.next(), said.next(), said.next()) {
            (Some(b"format"), Some(form), _) => is_text = form == b"ascii",
            (Some(b"element"), Some(name), Some(count)) => {
                elements.push((name, std::str::from_utf8(count).ok()?.parse::<usize>().ok()?));
            }
            (Some(b"end_header"), ..) => break,
            _ => {}
        }
    }
    let mut rows = rows.filter(|(_, line)| !line.is_empty());
    for (name, count) in is_text.then_some(elements)? {
        let kind = match name {
            b"vertex" if count == counts.0 => Some(VERTEX),
            b"face" if count == counts.1 => Some(FACE),
            _ => None,
        };
        for _ in 0..count {
            let (number, _) = rows.next()?;
            kind.into_iter().for_each(|kind| asked.see(kind, number));
        }
    }
    rows.next().is_none().then_some(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Encoding, ReadOptions, WriteOptions, encode, read_bytes};

    /// The lines of all vertices and faces.
    fn found(text: &str, format: Format) -> (Vec<Option<u64>>, Vec<Option<u64>>) {
        let options = ReadOptions::default().with_format(format);
        let counts = read_bytes(text.as_bytes(), "a", &options).unwrap().mesh.counts();
        let vertices: Vec<VertexId> = (0..counts.vertices as u32).map(VertexId).collect();
        let faces: Vec<FaceId> = (0..counts.faces as u32).map(FaceId).collect();
        let lines =
            ElementLines::find(text.as_bytes(), format, (counts.vertices, counts.faces), (&vertices, &faces));
        (vertices.iter().map(|&v| lines.vertex(v)).collect(), faces.iter().map(|&f| lines.face(f)).collect())
    }

    fn known(lines: &[u64]) -> Vec<Option<u64>> {
        lines.iter().copied().map(Some).collect()
    }

    #[test]
    fn an_obj_has_statements_on_lines() {
        let text = "# v 1 2 3\r\nv 0 0 0\r\n\r\nv 1 0 0\nvn 0 0 1\n  v 0 \\\n v 1 0\nusemtl v\nf 1 2 \\\n3\nf 1 3 2\n";
        // The second line of a statement is none of its own.
        assert_eq!(
            found("v 0 0 0\n\nv 1 0 0\n v 0 \\\n1 0\nf 1 2 \\\n3\nf 1 3 2\n", Format::Obj),
            (known(&[1, 3, 4]), known(&[6, 8]))
        );
        assert!(text.contains('\r'));
        assert_eq!(
            found("# v\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", Format::Obj).0,
            known(&[2, 3, 4])
        );
    }

    #[test]
    fn off_and_ply_have_rows_in_order() {
        let off = "OFF # a mesh\n\n3 1 0\n0 0 0\n# between\n1 0 0\n0 1 0\n3 0 1 2\n";
        assert_eq!(found(off, Format::Off), (known(&[4, 6, 7]), known(&[8])));
        assert_eq!(
            found("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Format::Off),
            (known(&[2, 3, 4]), known(&[5]))
        );
        assert_eq!(found("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Format::Off).1, known(&[5]));
        // Rows that are wrapped are on no line.
        let wrapped = "OFF\n3 1 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2\n";
        assert_eq!(found(wrapped, Format::Off), (vec![None; 3], vec![None; 1]));
        let ply = "ply\nformat ascii 1.0\nelement flag 1\nproperty uchar on\nelement vertex 3\nproperty float x\nproperty float y\n\
                   property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
        assert_eq!(found(ply, Format::Ply), (known(&[13, 14, 15]), known(&[16])));
    }

    #[test]
    fn what_is_not_text_has_no_lines() {
        let mesh =
            read_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj", &Default::default()).unwrap().mesh;
        for (format, encoding) in [(Format::Ply, Encoding::LittleEndian), (Format::Stl, Encoding::Ascii)] {
            let mut bytes = Vec::new();
            encode(&mesh, &WriteOptions::of(format).with_encoding(encoding), &mut bytes).unwrap();
            let lines = ElementLines::find(&bytes, format, (3, 1), (&[VertexId(0)], &[FaceId(0)]));
            assert_eq!(lines, ElementLines::default());
        }
    }
}
