//! The statements that name something for all elements after them.

use std::borrow::Cow;

use meshmend_core::{Carry, Domain, Layer, NO_VALUE, Values};

use crate::text::is_blank;

/// A kind of statement that names all elements after it.
pub(super) struct Kind {
    pub(super) statement: &'static [u8],
    pub(super) layer: &'static str,
    /// The word for no name at all.
    pub(super) none: &'static [u8],
}

/// The kinds, in the order in which they are written.
pub(super) const KINDS: [Kind; 4] = [
    Kind { statement: b"o", layer: "object", none: b"" },
    Kind { statement: b"g", layer: "group", none: b"" },
    Kind { statement: b"usemtl", layer: "material", none: b"" },
    Kind { statement: b"s", layer: "smoothing", none: b"off" },
];

/// How many faces, loose edges and loose points there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Elements {
    pub(super) faces: usize,
    pub(super) edges: usize,
    pub(super) points: usize,
}

impl Elements {
    fn of(self, domain: Domain) -> usize {
        match domain {
            Domain::LooseEdge => self.edges,
            Domain::LoosePoint => self.points,
            _ => self.faces,
        }
    }
}

/// The kinds of element that have names.
pub(super) const NAMED: [Domain; 3] = [Domain::Face, Domain::LooseEdge, Domain::LoosePoint];

/// The names of one kind. Each statement begins a run, even if it repeats the name: two consecutive objects of one
/// name are two objects.
#[derive(Default)]
pub(super) struct Runs<'a> {
    runs: Vec<Run<'a>>,
    unused: Unused,
}

/// The elements of one statement. An empty name is no name.
struct Run<'a> {
    name: Cow<'a, [u8]>,
    first: Elements,
    /// Where the statement is.
    at: usize,
}

/// The names that no element has: their number, and the place of the first statement.
#[derive(Clone, Copy, Default)]
pub(super) struct Unused {
    pub(super) count: u64,
    pub(super) first: usize,
}

impl<'a> Runs<'a> {
    /// Begins the run of a statement with these elements.
    pub(super) fn start(&mut self, first: Elements, name: Cow<'a, [u8]>, at: usize) {
        self.end(first);
        self.runs.push(Run { name, first, at });
    }

    /// Forgets the last run if it has no element.
    fn end(&mut self, elements: Elements) {
        if let Some(run) = self.runs.pop_if(|run| run.first == elements).filter(|run| !run.name.is_empty()) {
            let first = if self.unused.count == 0 { run.at } else { self.unused.first };
            self.unused = Unused { count: self.unused.count + 1, first };
        }
    }

    /// The layers of faces and loose elements over one pool of names, and the names that no element has. The pool has
    /// a value for each statement that a writer makes of it: those of faces come first, then those of edges, then
    /// those of points.
    pub(super) fn layers(mut self, kind: &Kind, elements: Elements) -> (Vec<Layer>, Unused) {
        self.end(elements);
        let mut pool: Vec<Vec<u8>> = Vec::new();
        let mut last = None;
        let uses = NAMED.map(|domain| {
            let mut uses = Vec::new();
            let ends = self.runs.iter().skip(1).map(|run| run.first).chain([elements]);
            for (number, (run, end)) in self.runs.iter().zip(ends).enumerate() {
                let (first, end) = (run.first.of(domain), end.of(domain));
                if first == end {
                    continue;
                }
                let is_new = last.replace(number) != Some(number) && !run.name.is_empty();
                pool.extend(is_new.then(|| run.name.to_vec()));
                let value = if run.name.is_empty() { NO_VALUE } else { pool.len() as u32 - 1 };
                uses.resize(first, NO_VALUE);
                uses.resize(end, value);
            }
            uses
        });
        let pool = Layer::direct(kind.layer, Domain::Face, 1, Carry::Copy, Values::Text(pool));
        let layers = NAMED.into_iter().zip(uses).filter_map(|(domain, mut uses)| {
            // Most files have no names: then no table of all elements is made.
            uses.iter().any(|&value| value != NO_VALUE).then(|| {
                uses.resize(elements.of(domain), NO_VALUE);
                pool.over_same_values(kind.layer, domain, Carry::Copy, uses)
            })
        });
        (layers.collect(), self.unused)
    }
}

/// A name as a statement of this kind can spell it: on one line, without blanks at its ends, without a comment.
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
