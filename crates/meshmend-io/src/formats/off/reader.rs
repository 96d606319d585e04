//! What the OFF reader has read so far, and the words of a line.

use meshmend_core::VertexId;

use crate::formats::off::colors::Colors;
use crate::input::assemble::Parts;
use crate::input::source::Source;
use crate::text::{self, is_blank, is_line_end, is_space};
use crate::{Limits, NoteKind, Place, ReadError};

pub(super) struct Reader<'a> {
    pub(super) source: &'a Source<'a>,
    pub(super) bytes: &'a [u8],
    pub(super) limits: &'a Limits,
    pub(super) at: usize,
    pub(super) parts: Parts,
    /// The letters before the word `OFF`.
    pub(super) letters: &'a [u8],
    pub(super) vertex_colors: Colors<'a>,
    pub(super) face_colors: Colors<'a>,
    /// Whether all numbers so far have been used.
    pub(super) is_even: bool,
}

impl<'a> Reader<'a> {
    pub(super) fn new(source: &'a Source<'a>, limits: &'a Limits) -> Self {
        let at = text::text_start(source.bytes);
        Reader {
            source,
            bytes: source.bytes,
            limits,
            at,
            parts: Parts::default(),
            letters: b"",
            vertex_colors: Colors::default(),
            face_colors: Colors::default(),
            is_even: true,
        }
    }

    /// Adds a note at the current place.
    pub(super) fn note(&mut self, kind: NoteKind, message: &str) {
        let (source, at) = (self.source, self.at);
        self.is_even &= !matches!(kind, NoteKind::SurplusColumns | NoteKind::SurplusData);
        self.parts.notes.add(kind, message, || source.line(at));
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

    /// The rest of the line as a colour, without its last two words if those are a texture coordinate.
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
            self.note_surplus("numbers of vertices beyond those of the header were skipped");
        }
        self.end_line();
    }

    /// Skips the rest of a line, with a note.
    pub(super) fn note_surplus(&mut self, message: &str) {
        self.note(NoteKind::SurplusColumns, message);
        self.end_line();
    }

    #[inline]
    pub(super) fn corner(&mut self) -> Result<(), ReadError> {
        self.skip_blanks();
        match text::integer(&self.bytes[self.at..]) {
            Some((index, length)) if self.ends_after(length) => {
                let Ok(vertex) = u32::try_from(index) else {
                    return Err(self.wrong(self.at, &format!("{index} is not the index of a vertex")));
                };
                self.parts.max_index.see(vertex, self.at);
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

    pub(super) fn next_line(&mut self, what: &str) -> Result<(), ReadError> {
        if self.find_line() {
            return Ok(());
        }
        Err(self
            .source
            .malformed(Place::Byte(self.bytes.len() as u64), format!("the file ends where {what} belongs")))
    }

    /// Whether a line begins before this byte. Comments before it are kept. At the end of the text the answer is yes:
    /// the line is missing, which its reader will say.
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

    /// Goes to the next word, also on later lines, and returns whether there is one. Comments are kept.
    #[inline]
    pub(super) fn find_line(&mut self) -> bool {
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

    /// Goes to the end of the line, or to the comment at its end, which is kept later.
    #[inline]
    pub(super) fn end_line(&mut self) {
        self.at += self.rest().len();
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
