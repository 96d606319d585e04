//! The start of an OFF file: the word with its letters, and the counts.

use meshmend_core::counted;

use crate::formats::off::read::Reader;
use crate::text::{self, one_or_many};
use crate::{NoteKind, ReadError};

/// What each vertex has beside its coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) texcoord: bool,
    pub(super) color: bool,
    pub(super) normal: bool,
}

impl Columns {
    /// The columns that the letters before `OFF` stand for; they may come in any order.
    fn of_letters(mut letters: &[u8]) -> Option<Columns> {
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

/// Whether a text surely is OFF: it begins with the word, and two numbers or `BINARY` follow.
pub(super) fn sniff<'a>(bytes: &'a [u8]) -> bool {
    let bytes = &bytes[text::text_start(bytes)..];
    let without_comment = |line: &'a [u8]| line.split(|&b| b == b'#').next().unwrap_or_default();
    let mut words = bytes.split(|&b| text::is_line_end(b)).map(without_comment).flat_map(text::words);
    let Some((letters, mut glued)) = words.next().and_then(letters_and_count) else { return false };
    let is_count = |word: &[u8]| text::digits(word).is_some_and(|(_, length)| length == word.len());
    let mut next = || match std::mem::take(&mut glued) {
        [] => words.next().unwrap_or_default(),
        count => count,
    };
    let first = next();
    is_known(letters) && (first == b"BINARY" || (is_count(first) && is_count(next())))
}

fn is_known(letters: &[u8]) -> bool {
    Columns::of_letters(letters).is_some()
}

/// The letters before `OFF` in a word, and the number that is glued to it.
fn letters_and_count(word: &[u8]) -> Option<(&[u8], &[u8])> {
    let at = word.windows(3).position(|window| window == b"OFF")?;
    let (letters, count) = (&word[..at], &word[at + 3..]);
    count.iter().all(u8::is_ascii_digit).then_some((letters, count))
}

impl<'a> Reader<'a> {
    /// Reads the word, if there is one, and says which columns its letters stand for.
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

    /// The numbers of vertices and faces, each on the header's line or the next one; that of edges may be missing.
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

    /// Passes over a number of edges with a line of its own, which no vertex is.
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

    /// An error unless so many vertices and faces can be there, and are within the limits.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_is_surely_off_when_numbers_follow_the_word() {
        for text in
            ["OFF\n3 1 0", "OFF3 1", "# c\n CNOFF # d\n\n8\n9", "OFF BINARY", "STOFF 1 2", "\u{feff}OFF 1 2"]
        {
            assert!(sniff(text.as_bytes()), "{text}");
        }
        for text in [
            "",
            "OFF",
            "OFF 3",
            "OFF is a format",
            "OFFER 3 1 0",
            "XOFF 3 1 0",
            "3 1 0",
            "SOFF 3 1",
            "OFF3x 1",
        ] {
            assert!(!sniff(text.as_bytes()), "{text}");
        }
    }
}
