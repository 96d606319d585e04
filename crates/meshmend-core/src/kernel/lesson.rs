//! What a kernel says of itself.

use crate::Connectivity;

/// A kernel with a text that teaches it.
pub trait Lesson: Connectivity {
    /// The text, in Markdown: its first line is a title, and a paragraph follows that says in a few sentences what the
    /// structure is. What it stores, what it holds and why, what it costs and where it comes from stands in either of these
    /// or below. It is what `meshmend explain` prints.
    const TEXT: &'static str;
}
