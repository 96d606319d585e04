//! The statements that name something for all faces after them.

use std::borrow::Cow;
use std::collections::BTreeMap;

use meshmend_core::{Carry, Domain, Layer, NO_VALUE, Values};

use crate::text::is_blank;

/// A kind of such statement.
pub(super) struct Kind {
    pub(super) statement: &'static [u8],
    pub(super) layer: &'static str,
    /// What stands for no name at all.
    pub(super) none: &'static [u8],
}

/// The kinds, in the order in which they are written.
pub(super) const KINDS: [Kind; 4] = [
    Kind { statement: b"o", layer: "object", none: b"" },
    Kind { statement: b"g", layer: "group", none: b"" },
    Kind { statement: b"usemtl", layer: "material", none: b"" },
    Kind { statement: b"s", layer: "smoothing", none: b"off" },
];

/// The names of one kind: each holds from a face on.
#[derive(Default)]
pub(super) struct Runs<'a> {
    runs: Vec<(usize, Cow<'a, [u8]>)>,
    /// How many names no face has, and where the statement is that replaces the first of them.
    unused: Option<(u64, usize)>,
}

impl<'a> Runs<'a> {
    /// From this face on the name holds that a statement says.
    pub(super) fn start(&mut self, face: usize, name: Cow<'a, [u8]>, at: usize) {
        if self.runs.pop_if(|(first, _)| *first == face).is_some_and(|(_, old)| !old.is_empty()) {
            self.unused.get_or_insert((0, at)).0 += 1;
        }
        self.runs.push((face, name));
    }

    /// How many names no face has, and where the statement is that replaces the first of them.
    pub(super) fn unused(&self) -> Option<(u64, usize)> {
        self.unused
    }

    /// The face layer, or nothing when no face has a name.
    pub(super) fn layer(mut self, kind: &Kind, faces: usize) -> Option<Layer> {
        self.runs.retain(|(first, _)| *first < faces);
        let is_none = |name: &[u8]| name == kind.none || name.is_empty();
        if self.runs.iter().all(|(_, name)| is_none(name)) {
            return None;
        }
        let mut pool: Vec<Vec<u8>> = Vec::new();
        let mut known: BTreeMap<&[u8], u32> = BTreeMap::new();
        let mut uses = vec![NO_VALUE; faces];
        let ends = self.runs.iter().skip(1).map(|(first, _)| *first).chain([faces]);
        for ((first, name), end) in self.runs.iter().zip(ends) {
            if is_none(name) {
                continue;
            }
            let value = *known.entry(name).or_insert_with(|| {
                pool.push(name.to_vec());
                pool.len() as u32 - 1
            });
            uses[*first..end].fill(value);
        }
        Some(Layer::indexed(kind.layer, Domain::Face, 1, Carry::Copy, Values::Text(pool), uses))
    }
}

/// A name as a statement of this kind can say it: one line, no blank at its ends, no comment.
pub(super) fn spelled<'a>(kind: &Kind, name: &'a [u8]) -> Cow<'a, [u8]> {
    let ends_well = |end: Option<&u8>| end.is_some_and(|&b| !is_blank(b) && b != b'\\');
    let starts_well = name.first().is_some_and(|&b| !is_blank(b) && b != b'#');
    let is_comment = |pair: &[u8]| is_blank(pair[0]) && pair[1] == b'#';
    let fits = starts_well
        && ends_well(name.last())
        && !name.iter().any(|b| matches!(b, b'\n' | b'\r' | 0))
        && !name.windows(2).any(is_comment)
        && name != kind.none;
    if fits {
        return Cow::Borrowed(name);
    }
    let safe = |&b: &u8| if matches!(b, b'\n' | b'\r' | 0 | b'#' | b'\\') || is_blank(b) { b'_' } else { b };
    let mut spelled: Vec<u8> = name.iter().map(safe).collect();
    if spelled == kind.none || spelled.is_empty() {
        spelled.push(b'_');
    }
    Cow::Owned(spelled)
}
