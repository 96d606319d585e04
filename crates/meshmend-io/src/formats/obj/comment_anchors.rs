//! Comments between elements: each stands before the element whose statement follows it.

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

/// The anchor of comments after the last element.
pub(super) const END: &str = "end";

/// Where the next statement of an element is, if it has been searched.
#[derive(Default)]
pub(super) struct Anchors {
    /// The byte where the search began.
    from: usize,
    next: Option<(usize, Option<usize>)>,
}

impl Anchors {
    /// The kind of the first element whose statement begins at or after a byte.
    ///
    /// *Cost*: each byte of the text is read once in all, if the bytes of calls ascend.
    pub(super) fn after(&mut self, bytes: &[u8], at: usize) -> Option<usize> {
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

/// The place and kind of the next statement of an element after a line end.
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
