//! The two blocks of an OFF file: its vertices, and its faces. Lines without anything beside coordinates or indices are
//! parsed ahead.

use meshmend_core::counted;

use crate::ReadError;
use crate::formats::off::beside::Beside;
use crate::formats::off::header::Columns;
use crate::formats::off::lines::{Points, Polygons};
use crate::formats::off::read::Reader;
use crate::text;
use crate::text::speculative_parse::{self as ahead, Pace, read_ahead};

pub(super) fn read_vertices(
    reader: &mut Reader<'_>,
    count: usize,
    columns: Columns,
) -> Result<(), ReadError> {
    reader.parts.positions.reserve_exact(count);
    // Three numbers are a vertex only where it has nothing beside them.
    let pace = if columns == Columns::default() { reader.source.pace } else { Pace::NONE };
    let text = reader.bytes;
    let mut block = Vertices { reader, count, columns, beside: Beside::default() };
    read_ahead(text, pace, &Points::default(), &mut block)?;
    let Vertices { reader, beside, .. } = block;
    beside.finish(columns, reader);
    Ok(())
}

pub(super) fn read_faces(reader: &mut Reader<'_>, count: usize) -> Result<(), ReadError> {
    let (text, pace) = (reader.bytes, reader.source.pace);
    read_ahead(text, pace, &Polygons::default(), &mut Faces { reader, count })
}

struct Vertices<'r, 'a> {
    reader: &'r mut Reader<'a>,
    count: usize,
    columns: Columns,
    beside: Beside<'a>,
}

impl Vertices<'_, '_> {
    fn vertex(&mut self) -> Result<(), ReadError> {
        let (reader, columns, beside) = (&mut *self.reader, self.columns, &mut self.beside);
        reader.next_line("a vertex")?;
        let vertex = reader.parts.positions.len();
        let point = [reader.number()?, reader.number()?, reader.number()?];
        reader.parts.positions.push(point);
        reader.skip_blanks();
        let start = reader.at;
        if columns.normal {
            beside.normals.extend([reader.number()?, reader.number()?, reader.number()?]);
        }
        if columns.color {
            let color = reader.color(columns.texcoord);
            beside.add_color(reader, columns, vertex, start, color);
        }
        if columns.texcoord {
            beside.texcoords.extend([reader.number()?, reader.number()?]);
        }
        reader.note_surplus_columns();
        Ok(())
    }
}

impl ahead::Reader<Points> for Vertices<'_, '_> {
    fn at(&self) -> usize {
        self.reader.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        while !self.is_done() && self.reader.line_begins_before(end) {
            self.vertex()?;
        }
        Ok(())
    }

    fn take(&mut self, rows: &Points, end: usize) {
        let positions = &mut self.reader.parts.positions;
        if positions.len() + rows.positions.len() <= self.count {
            positions.extend_from_slice(&rows.positions);
            self.reader.at = end;
        }
    }

    fn is_done(&self) -> bool {
        self.reader.parts.positions.len() == self.count
    }
}

struct Faces<'r, 'a> {
    reader: &'r mut Reader<'a>,
    count: usize,
}

impl Faces<'_, '_> {
    fn face(&mut self) -> Result<(), ReadError> {
        let reader = &mut *self.reader;
        reader.next_line("a face")?;
        let start = reader.at;
        let degree = reader.count("corners")?;
        let (face, corners) = (reader.parts.faces.face_count(), reader.parts.faces.corner_count() as u64);
        // An index takes a blank and a digit: more corners than half the bytes that are left can't be there.
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

impl ahead::Reader<Polygons> for Faces<'_, '_> {
    fn at(&self) -> usize {
        self.reader.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        while !self.is_done() && self.reader.line_begins_before(end) {
            self.face()?;
        }
        Ok(())
    }

    fn take(&mut self, rows: &Polygons, end: usize) {
        let faces = &self.reader.parts.faces;
        let corners = (faces.corner_count() + rows.faces.corner_count()) as u64;
        let is_within = faces.face_count() + rows.faces.face_count() <= self.count
            && corners <= self.reader.limits.max_corners;
        if is_within {
            self.reader.parts.take_faces(&rows.faces, rows.highest);
            self.reader.at = end;
        }
    }

    fn is_done(&self) -> bool {
        self.reader.parts.faces.face_count() == self.count
    }
}
