//! What readers of texts share: lines, words and numbers, and rows that are parsed before a reader comes to them.

mod lines;
mod messages;
mod numbers;
pub(crate) mod speculative_parse;
pub(crate) mod usual_line;

pub(crate) use self::lines::{
    after_line_end, comment_text, is_blank, is_line_end, is_space, line_end, line_number, skip_space,
    text_start, trimmed, trimmed_start, without_mark, word, words,
};
pub(crate) use self::messages::{one_or_many, shown};
pub(crate) use self::numbers::{Real, digits, integer, real};
