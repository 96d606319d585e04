//! Counts in words, for messages to people.

use std::fmt::Display;

/// A count with the word for what is counted: `1 face`, `2 faces`, `0 vertices`. The word is given as it is said of one; of
/// several words the last is counted.
///
/// ```
/// use meshmend_core::counted;
///
/// assert_eq!(counted(1, "face"), "1 face");
/// assert_eq!(counted(2, "loose edge"), "2 loose edges");
/// assert_eq!(counted(0, "vertex"), "0 vertices");
/// ```
///
/// *Cost*: a short text.
pub fn counted(count: impl Display, one: &str) -> String {
    let count = count.to_string();
    match (count.as_str(), one.strip_suffix("ex"), one.strip_suffix("loss")) {
        ("1", ..) => format!("1 {one}"),
        (_, Some(stem), _) => format!("{count} {stem}ices"),
        (_, _, Some(stem)) => format!("{count} {stem}losses"),
        _ => format!("{count} {one}s"),
    }
}

/// How many there are of something: `there is 1 vertex`, `there are 3 vertices`.
pub(crate) fn there_are(count: usize, one: &str) -> String {
    let are = if count == 1 { "is" } else { "are" };
    format!("there {are} {}", counted(count, one))
}
