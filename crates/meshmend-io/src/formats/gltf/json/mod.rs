//! JSON as text: values are found and read where they stand, and what is edited is edited in place.
//!
//! A file is never made anew from a tree of values: members that are not understood, the spelling of numbers, the order
//! of members and all blanks stay.

mod edits;
mod object;
mod scan;
mod value;

pub(super) use edits::{Edits, ListEdit};
pub(super) use object::Object;
pub(super) use value::{Value, parse};

/// A text as JSON spells it.
pub(super) fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}
