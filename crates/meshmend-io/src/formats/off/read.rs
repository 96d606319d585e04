//! The OFF reader: its two ways through a file.

use meshmend_core::Domain;

use crate::formats::off::across_lines;
use crate::formats::off::reader::Reader;
use crate::formats::off::sections::{read_faces, read_vertices};
use crate::formats::off::shape::OffShape;
use crate::input::source::{Parsed, Source};
use crate::text::{is_blank, is_line_end};
use crate::{Encoding, Format, Limits, NoteKind, Place, ReadError, ReadErrorKind, Shell};

/// Reads by lines. If that leaves something over or missing, reads across lines, and takes the result if it uses the
/// file up.
pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let by_lines = read_by_lines(source, limits);
    let is_sure = match &by_lines {
        Ok(reader) => reader.is_even,
        Err(error) => !matches!(error.kind, ReadErrorKind::Malformed(_)),
    };
    let across_lines = if is_sure { None } else { across_lines::read(source, limits) };
    across_lines.map_or(by_lines, Ok)?.finish()
}

fn read_by_lines<'a>(source: &'a Source<'a>, limits: &'a Limits) -> Result<Reader<'a>, ReadError> {
    let mut reader = Reader::new(source, limits);
    let columns = reader.header()?;
    let [vertices, faces] = reader.counts()?;
    if !reader.begins_line() {
        reader.note_surplus("what stands behind the counts was skipped");
    }
    read_vertices(&mut reader, vertices, columns)?;
    read_faces(&mut reader, faces)?;
    reader.surplus();
    Ok(reader)
}

impl Reader<'_> {
    /// The mesh, with the colours of its vertices and faces.
    fn finish(mut self) -> Result<Parsed, ReadError> {
        let has_fractions = self.vertex_colors.has_fractions() || self.face_colors.has_fractions();
        let counts = [self.parts.positions.len(), self.parts.faces.face_count()];
        let colors = [(self.vertex_colors, Domain::Vertex), (self.face_colors, Domain::Face)];
        for ((colors, domain), count) in colors.into_iter().zip(counts) {
            let opaque = colors.without_alpha_among_others(has_fractions);
            let message = "colours without an alpha among others were given an opaque one";
            self.parts.notes.add_many(NoteKind::MixedWidths, message, opaque, || Place::File);
            self.parts.layers.extend(colors.layer(domain, count, has_fractions));
        }
        let source = self.source;
        let (mesh, notes) = self.parts.assemble(source, 0, |at| source.line(at))?;
        let shape = OffShape { letters: self.letters.to_vec() };
        let shell = Shell::of_file(Format::Off, Encoding::Ascii, shape);
        Ok(Parsed::whole(mesh, notes, shell))
    }

    /// Whether the next word is the first of its line.
    fn begins_line(&mut self) -> bool {
        let before = &self.bytes[..self.at];
        let is_first = before.iter().rev().find(|&&b| !is_blank(b)).is_none_or(|&b| is_line_end(b));
        self.skip_blanks();
        is_first || self.line_ended()
    }

    fn surplus(&mut self) {
        while self.find_line() {
            self.note(NoteKind::SurplusData, "lines after the last face were skipped");
            self.end_line();
        }
    }
}
