//! The OFF reader: the header, and the words of a line.

use meshmend_core::VertexId;

use crate::assemble::Parts;
use crate::off::OffShape;
use crate::off::blocks::{read_faces, read_vertices};
use crate::read::{Parsed, Source};
use crate::shell::Shape;
use crate::text::{self, is_blank, is_line_end, is_space};
use crate::{Encoding, Limits, NoteKind, Place, ReadError, Shell};

/// What each vertex has beside its coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) texcoord: bool,
    pub(super) color: bool,
    pub(super) normal: bool,
}

impl Columns {
    /// The columns that a header word stands for; the letters may come in any order.
    pub(super) fn of_header(word: &[u8]) -> Option<Columns> {
        let mut letters = word.strip_suffix(b"OFF")?;
        let mut columns = Columns::default();
        while !letters.is_empty() {
            let (rest, column) = match letters {
                [b'S', b'T', rest @ ..] => (rest, &mut columns.texcoord),
                [b'C', rest @ ..] => (rest, &mut columns.color),
                [b'N', rest @ ..] => (rest, &mut columns.normal),
                _ => return None,
            };
            if std::mem::replace(column, true) {
                return None;
            }
            letters = rest;
        }
        Some(columns)
    }
}

pub(super) fn read(source: &Source<'_>, limits: &Limits) -> Result<Parsed, ReadError> {
    let mut reader = Reader::new(source, limits);
    let columns = reader.header()?;
    let [vertices, faces] = reader.counts()?;
    read_vertices(&mut reader, vertices, columns)?;
    read_faces(&mut reader, faces)?;
    reader.surplus();
    let (mesh, notes) = reader.parts.assemble(source, 0, |at| source.line(at))?;
    let shell = Shell::of_file(Encoding::Ascii, Shape::Off(OffShape));
    Ok(Parsed { mesh, variant: "off", notes, shell })
}

pub(super) struct Reader<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) bytes: &'a [u8],
    pub(super) limits: &'a Limits,
    pub(super) at: usize,
    pub(super) parts: Parts,
}

impl<'a> Reader<'a> {
    fn new(source: &'a Source<'a>, limits: &'a Limits) -> Self {
        let at = text::text_start(source.bytes);
        Reader { source, bytes: source.bytes, limits, at, parts: Parts::default() }
    }

    fn header(&mut self) -> Result<Columns, ReadError> {
        self.next_line("the word `OFF`")?;
        let word = text::word(self.bytes, self.at);
        let word = &word[..word.iter().position(|&b| b == b'#').unwrap_or(word.len())];
        let Some(columns) = Columns::of_header(word) else {
            let is_other = word.ends_with(b"OFF");
            let reason =
                if is_other { "is a variant that is not read" } else { "where the word `OFF` belongs" };
            return Err(self.wrong(self.at, &format!("`{}` {reason}", text::shown(word))));
        };
        self.at += word.len();
        self.skip_blanks();
        if text::word(self.bytes, self.at) == b"BINARY" {
            return Err(self.wrong(self.at, "binary OFF is not read"));
        }
        Ok(columns)
    }

    /// The numbers of vertices and faces, on the header's line or the next; that of edges may be missing.
    fn counts(&mut self) -> Result<[usize; 2], ReadError> {
        if self.line_ended() {
            self.next_line("a line of counts")?;
        }
        let (vertices, faces) = (self.count("vertices")?, self.count("faces")?);
        let at = self.at;
        self.end_line();
        // The shortest vertex takes six bytes, the shortest face two; the last one needs no line end.
        let left = (self.bytes.len() - self.at) as u64;
        if vertices.saturating_mul(6).saturating_add(faces.saturating_mul(2)) > left + 1 {
            let reason =
                format!("{vertices} vertices and {faces} faces are announced, {left} bytes are left");
            return Err(self.wrong(at, &reason));
        }
        self.source.limited("vertices", vertices, self.limits.max_vertices)?;
        self.source.limited("faces", faces, self.limits.max_faces)?;
        Ok([vertices as usize, faces as usize])
    }

    pub(super) fn count(&mut self, what: &str) -> Result<u64, ReadError> {
        self.skip_blanks();
        match text::digits(&self.bytes[self.at..]) {
            Some((count, length)) if self.ends_after(length) => {
                self.at += length;
                Ok(count)
            }
            _ => Err(self.not(&format!("the number of {what}"))),
        }
    }

    /// The rest of the line, apart from its last two words if those are a texture coordinate.
    pub(super) fn color(&mut self, texcoord_follows: bool) -> &'a [u8] {
        let rest = self.rest();
        let last_word = |bytes: &[u8]| {
            let bytes = &bytes[..bytes.iter().rposition(|&b| !is_space(b)).map_or(0, |last| last + 1)];
            bytes.iter().rposition(|&b| is_space(b)).map_or(0, |blank| blank + 1)
        };
        let end = if texcoord_follows { last_word(&rest[..last_word(rest)]) } else { rest.len() };
        self.at += end;
        text::trimmed(&rest[..end])
    }

    pub(super) fn note_surplus_columns(&mut self) {
        self.skip_blanks();
        if !self.line_ended() {
            let (source, at) = (self.source, self.at);
            let message = "numbers of vertices beyond those of the header were skipped";
            self.parts.notes.add(NoteKind::SurplusColumns, message, || source.line(at));
        }
        self.end_line();
    }

    #[inline]
    pub(super) fn corner(&mut self) -> Result<(), ReadError> {
        self.skip_blanks();
        match text::integer(&self.bytes[self.at..]) {
            Some((index, length)) if self.ends_after(length) => {
                let Ok(vertex) = u32::try_from(index) else {
                    return Err(self.wrong(self.at, &format!("{index} is no index of a vertex")));
                };
                self.parts.highest.see(vertex, self.at);
                self.parts.faces.push_corner(VertexId(vertex));
                self.at += length;
                Ok(())
            }
            _ => Err(self.not("the index of a vertex")),
        }
    }

    #[inline]
    pub(super) fn number(&mut self) -> Result<f64, ReadError> {
        self.skip_blanks();
        match text::real::<f64>(&self.bytes[self.at..]) {
            Some((value, length)) if self.ends_after(length) => {
                self.at += length;
                Ok(value)
            }
            _ => Err(self.not("a number")),
        }
    }

    fn surplus(&mut self) {
        while self.find_line() {
            let (source, at) = (self.source, self.at);
            self.parts
                .notes
                .add(NoteKind::SurplusData, "lines after the last face were skipped", || source.line(at));
            self.end_line();
        }
    }

    pub(super) fn next_line(&mut self, what: &str) -> Result<(), ReadError> {
        if self.find_line() {
            return Ok(());
        }
        Err(self
            .source
            .malformed(Place::Byte(self.bytes.len() as u64), format!("the file ends where {what} belongs")))
    }

    /// Whether a line begins before this byte, keeping the comments before it. At the end of the text one does: it is
    /// what comes next, and is missing.
    pub(super) fn line_begins_before(&mut self, end: usize) -> bool {
        while self.at < end {
            match self.bytes.get(self.at) {
                Some(b'#') => self.comment(),
                Some(&byte) if is_space(byte) => self.at += 1,
                _ => return true,
            }
        }
        self.at == self.bytes.len()
    }

    /// Goes to the first word of the next line that has one, keeping comments; says whether there is one.
    #[inline]
    fn find_line(&mut self) -> bool {
        while let Some(&byte) = self.bytes.get(self.at) {
            match byte {
                b'#' => self.comment(),
                byte if is_space(byte) => self.at += 1,
                _ => return true,
            }
        }
        false
    }

    fn comment(&mut self) {
        let (start, end) = (self.at, text::line_end(self.bytes, self.at));
        let (source, bytes) = (self.source, self.bytes);
        let value = text::comment_text(&bytes[start + 1..end]);
        self.parts.keep_statement("comment", value, self.limits, || source.line(start));
        self.at = end;
    }

    /// The rest of the line without its comment.
    pub(super) fn rest(&self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let end = rest.iter().position(|&b| is_line_end(b) || b == b'#').unwrap_or(rest.len());
        &rest[..end]
    }

    /// Goes to the end of the line.
    #[inline]
    pub(super) fn end_line(&mut self) {
        self.at = text::line_end(self.bytes, self.at);
    }

    #[inline]
    pub(super) fn skip_blanks(&mut self) {
        while self.bytes.get(self.at).is_some_and(|&b| is_blank(b)) {
            self.at += 1;
        }
    }

    pub(super) fn line_ended(&self) -> bool {
        self.bytes.get(self.at).is_none_or(|&b| is_line_end(b) || b == b'#')
    }

    #[inline]
    fn ends_after(&self, length: usize) -> bool {
        self.bytes.get(self.at + length).is_none_or(|&b| is_space(b) || b == b'#')
    }

    #[cold]
    fn not(&self, what: &str) -> ReadError {
        if self.line_ended() {
            return self.wrong(self.at, &format!("the line ends where {what} belongs"));
        }
        let found = text::shown(text::word(self.bytes, self.at));
        self.wrong(self.at, &format!("`{found}` where {what} belongs"))
    }

    #[cold]
    pub(super) fn wrong(&self, at: usize, reason: &str) -> ReadError {
        self.source.malformed(self.source.line(at), reason)
    }
}
