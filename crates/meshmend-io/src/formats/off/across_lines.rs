//! OFF files with any line breaks: several vertices or faces on a line, all on one line, or one across several lines.
//!
//! Only colours of faces depend on lines. Colours of vertices may have three or four numbers, and faces may have
//! colours or not. Each form is tried, and it is accepted only if it uses up the file to the last word.

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

/// Reads a file across lines, if one of the forms uses it up.
pub(super) fn read<'a>(source: &'a Source<'a>, limits: &'a Limits) -> Option<Reader<'a>> {
    let columns = Reader::new(source, limits).header().ok()?;
    // Without colours of vertices, their width does not matter.
    let widths = if columns.color { &[4, 3][..] } else { &[0] };
    let forms = widths
        .iter()
        .flat_map(|&width| [FacePlacement::OnLines, FacePlacement::Anywhere].map(|faces| (width, faces)));
    forms.into_iter().find_map(|(width, faces)| read_form(source, limits, width, faces))
}

/// Reads a file with so many numbers in the colour of a vertex, if that uses the file up.
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
