//! The two sections of an OFF file: its vertices, and its faces. Lines that have only coordinates or indices are
//! parsed ahead.

use meshmend_core::counted;

use crate::ReadError;
use crate::formats::off::letters::Columns;
use crate::formats::off::reader::Reader;
use crate::formats::off::usual_lines::{UsualFaces, UsualVertices};
use crate::formats::off::vertex_attributes::VertexAttributes;
use crate::text;
use crate::text::speculative_parse::{Pace, SequentialReader, read_speculatively};

pub(super) fn read_vertices(
    reader: &mut Reader<'_>,
    count: usize,
    columns: Columns,
) -> Result<(), ReadError> {
    reader.parts.positions.reserve_exact(count);
    // Three numbers are a whole vertex only if the header announces no other columns.
    let pace = if columns == Columns::default() { reader.source.pace } else { Pace::NONE };
    let text = reader.bytes;
    let mut section = VertexSection { reader, count, columns, attributes: VertexAttributes::default() };
    read_speculatively(text, pace, &UsualVertices::default(), &mut section)?;
    let VertexSection { reader, attributes, .. } = section;
    attributes.finish(columns, reader);
    Ok(())
}

pub(super) fn read_faces(reader: &mut Reader<'_>, count: usize) -> Result<(), ReadError> {
    let (text, pace) = (reader.bytes, reader.source.pace);
    read_speculatively(text, pace, &UsualFaces::default(), &mut FaceSection { reader, count })
}

struct VertexSection<'r, 'a> {
    reader: &'r mut Reader<'a>,
    count: usize,
    columns: Columns,
    attributes: VertexAttributes<'a>,
}

impl VertexSection<'_, '_> {
    fn vertex(&mut self) -> Result<(), ReadError> {
        let (reader, columns, attributes) = (&mut *self.reader, self.columns, &mut self.attributes);
        reader.next_line("a vertex")?;
        let vertex = reader.parts.positions.len();
        let point = [reader.number()?, reader.number()?, reader.number()?];
        reader.parts.positions.push(point);
        reader.skip_blanks();
        let start = reader.at;
        if columns.normal {
            attributes.normals.extend([reader.number()?, reader.number()?, reader.number()?]);
        }
        if columns.color {
            let color = reader.color(columns.texcoord);
            attributes.add_color(reader, columns, vertex, start, color);
        }
        if columns.texcoord {
            attributes.texcoords.extend([reader.number()?, reader.number()?]);
        }
        reader.note_surplus_columns();
        Ok(())
    }
}

impl SequentialReader<UsualVertices> for VertexSection<'_, '_> {
    fn at(&self) -> usize {
        self.reader.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        while !self.is_done() && self.reader.line_begins_before(end) {
            self.vertex()?;
        }
        Ok(())
    }

    fn take(&mut self, rows: &UsualVertices, end: usize) {
        let positions = &mut self.reader.parts.positions;
        if positions.len() + rows.positions.len() <= self.count {
            positions.extend_from_slice(&rows.positions);
            self.reader.at = end;
        }
    }

    fn is_done(&self) -> bool {
        self.reader.parts.positions.len() == self.count
    }

    fn look(&self) -> Result<(), ReadError> {
        self.reader.source.look(self.reader.at)
    }
}

struct FaceSection<'r, 'a> {
    reader: &'r mut Reader<'a>,
    count: usize,
}

impl FaceSection<'_, '_> {
    fn face(&mut self) -> Result<(), ReadError> {
        let reader = &mut *self.reader;
        reader.next_line("a face")?;
        let start = reader.at;
        let degree = reader.count("corners")?;
        let (face, corners) = (reader.parts.faces.face_count(), reader.parts.faces.corner_count() as u64);
        // An index takes a blank and a digit, so there are at most half as many corners as bytes.
        if degree > ((reader.bytes.len() - reader.at) / 2) as u64 {
            let reason = format!("a face of {} does not fit its line", counted(degree, "corner"));
            return Err(reader.wrong(start, &reason));
        }
        reader.source.limited("corners", corners + degree, reader.limits.max_corners)?;
        for _ in 0..degree {
            reader.corner()?;
        }
        reader.parts.faces.end_face();
        reader.skip_blanks();
        if !reader.line_ended() {
            reader.face_colors.add(face, text::trimmed(reader.rest()));
        }
        reader.end_line();
        Ok(())
    }
}

impl SequentialReader<UsualFaces> for FaceSection<'_, '_> {
    fn at(&self) -> usize {
        self.reader.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        while !self.is_done() && self.reader.line_begins_before(end) {
            self.face()?;
        }
        Ok(())
    }

    fn take(&mut self, rows: &UsualFaces, end: usize) {
        let faces = &self.reader.parts.faces;
        let corners = (faces.corner_count() + rows.faces.corner_count()) as u64;
        let is_within = faces.face_count() + rows.faces.face_count() <= self.count
            && corners <= self.reader.limits.max_corners;
        if is_within {
            self.reader.parts.take_faces(&rows.faces, rows.max_index);
            self.reader.at = end;
        }
    }

    fn is_done(&self) -> bool {
        self.reader.parts.faces.face_count() == self.count
    }

    fn look(&self) -> Result<(), ReadError> {
        self.reader.source.look(self.reader.at)
    }
}
