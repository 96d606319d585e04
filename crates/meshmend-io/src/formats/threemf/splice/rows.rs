//! Rows of a text: where they are, and rows with other values.

use std::ops::Range;

use quick_xml::Reader;
use quick_xml::events::Event;

use crate::formats::threemf::xml::{Attribute, attributes};

/// The rows of some text, and what stands between them.
pub(super) struct Rows<'t> {
    text: &'t str,
    places: Vec<Range<usize>>,
}

/// What stands between two rows if there is no example.
const USUAL_GAP: &str = "\n";

impl<'t> Rows<'t> {
    /// The elements of a text that was read before, each with all that is in it.
    pub(super) fn of(text: &'t str) -> Self {
        let (mut reader, mut places) = (Reader::from_str(text), Vec::new());
        let (mut depth, mut start) = (0_usize, 0);
        loop {
            let from = reader.buffer_position() as usize;
            let event = reader.read_event();
            let end = reader.buffer_position() as usize;
            match event {
                Ok(Event::Empty(_)) if depth == 0 => places.push(from..end),
                Ok(Event::Start(_)) => {
                    start = if depth == 0 { from } else { start };
                    depth += 1;
                }
                Ok(Event::End(_)) => {
                    depth = depth.saturating_sub(1);
                    if depth == 0 {
                        places.push(start..end);
                    }
                }
                Ok(Event::Eof) | Err(_) => return Rows { text, places },
                Ok(_) => {}
            }
        }
    }

    pub(super) fn row(&self, number: u32) -> Option<&'t str> {
        self.places.get(number as usize).map(|place| &self.text[place.clone()])
    }

    /// What stands before a row.
    pub(super) fn gap(&self, number: u32) -> &'t str {
        let number = number as usize;
        let end = self.places.get(number).map_or(self.text.len(), |place| place.start);
        let start =
            number.checked_sub(1).and_then(|before| self.places.get(before)).map_or(0, |place| place.end);
        &self.text[start..end]
    }

    /// What stands behind the last row.
    pub(super) fn rest(&self) -> &'t str {
        &self.text[self.places.last().map_or(self.text.len(), |place| place.end)..]
    }

    /// Blanks as they stand before a row.
    pub(super) fn blank_gap(&self, number: u32) -> &'t str {
        let gap = self.gap(number);
        if gap.trim_ascii().is_empty() { gap } else { USUAL_GAP }
    }

    /// The name that rows have, with a prefix if they have one.
    pub(super) fn name(&self, usual: &'t str) -> &'t str {
        self.row(0).map_or(usual, |row| &row[1..name_end(row)])
    }

    pub(super) fn len(&self) -> usize {
        self.places.len()
    }
}

/// The attributes of the tag that a row begins with.
pub(super) fn attributes_of(row: &str) -> impl Iterator<Item = Attribute<'_>> {
    let known = attributes(row, name_end(row)).map_while(Result::ok);
    known.take_while(|attribute| !attribute.name.starts_with(['/', '>']))
}

/// The value of an attribute of a row.
pub(super) fn value<'r>(row: &'r str, name: &str) -> Option<&'r str> {
    attributes_of(row).find(|attribute| attribute.name == name).map(|attribute| attribute.value)
}

/// A row whose attributes of these names have these values. One that it lacks follows the others.
pub(super) fn with_values(row: &str, values: &[(&str, String)]) -> String {
    let mut changed = String::with_capacity(row.len() + 16);
    let (mut copied, mut end) = (0, name_end(row));
    for attribute in attributes_of(row) {
        end = attribute.whole.end;
        let value = values.iter().find(|(name, _)| *name == attribute.name);
        if let Some((_, value)) = value.filter(|(_, value)| *value != attribute.value) {
            changed.push_str(&row[copied..attribute.place.start]);
            changed.push_str(value);
            copied = attribute.place.end;
        }
    }
    changed.push_str(&row[copied..end]);
    for (name, value) in values.iter().filter(|(name, _)| attributes_of(row).all(|known| known.name != *name))
    {
        changed.push_str(&format!(" {name}=\"{value}\""));
    }
    changed.push_str(&row[end..]);
    changed
}

fn name_end(row: &str) -> usize {
    row.find([' ', '\t', '\n', '\r', '/', '>']).unwrap_or(row.len())
}
