//! The OBJ reader: one pass over the bytes, without a copy of any line. Plain statements are parsed ahead of it.

use std::borrow::Cow;

use meshmend_core::{NO_VALUE, VertexId};

use crate::formats::obj::comments::Anchors;
use crate::formats::obj::loose::LooseParts;
use crate::formats::obj::name_statements::{Elements, KINDS, Runs};
use crate::formats::obj::pools::{Colors, Pool};
use crate::formats::obj::statement_cursor::{COLUMNS, Cursor};
use crate::formats::obj::usual_statements::UsualStatements;
use crate::input::assemble::{Parts, Uses, no_such_vertex};
use crate::read::{Parsed, Source};
use crate::text::speculative_parse::{SequentialReader, read_speculatively};
use crate::text::{self, is_blank, is_line_end};
use crate::{Limits, NoteKind, ReadError};

/// Whether a text surely is OBJ: it begins with a usual statement, and has a vertex, a texture coordinate or a normal.
pub(super) fn sniff(bytes: &[u8]) -> bool {
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

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let mut reader = Reader::new(source, limits);
    read_speculatively(source.bytes, source.pace, &UsualStatements::default(), &mut reader)?;
    reader.finish()
}

pub(super) struct Reader<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) limits: &'a Limits,
    pub(super) cursor: Cursor<'a>,
    /// Whether a statement, or a comment, was understood.
    pub(super) is_obj: bool,
    pub(super) parts: Parts,
    pub(super) weights: Option<Vec<f64>>,
    pub(super) colors: Colors,
    pub(super) texcoords: Pool,
    pub(super) normals: Pool,
    pub(super) texcoord_uses: Uses,
    pub(super) normal_uses: Uses,
    pub(super) names: [Runs<'a>; KINDS.len()],
    pub(super) loose: LooseParts,
    pub(super) anchors: Anchors,
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source<'a>, limits: &'a Limits) -> Self {
        let pool = |width| Pool { width, values: Vec::new(), mixed: 0 };
        Reader {
            source,
            limits,
            cursor: Cursor::new(source),
            is_obj: false,
            parts: Parts::default(),
            weights: None,
            colors: Colors::default(),
            texcoords: pool(0),
            normals: pool(3),
            texcoord_uses: Uses::default(),
            normal_uses: Uses::default(),
            names: Default::default(),
            loose: LooseParts::default(),
            anchors: Anchors::default(),
        }
    }

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

    /// How many elements there are so far.
    pub(super) fn elements(&self) -> Elements {
        Elements {
            faces: self.parts.faces.face_count(),
            edges: self.parts.loose_edges.len(),
            points: self.parts.loose_points.len(),
        }
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

    /// What follows a corner's vertex: `/t`, `//n`, `/t/n`; nothing after a slash is no value.
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

    /// The index of a vertex from 0 on; whether it exists is known at the end, unless it counts back.
    #[inline]
    pub(super) fn vertex_index(&mut self, raw: i64, start: usize) -> Result<u32, ReadError> {
        let count = self.parts.positions.len();
        match resolved(raw, count) {
            Some(index) => {
                self.parts.highest.see(index, start);
                Ok(index)
            }
            None if raw == 0 => Err(self.cursor.wrong(start, "vertex index 0: the first vertex is 1")),
            None if raw.saturating_abs() == i64::MAX => {
                Err(self.cursor.wrong(start, "a vertex index beyond 64 bits"))
            }
            None => Err(self.cursor.wrong(start, &no_such_vertex(raw, count))),
        }
    }

    /// The index of a texture coordinate or normal; one that can't exist becomes one that does not.
    pub(super) fn attribute_index(&mut self, raw: i64, count: usize, start: usize) -> u32 {
        resolved(raw, count).unwrap_or_else(|| {
            self.note_out_of_range(1, start);
            NO_VALUE
        })
    }

    pub(super) fn note_out_of_range(&mut self, count: u64, start: usize) {
        let source = self.source;
        let message = "texture or normal indices that do not exist; the corners have no such value";
        self.parts.notes.add_many(NoteKind::AttributeOutOfRange, message, count, || source.line(start));
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
        self.parts.take_faces(&rows.faces, rows.highest);
        self.cursor.at = end;
    }

    fn is_done(&self) -> bool {
        false
    }
}

/// An index from 0 on: positive ones count from 1, negative ones back from the count.
#[inline]
fn resolved(raw: i64, count: usize) -> Option<u32> {
    let index = match raw {
        1.. => raw - 1,
        0 => return None,
        _ => raw + count as i64,
    };
    u32::try_from(index).ok().filter(|&index| index != NO_VALUE)
}
