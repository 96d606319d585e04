//! Changes of a JSON text: all that is not changed stays as it is, to the byte.

use std::ops::Range;

use super::quoted;
use super::value::{Child, Value};

/// Pieces of a text that are replaced.
#[derive(Default)]
pub(in crate::formats::gltf) struct Edits {
    list: Vec<(Range<usize>, String)>,
}

impl Edits {
    /// Replaces a piece of the text. Pieces must not overlap.
    pub(in crate::formats::gltf) fn replace(&mut self, piece: Range<usize>, with: impl Into<String>) {
        self.list.push((piece, with.into()));
    }

    /// The text with all changes.
    pub(in crate::formats::gltf) fn applied(mut self, text: &str) -> String {
        self.list.sort_by_key(|(piece, _)| (piece.start, piece.end));
        let grown: usize = self.list.iter().map(|(_, with)| with.len()).sum();
        let mut out = String::with_capacity(text.len() + grown);
        let mut done = 0;
        for (piece, with) in &self.list {
            out.push_str(text.get(done..piece.start).unwrap_or_default());
            out.push_str(with);
            done = done.max(piece.end);
        }
        out.push_str(text.get(done..).unwrap_or_default());
        out
    }
}

/// Changes of an object or an array: members or items that go, come, or have another value.
pub(in crate::formats::gltf) struct ListEdit<'a> {
    value: Value<'a>,
    children: Vec<Child<'a>>,
    is_removed: Vec<bool>,
    changed: Vec<(usize, String)>,
    added: Vec<String>,
}

impl<'a> ListEdit<'a> {
    pub(in crate::formats::gltf) fn of(value: Value<'a>) -> Self {
        let children = value.children();
        let is_removed = vec![false; children.len()];
        ListEdit { value, children, is_removed, changed: Vec::new(), added: Vec::new() }
    }

    /// Gives a member another value, or adds the member.
    pub(in crate::formats::gltf) fn set(&mut self, name: &str, raw: impl Into<String>) {
        match self.children.iter().position(|child| child.name == name) {
            Some(at) => self.changed.push((at, raw.into())),
            None => self.added.push(format!("{}:{}", quoted(name), raw.into())),
        }
    }

    /// Takes a member out, if it is there.
    pub(in crate::formats::gltf) fn remove(&mut self, name: &str) {
        if let Some(at) = self.children.iter().position(|child| child.name == name) {
            self.is_removed[at] = true;
        }
    }

    /// Takes an item out.
    pub(in crate::formats::gltf) fn remove_item(&mut self, at: usize) {
        self.is_removed[at] = true;
    }

    /// Adds an item to an array.
    pub(in crate::formats::gltf) fn push(&mut self, raw: impl Into<String>) {
        self.added.push(raw.into());
    }

    /// Whether nothing would be left.
    pub(in crate::formats::gltf) fn is_emptied(&self) -> bool {
        self.added.is_empty() && self.is_removed.iter().all(|&removed| removed)
    }

    /// Adds the changes to those of the whole text.
    pub(in crate::formats::gltf) fn into_edits(self, edits: &mut Edits) {
        let last_kept = self.is_removed.iter().rposition(|&removed| !removed);
        for (at, child) in self.children.iter().enumerate().filter(|&(at, _)| self.is_removed[at]) {
            // With its comma: the one after it, or the one before it if none that stays follows.
            let is_last_run = last_kept.is_none_or(|kept| at > kept);
            let (start, end) = match (is_last_run, at) {
                (false, _) => (child.start, child.end + 1),
                (true, 0) => (child.start, child.value.range().end),
                (true, _) => (child.start - 1, child.value.range().end),
            };
            edits.replace(start..end, "");
        }
        for (at, raw) in self.changed.into_iter().filter(|&(at, _)| !self.is_removed[at]) {
            edits.replace(self.children[at].value.range(), raw);
        }
        if self.added.is_empty() {
            return;
        }
        let text = self.value.whole_text();
        let lead = self.children.first().map_or("", |child| blanks_at(text, child.start));
        let at = self.children.last().map_or(self.value.range().start + 1, |child| child.value.range().end);
        let mut new = String::new();
        for (count, raw) in self.added.iter().enumerate() {
            new.push_str(if count > 0 || last_kept.is_some() { "," } else { "" });
            new.push_str(lead);
            new.push_str(raw);
        }
        edits.replace(at..at, new);
    }
}

/// The blanks from a place on.
fn blanks_at(text: &str, at: usize) -> &str {
    let rest = text.get(at..).unwrap_or_default();
    &rest[..rest.len() - rest.trim_start().len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Limits;
    use crate::formats::gltf::json::parse;

    fn edited(text: &str, edit: impl FnOnce(&mut ListEdit<'_>)) -> String {
        let mut list = ListEdit::of(parse(text.as_bytes(), &Limits::default()).unwrap());
        edit(&mut list);
        let mut edits = Edits::default();
        list.into_edits(&mut edits);
        edits.applied(text)
    }

    #[test]
    fn members_change_come_and_go_and_all_else_stays() {
        let text = "{\n  \"a\": 1,\n  \"b\": [2],\n  \"c\": 3\n}";
        assert_eq!(edited(text, |_| ()), text);
        assert_eq!(edited(text, |e| e.set("b", "7")), "{\n  \"a\": 1,\n  \"b\": 7,\n  \"c\": 3\n}");
        assert_eq!(edited(text, |e| e.remove("a")), "{\n  \"b\": [2],\n  \"c\": 3\n}");
        assert_eq!(edited(text, |e| e.remove("c")), "{\n  \"a\": 1,\n  \"b\": [2]\n}");
        let both = |e: &mut ListEdit<'_>| ["b", "c", "x"].iter().for_each(|name| e.remove(name));
        assert_eq!(edited(text, both), "{\n  \"a\": 1\n}");
        let added = edited(text, |e| e.set("d", "4"));
        assert_eq!(added, "{\n  \"a\": 1,\n  \"b\": [2],\n  \"c\": 3,\n  \"d\":4\n}");
        let moved = edited(text, |e| {
            ["a", "b", "c"].iter().for_each(|name| e.remove(name));
            e.set("d", "4");
        });
        assert!(parse(moved.as_bytes(), &Limits::default()).is_ok(), "{moved}");
        assert_eq!(edited("{}", |e| e.set("d", "4")), "{\"d\":4}");
    }

    #[test]
    fn items_come_and_go_in_every_combination() {
        for (count, removed, added) in
            (0..4_usize).flat_map(|n| (0..1_u32 << n).flat_map(move |r| [0, 1, 2].map(|a| (n, r, a))))
        {
            let items: Vec<String> = (0..count).map(|item| format!(" {item}")).collect();
            let text = format!("[{} ]", items.join(","));
            let goes = |item: &usize| removed >> item & 1 == 1;
            let new = edited(&text, |e| {
                (0..count).filter(goes).for_each(|item| e.remove_item(item));
                (0..added).for_each(|item| e.push(format!("{}", 10 + item)));
                assert_eq!(e.is_emptied(), added == 0 && (0..count).all(|item| goes(&item)));
            });
            let value = parse(new.as_bytes(), &Limits::default()).unwrap_or_else(|_| panic!("{new}"));
            let found: Vec<u64> =
                value.items().unwrap().iter().map(|item| item.as_count().unwrap()).collect();
            let kept = (0..count).filter(|item| !goes(item)).map(|item| item as u64);
            let expected: Vec<u64> = kept.chain((0..added).map(|item| 10 + item)).collect();
            assert_eq!(found, expected, "{text} -> {new}");
        }
    }
}
