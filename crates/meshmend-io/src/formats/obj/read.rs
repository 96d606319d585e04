//! The OBJ reader: one pass over the bytes, without copying lines. Usual statements are parsed ahead of it.

use std::borrow::Cow;

use meshmend_core::VertexId;

use crate::formats::obj::comment_anchors::{COMMENT, ELEMENTS, END};
use crate::formats::obj::name_statements::KINDS;
use crate::formats::obj::reader::Reader;
use crate::formats::obj::statement_cursor::COLUMNS;
use crate::formats::obj::usual_statements::UsualStatements;
use crate::input::source::{Parsed, Source};
use crate::text::speculative_parse::{SequentialReader, read_speculatively};
use crate::text::{self, is_blank, is_line_end};
use crate::{Limits, NoteKind, ReadError};

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let mut reader = Reader::new(source, limits);
    read_speculatively(source.bytes, source.pace, &UsualStatements::default(), &mut reader)?;
    reader.finish()
}

impl Reader<'_> {
    #[inline]
    fn statement(&mut self, first: u8) -> Result<(), ReadError> {
        let is_short =
            self.cursor.bytes.get(self.cursor.at + 1).is_none_or(|&b| is_blank(b) || is_line_end(b));
        match first {
            b'v' if is_short => {
                self.cursor.at += 1;
                self.vertex()
            }
            b'f' if is_short => {
                self.cursor.at += 1;
                self.face()
            }
            _ => self.other_statement(),
        }
    }

    fn other_statement(&mut self) -> Result<(), ReadError> {
        let start = self.cursor.at;
        let keyword = text::word(self.cursor.bytes, start);
        self.cursor.at += keyword.len();
        if keyword.contains(&0) {
            return Err(self.cursor.wrong(start, "a NUL byte in a statement"));
        }
        let known = std::mem::replace(&mut self.is_obj, true);
        match keyword {
            b"vt" => self.texcoord(start),
            b"vn" => self.normal(start),
            b"l" => self.polyline(start),
            b"p" => self.points(),
            b"mtllib" => {
                let name = self.cursor.rest()?;
                self.keep("mtllib", &name, start);
                Ok(())
            }
            _ => match KINDS.iter().position(|kind| kind.statement == keyword) {
                Some(kind) => self.name(kind, start),
                None => {
                    self.is_obj = known;
                    self.unknown(keyword, start)
                }
            },
        }
    }

    fn unknown(&mut self, keyword: &[u8], start: usize) -> Result<(), ReadError> {
        self.cursor.rest()?;
        let message = format!("statement `{}` is not understood and was skipped", text::shown(keyword));
        let source = self.source;
        self.parts.notes.add(NoteKind::SkippedStatement, &message, || source.line(start));
        Ok(())
    }

    fn comment(&mut self) {
        let (start, end) = (self.cursor.at, text::line_end(self.cursor.bytes, self.cursor.at));
        let bytes = self.cursor.bytes;
        self.is_obj |= bytes.len() > 1;
        let key = self.comment_key(end);
        self.keep(&key, text::comment_text(&bytes[start + 1..end]), start);
        self.cursor.at = end;
    }

    /// The key of a comment that ends at a byte. Before the first vertex, comments belong to the file.
    fn comment_key(&mut self, end: usize) -> String {
        let kind = self.anchors.after(self.cursor.bytes, end);
        let elements = self.elements();
        let counts = [
            self.parts.positions.len(),
            self.texcoords.len(),
            self.normals.len(),
            elements.faces,
            elements.edges,
            elements.points,
        ];
        if counts[0] == 0 {
            return COMMENT.to_owned();
        }
        match kind {
            Some(kind) => format!("{COMMENT}@{}{}", ELEMENTS[kind], counts[kind] + 1),
            None => format!("{COMMENT}@{END}"),
        }
    }

    fn keep(&mut self, key: &str, value: &[u8], start: usize) {
        let source = self.source;
        self.parts.keep_statement(key, value, self.limits, || source.line(start));
    }

    fn name(&mut self, kind: usize, start: usize) -> Result<(), ReadError> {
        let name = self.cursor.rest()?;
        let name = if name[..] == *KINDS[kind].none { Cow::Borrowed(&b""[..]) } else { name };
        let first = self.elements();
        self.names[kind].start(first, name, start);
        Ok(())
    }

    fn vertex(&mut self) -> Result<(), ReadError> {
        let start = self.cursor.at;
        let mut numbers = [0.0; COLUMNS];
        let count = self.cursor.numbers(&mut numbers)?;
        let index = self.parts.positions.len();
        self.source.limited("vertices", index as u64 + 1, self.limits.max_vertices)?;
        let [x, y, z, ..] = numbers;
        self.parts.positions.push([x, y, z]);
        self.is_obj = true;
        match count {
            3 => {}
            0..3 => return Err(self.cursor.wrong(start, "a vertex with fewer than three coordinates")),
            4 => self.weight(index, numbers[3]),
            6 => self.colors.set(index, [numbers[3], numbers[4], numbers[5], 1.0], 3),
            7 => self.colors.set(index, [numbers[3], numbers[4], numbers[5], numbers[6]], 4),
            _ => self.note_surplus("vertices with more numbers than are understood", start),
        }
        if let Some(weights) = self.weights.as_mut().filter(|weights| weights.len() <= index) {
            weights.push(1.0);
        }
        Ok(())
    }

    fn weight(&mut self, index: usize, weight: f64) {
        if weight != 1.0 || self.weights.is_some() {
            let weights = self.weights.get_or_insert_default();
            weights.resize(index, 1.0);
            weights.push(weight);
        }
    }

    fn texcoord(&mut self, start: usize) -> Result<(), ReadError> {
        let mut numbers = [0.0; COLUMNS];
        match self.cursor.numbers(&mut numbers)? {
            0 => return Err(self.cursor.wrong(start, "a texture coordinate without a number")),
            count @ 1..=3 => self.texcoords.push(&numbers[..count]),
            _ => {
                self.texcoords.push(&numbers[..3]);
                self.note_surplus("texture coordinates with more than three numbers", start);
            }
        }
        Ok(())
    }

    fn normal(&mut self, start: usize) -> Result<(), ReadError> {
        let mut numbers = [0.0; COLUMNS];
        let count = self.cursor.numbers(&mut numbers)?;
        if count < 3 {
            return Err(self.cursor.wrong(start, "a normal with fewer than three numbers"));
        }
        self.normals.push(&numbers[..3]);
        if count > 3 {
            self.note_surplus("normals with more than three numbers", start);
        }
        Ok(())
    }

    fn face(&mut self) -> Result<(), ReadError> {
        self.is_obj = true;
        while self.cursor.more_items() {
            let start = self.cursor.at;
            let raw = self.cursor.index("a vertex index")?;
            let vertex = self.vertex_index(raw, start)?;
            let corner = self.parts.faces.corner_count();
            self.parts.faces.push_corner(VertexId(vertex));
            if self.cursor.peek() == Some(b'/') {
                self.attributes(corner, start)?;
            }
            self.cursor.end_item("a corner")?;
        }
        self.parts.faces.end_face();
        let (faces, corners) = (self.parts.faces.face_count(), self.parts.faces.corner_count());
        self.source.limited("faces", faces as u64, self.limits.max_faces)?;
        self.source.limited("corners", corners as u64, self.limits.max_corners)
    }

    /// What follows the vertex of a corner: `/t`, `//n` or `/t/n`. An index may be missing after its slash.
    fn attributes(&mut self, corner: usize, start: usize) -> Result<(), ReadError> {
        self.cursor.at += 1;
        if self.cursor.is_index() {
            let raw = self.cursor.index("a texture index")?;
            let value = self.attribute_index(raw, self.texcoords.len(), start);
            self.texcoord_uses.set(corner, value, start);
        }
        if self.cursor.peek() != Some(b'/') {
            return Ok(());
        }
        self.cursor.at += 1;
        if self.cursor.is_index() {
            let raw = self.cursor.index("a normal index")?;
            let value = self.attribute_index(raw, self.normals.len(), start);
            self.normal_uses.set(corner, value, start);
        }
        Ok(())
    }

    fn note_surplus(&mut self, message: &str, start: usize) {
        let source = self.source;
        self.parts.notes.add(NoteKind::SurplusColumns, message, || source.line(start));
    }
}

impl SequentialReader<UsualStatements> for Reader<'_> {
    fn at(&self) -> usize {
        self.cursor.at
    }

    fn read_to(&mut self, end: usize) -> Result<(), ReadError> {
        while self.cursor.at < end {
            self.cursor.skip_blanks();
            match self.cursor.peek() {
                None => return Ok(()),
                Some(byte) if is_line_end(byte) => self.cursor.at += 1,
                Some(b'#') => self.comment(),
                Some(first) => self.statement(first)?,
            }
        }
        Ok(())
    }

    fn take(&mut self, rows: &UsualStatements, end: usize) {
        let (faces, corners) = (self.parts.faces.face_count(), self.parts.faces.corner_count());
        let is_within = self.limits.hold(
            self.parts.positions.len() + rows.positions.len(),
            faces + rows.faces.face_count(),
            corners + rows.faces.corner_count(),
        );
        if !is_within || !self.texcoords.append(&rows.texcoords) {
            return;
        }
        self.is_obj = true;
        self.colors.append(self.parts.positions.len(), &rows.colors);
        self.parts.positions.extend_from_slice(&rows.positions);
        if let Some(weights) = &mut self.weights {
            weights.resize(self.parts.positions.len(), 1.0);
        }
        self.normals.append(&rows.normals);
        self.texcoord_uses.append(corners, &rows.texcoord_uses);
        self.normal_uses.append(corners, &rows.normal_uses);
        self.parts.take_faces(&rows.faces, rows.max_index);
        self.cursor.at = end;
    }

    fn is_done(&self) -> bool {
        false
    }

    fn look(&self) -> Result<(), ReadError> {
        self.source.look(self.at())
    }
}
