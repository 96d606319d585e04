//! Reading the start of an OFF file: the word with its letters, and the counts.

use meshmend_core::counted;

use crate::formats::off::letters::{Columns, letters_and_count};
use crate::formats::off::reader::Reader;
use crate::text::{self, one_or_many};
use crate::{NoteKind, ReadError};

impl<'a> Reader<'a> {
    /// Reads the word, if there is one, and returns the columns that its letters stand for.
    pub(super) fn header(&mut self) -> Result<Columns, ReadError> {
        self.next_line("the word `OFF`")?;
        let word = self.word();
        if !word.is_empty() && word.iter().all(u8::is_ascii_digit) {
            self.note(NoteKind::OddHeader, "the word `OFF` is missing");
            return Ok(Columns::default());
        }
        if word == b"off" {
            self.note(NoteKind::OddHeader, "the word `OFF` is in small letters");
            self.at += word.len();
            return Ok(Columns::default());
        }
        let Some((letters, glued)) = letters_and_count(word) else {
            return Err(self.wrong(self.at, &format!("`{}` where the word `OFF` belongs", text::shown(word))));
        };
        let Some(columns) = Columns::of_letters(letters) else {
            let name = text::shown(&word[..letters.len() + 3]);
            return Err(self.wrong(self.at, &format!("`{name}` is a variant that is not read")));
        };
        if !glued.is_empty() {
            self.note(NoteKind::OddHeader, "the number of vertices is glued to the word `OFF`");
        }
        self.at += letters.len() + 3;
        self.letters = letters;
        self.skip_blanks();
        if self.word() == b"BINARY" {
            return Err(self.wrong(self.at, "binary OFF is not read"));
        }
        Ok(columns)
    }

    /// The numbers of vertices and faces, on the line of the word or on later ones. The number of edges may be
    /// missing.
    pub(super) fn counts(&mut self) -> Result<[usize; 2], ReadError> {
        let vertices = self.count_in_lines("vertices")?;
        let faces = self.count_in_lines("faces")?;
        let at = self.at;
        self.skip_blanks();
        if self.line_ended() {
            self.edge_count_of_next_line(vertices);
        } else {
            self.at += self.word().len();
        }
        self.check_counts(vertices, faces, at)
    }

    fn count_in_lines(&mut self, what: &str) -> Result<u64, ReadError> {
        self.skip_blanks();
        if self.line_ended() {
            self.next_line(&format!("the number of {what}"))?;
        }
        self.count(what)
    }

    /// Skips a number of edges on a line of its own. A single number can't be a vertex.
    fn edge_count_of_next_line(&mut self, vertices: u64) {
        if vertices == 0 || !self.find_line() {
            return;
        }
        let line = self.rest();
        let is_count =
            text::digits(line).is_some_and(|(_, length)| text::trimmed(&line[length..]).is_empty());
        if is_count {
            self.at += self.word().len();
        }
    }

    /// An error if the file is too short for so many vertices and faces, or they exceed the limits.
    fn check_counts(&self, vertices: u64, faces: u64, at: usize) -> Result<[usize; 2], ReadError> {
        // The shortest vertex takes six bytes, the shortest face two; the last one needs no line end.
        let left = (self.bytes.len() - self.at) as u64;
        if vertices.saturating_mul(6).saturating_add(faces.saturating_mul(2)) > left + 1 {
            let (vertices, faces) = (counted(vertices, "vertex"), counted(faces, "face"));
            let left = one_or_many(left, "byte is", "bytes are");
            let reason = format!("{vertices} and {faces} are announced, {left} left");
            return Err(self.wrong(at, &reason));
        }
        self.source.limited("vertices", vertices, self.limits.max_vertices)?;
        self.source.limited("faces", faces, self.limits.max_faces)?;
        Ok([vertices as usize, faces as usize])
    }

    /// The word that begins here, up to a comment.
    fn word(&self) -> &'a [u8] {
        let word = text::word(self.bytes, self.at);
        &word[..word.iter().position(|&b| b == b'#').unwrap_or(word.len())]
    }
}
