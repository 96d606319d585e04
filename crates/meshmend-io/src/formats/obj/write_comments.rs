//! Writing comments between elements: each before the element that followed it in the input.

use meshmend_core::{Metadata, PolygonMesh};

use crate::formats::obj::comment_anchors::{COMMENT, ELEMENTS};
use crate::output::sink::Sink;
use crate::output::statements::one_line;

/// The comments between the elements of a mesh that are yet to be written.
pub(super) struct Between<'a> {
    /// For each kind of element, the comments with the elements that they precede, in descending order.
    waiting: [Vec<(usize, &'a [u8])>; ELEMENTS.len()],
    last: Vec<&'a [u8]>,
}

impl<'a> Between<'a> {
    pub(super) fn of(mesh: &'a PolygonMesh) -> Self {
        let mut between = Between { waiting: Default::default(), last: Vec::new() };
        for statement in mesh.metadata().iter().filter(|statement| is_between(statement)) {
            let kind =
                statement.anchor().map(|(sign, at)| (ELEMENTS.iter().position(|known| *known == sign), at));
            match kind {
                Some((Some(kind), at)) => between.waiting[kind].push((at, &statement.value)),
                _ => between.last.push(&statement.value),
            }
        }
        for waiting in &mut between.waiting {
            // Comments before the same element keep their order.
            waiting.sort_by_key(|(at, _)| *at);
            waiting.reverse();
        }
        between
    }

    /// Writes the comments that stand before an element.
    #[inline]
    pub(super) fn before(&mut self, kind: usize, element: usize, sink: &mut Sink<'_>) {
        while let Some((_, text)) = self.waiting[kind].pop_if(|(at, _)| *at <= element) {
            comment(text, sink);
        }
    }

    /// Writes the comments after the last element of a kind.
    pub(super) fn after_all(&mut self, kind: usize, sink: &mut Sink<'_>) {
        self.before(kind, usize::MAX, sink);
    }

    /// Writes the comments after the last element.
    pub(super) fn at_end(&mut self, sink: &mut Sink<'_>) {
        self.last.drain(..).for_each(|text| comment(text, sink));
    }
}

/// Whether a comment stands between elements, or after the last one.
pub(super) fn is_between(statement: &Metadata) -> bool {
    statement.kind() == COMMENT && statement.key != COMMENT
}

fn comment(text: &[u8], sink: &mut Sink<'_>) {
    sink.byte(b'#');
    if !text.is_empty() {
        sink.byte(b' ');
    }
    sink.bytes(&one_line(text));
    sink.byte(b'\n');
}
