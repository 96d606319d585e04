//! What a reader has to say about a file that it accepts.

use std::collections::BTreeMap;
use std::fmt;

use serde::Serialize;

use crate::Place;

/// Something in an accepted file that is not in the mesh, or not as the file has it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Note {
    /// What kind of remark it is.
    pub kind: NoteKind,
    /// How often it applies.
    pub count: u64,
    /// Where it applies first.
    pub first: Place,
    /// What it says, for people; without count and place.
    pub message: String,
}

/// The kinds of remark, with stable names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum NoteKind {
    /// A statement that is not understood was skipped.
    SkippedStatement,
    /// An element or property that is not understood was skipped, or is carried to files of the same format alone.
    SkippedElement,
    /// Content after the end of the data was skipped.
    SurplusData,
    /// Columns beyond those that the format has were skipped.
    SurplusColumns,
    /// A corner names a texture coordinate or normal that does not exist, and has none instead.
    AttributeOutOfRange,
    /// Values of several widths were padded: with zeros, alphas as opaque.
    MixedWidths,
    /// Attributes of loose edges and points were skipped.
    LooseAttribute,
    /// A group, object or material that no face has was skipped.
    UnusedName,
    /// A file that this one names is not there.
    CompanionMissing,
    /// A file that this one names is outside its folder, or is no plain file, and was not opened.
    CompanionOutside,
    /// Comments beyond the limit were skipped.
    SkippedComment,
    /// An end that the format asks for is missing, with nothing cut off.
    MissingEnd,
    /// The name says another format than the content has.
    WrongSuffix,
    /// Rows of a text do not stand on a line each, but come out even.
    WrappedRows,
    /// A header that is not written as its format says, but can be understood.
    OddHeader,
    /// Columns stand in another order than the format says, as their values tell.
    ColumnOrder,
    /// Triangles that lead a strip on to another one are no faces.
    Stitches,
    /// Stored normals of facets point elsewhere than the facets, and are computed afresh where they are written.
    NormalsRecomputed,
    /// Attribute bytes of facets are colours, or may be.
    PerhapsColors,
    /// A coordinate is not a finite number.
    NonFinite,
    /// There is no vertex.
    Empty,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.message)?;
        if self.count > 1 {
            write!(f, " ({} times)", self.count)?;
        }
        match self.first {
            Place::File => Ok(()),
            place if self.count > 1 => write!(f, ", first at {place}"),
            place => write!(f, ", at {place}"),
        }
    }
}

/// How many different messages of one kind are kept; further ones are counted together.
const MOST_MESSAGES: usize = 16;

/// Collects notes; equal ones are counted.
#[derive(Default)]
pub(crate) struct Notes {
    found: BTreeMap<(NoteKind, String), (u64, Place)>,
}

impl Notes {
    /// Adds one remark.
    pub(crate) fn add(&mut self, kind: NoteKind, message: &str, place: impl FnOnce() -> Place) {
        self.add_many(kind, message, 1, place);
    }

    /// Adds a remark that applies `count` times; nothing when that is 0.
    pub(crate) fn add_many(
        &mut self,
        kind: NoteKind,
        message: &str,
        count: u64,
        place: impl FnOnce() -> Place,
    ) {
        if count == 0 {
            return;
        }
        let key = (kind, message.to_owned());
        if let Some((known, _)) = self.found.get_mut(&key) {
            *known += count;
            return;
        }
        let of_kind = self.found.range((kind, String::new())..).take_while(|((k, _), _)| *k == kind).count();
        let key = if of_kind < MOST_MESSAGES { key } else { (kind, "further ones of this kind".to_owned()) };
        self.found.entry(key).or_insert_with(|| (0, place())).0 += count;
    }

    pub(crate) fn into_list(self) -> Vec<Note> {
        let note = |((kind, message), (count, first))| Note { kind, count, first, message };
        self.found.into_iter().map(note).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_note_says_how_often_and_where_first() {
        let shown = |count, first| {
            Note { kind: NoteKind::NonFinite, count, first, message: "odd".to_owned() }.to_string()
        };
        assert_eq!(shown(1, Place::File), "odd");
        assert_eq!(shown(1, Place::Line(4)), "odd, at line 4");
        assert_eq!(shown(2, Place::File), "odd (2 times)");
        assert_eq!(shown(2, Place::Byte(9)), "odd (2 times), first at byte 9");
    }

    #[test]
    fn equal_notes_are_counted_and_messages_beyond_the_most_are_counted_together() {
        let mut notes = Notes::default();
        notes.add_many(NoteKind::Empty, "none", 0, || Place::File);
        for line in 1..=20 {
            notes.add(NoteKind::SkippedStatement, &format!("statement {line:02}"), || Place::Line(line));
            notes.add_many(NoteKind::SurplusColumns, "columns", 3, || Place::Line(line));
        }
        let list = notes.into_list();
        let of = |kind| list.iter().filter(|note| note.kind == kind).collect::<Vec<_>>();
        let statements = of(NoteKind::SkippedStatement);
        assert_eq!(statements.len(), MOST_MESSAGES + 1);
        let further = statements.iter().find(|note| note.message == "further ones of this kind").unwrap();
        assert_eq!((further.count, further.first), (4, Place::Line(17)));
        assert_eq!(of(NoteKind::SurplusColumns)[0].count, 60);
        assert_eq!(of(NoteKind::SurplusColumns)[0].first, Place::Line(1));
        assert!(of(NoteKind::Empty).is_empty());
    }
}
