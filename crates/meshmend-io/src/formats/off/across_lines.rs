//! OFF whose numbers stand on lines in any way: several vertices or faces in one, all in one, or one over several.
//!
//! Only the colours of faces are bound to lines. Colours of vertices may have three or four numbers, and faces colours or
//! none: each is tried, and an answer counts only if it uses up the file to the last word.

use crate::formats::off::letters::Columns;
use crate::formats::off::reader::Reader;
use crate::formats::off::sections::read_faces;
use crate::formats::off::vertex_attributes::VertexAttributes;
use crate::input::source::Source;
use crate::{Limits, NoteKind};

/// Where faces stand.
#[derive(Clone, Copy)]
enum FacePlacement {
    /// Each on a line of its own, with or without a colour behind it.
    OnLines,
    /// Anywhere, without colours.
    Anywhere,
}

/// The file across lines, if it comes out even in one of its forms.
pub(super) fn read<'a>(source: &'a Source<'a>, limits: &'a Limits) -> Option<Reader<'a>> {
    let columns = Reader::new(source, limits).header().ok()?;
    // Where vertices have no colours, it does not matter how many numbers those would have.
    let widths = if columns.color { &[4, 3][..] } else { &[0] };
    let forms = widths
        .iter()
        .flat_map(|&width| [FacePlacement::OnLines, FacePlacement::Anywhere].map(|faces| (width, faces)));
    forms.into_iter().find_map(|(width, faces)| read_form(source, limits, width, faces))
}

/// The file, if it comes out even with so many numbers in the colour of a vertex.
fn read_form<'a>(
    source: &'a Source<'a>,
    limits: &'a Limits,
    width: usize,
    faces: FacePlacement,
) -> Option<Reader<'a>> {
    let mut reader = Reader::new(source, limits);
    let columns = reader.header().ok()?;
    let [vertex_count, face_count] = reader.counts().ok()?;
    let at = reader.at;
    let mut attributes = VertexAttributes::default();
    (0..vertex_count).try_for_each(|_| vertex(&mut reader, columns, width, &mut attributes))?;
    attributes.finish(columns, &mut reader);
    match faces {
        FacePlacement::OnLines => {
            reader.skip_blanks();
            reader.line_ended().then_some(())?;
            read_faces(&mut reader, face_count).ok()?;
        }
        FacePlacement::Anywhere => (0..face_count).try_for_each(|_| face(&mut reader))?,
    }
    if reader.find_line() || reader.parts.max_index.beyond(vertex_count).is_some() {
        return None;
    }
    reader.at = at;
    reader.note(
        NoteKind::WrappedRows,
        "vertices or faces that do not stand on a line each were read across lines",
    );
    Some(reader)
}

fn vertex<'a>(
    reader: &mut Reader<'a>,
    columns: Columns,
    width: usize,
    attributes: &mut VertexAttributes<'a>,
) -> Option<()> {
    let vertex = reader.parts.positions.len();
    let point = [number(reader)?, number(reader)?, number(reader)?];
    reader.parts.positions.push(point);
    if columns.normal || columns.color {
        reader.find_line();
    }
    let start = reader.at;
    if columns.normal {
        attributes.normals.extend([number(reader)?, number(reader)?, number(reader)?]);
    }
    if columns.color {
        reader.find_line();
        let color_start = reader.at;
        for _ in 0..width {
            number(reader)?;
        }
        let color = &reader.bytes[color_start..reader.at];
        if reader.bytes[start..reader.at].contains(&b'#') {
            return None;
        }
        attributes.add_color(reader, columns, vertex, start, color);
    }
    if columns.texcoord {
        attributes.texcoords.extend([number(reader)?, number(reader)?]);
    }
    Some(())
}

fn face(reader: &mut Reader<'_>) -> Option<()> {
    let degree = whole(reader)?;
    let corners = reader.parts.faces.corner_count() as u64;
    (corners.saturating_add(degree) <= reader.limits.max_corners).then_some(())?;
    for _ in 0..degree {
        reader.find_line();
        reader.corner().ok()?;
    }
    reader.parts.faces.end_face();
    Some(())
}

fn number(reader: &mut Reader<'_>) -> Option<f64> {
    reader.find_line();
    reader.number().ok()
}

fn whole(reader: &mut Reader<'_>) -> Option<u64> {
    reader.find_line();
    reader.count("corners").ok()
}
