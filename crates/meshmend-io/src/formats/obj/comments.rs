//! Comments between elements: each stands before the element whose statement follows it, in the file that was read and in
//! the one that is written.

use meshmend_core::{Metadata, PolygonMesh};

use crate::formats::obj::read::Reader;
use crate::output::layers::one_line;
use crate::output::sink::Sink;
use crate::text;

/// The key of comments.
pub(super) const COMMENT: &str = "comment";

/// The statements of elements, in the order in which they are written.
pub(super) const ELEMENTS: [&str; 6] = ["v", "vt", "vn", "f", "l", "p"];

/// The places of these statements among them.
pub(super) const VERTEX: usize = 0;
pub(super) const TEXCOORD: usize = 1;
pub(super) const NORMAL: usize = 2;
pub(super) const FACE: usize = 3;
pub(super) const LINE: usize = 4;
pub(super) const POINT: usize = 5;

/// The sign of comments after the last element.
const END: &str = "end";

/// Where the next statement of an element is, as far as that is known.
#[derive(Default)]
pub(super) struct Anchors {
    /// From which byte on it is the next one.
    from: usize,
    next: Option<(usize, Option<usize>)>,
}

impl Anchors {
    /// Which kind of element has the first statement at or after a byte.
    ///
    /// *Cost*: each byte of the text is looked at once in all, if bytes are asked for in ascending order.
    fn after(&mut self, bytes: &[u8], at: usize) -> Option<usize> {
        match self.next {
            Some((end, kind)) if self.from <= at && at <= end => kind,
            _ => {
                let (end, kind) = next_element(bytes, at);
                (self.from, self.next) = (at, Some((end, kind)));
                kind
            }
        }
    }
}

/// The next statement of an element from a line end on: where, and of which kind.
fn next_element(bytes: &[u8], at: usize) -> (usize, Option<usize>) {
    let mut at = text::skip_space(bytes, at, bytes.len());
    while at < bytes.len() {
        let word = text::word(bytes, at);
        let kind = ELEMENTS.iter().position(|sign| sign.as_bytes() == word);
        if kind.is_some() {
            return (at, kind);
        }
        at = text::skip_space(bytes, text::line_end(bytes, at), bytes.len());
    }
    (bytes.len(), None)
}

impl Reader<'_> {
    /// The key of a comment that ends at a byte: before the first vertex it stands on top.
    pub(super) fn comment_key(&mut self, end: usize) -> String {
        let kind = self.anchors.after(self.cursor.bytes, end);
        let elements = self.elements();
        let counts = [
            self.parts.positions.len(),
            self.texcoords.len(),
            self.normals.len(),
            elements.faces,
            elements.edges,
            elements.points,
        ];
        if counts[0] == 0 {
            return COMMENT.to_owned();
        }
        match kind {
            Some(kind) => format!("{COMMENT}@{}{}", ELEMENTS[kind], counts[kind] + 1),
            None => format!("{COMMENT}@{END}"),
        }
    }
}

/// The comments of a mesh that stand between its elements, each until it is written.
pub(super) struct Between<'a> {
    /// For each kind of element, each comment with its element, descending.
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
            // Those before one element keep their order.
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
