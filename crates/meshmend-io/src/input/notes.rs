//! Collecting the remarks of a reader.

use std::collections::BTreeMap;

use crate::{Note, NoteKind, Place};

/// How many different messages of one kind are kept. The others are counted together.
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

    /// Adds a remark that applies `count` times, unless that is 0.
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
        assert_eq!((further.count, further.first.clone()), (4, Place::Line(17)));
        assert_eq!(of(NoteKind::SurplusColumns)[0].count, 60);
        assert_eq!(of(NoteKind::SurplusColumns)[0].first, Place::Line(1));
        assert!(of(NoteKind::Empty).is_empty());
    }
}
