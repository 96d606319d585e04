//! A law as data, and how it is broken.

use std::fmt;

/// A law of kernels.
#[derive(Debug, PartialEq, Eq)]
pub struct Law {
    /// Its stable name, such as `next-and-prev`.
    pub id: &'static str,
    /// What it demands, in a sentence.
    pub sentence: &'static str,
    /// What rests on it.
    pub why: &'static str,
    /// The usual mistake, where there is one.
    pub often: Option<&'static str>,
}

/// An answer that is not the right one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Breach {
    /// What was asked, such as `next_corner(c1)`.
    pub question: String,
    /// What was answered.
    pub found: String,
    /// What is right.
    pub expected: String,
}

impl fmt::Display for Breach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {} and should be {}", self.question, self.found, self.expected)
    }
}

/// Whether an answer is the right one.
///
/// # Errors
/// Both answers, where they differ.
pub(crate) fn same<T: PartialEq + Answer>(
    question: impl FnOnce() -> String,
    found: &T,
    expected: &T,
) -> Result<(), Breach> {
    if found == expected {
        return Ok(());
    }
    Err(Breach { question: question(), found: found.said(), expected: expected.said() })
}

/// Whether a star has the right answers in the right order.
///
/// # Errors
/// Both stars, where they differ.
pub(crate) fn same_star<T: PartialEq + Answer>(
    question: impl FnOnce() -> String,
    found: impl Iterator<Item = T>,
    expected: &[T],
) -> Result<(), Breach> {
    let mut found = found.peekable();
    let mut right = 0;
    while right < expected.len() && found.next_if(|answer| *answer == expected[right]).is_some() {
        right += 1;
    }
    if right == expected.len() && found.peek().is_none() {
        return Ok(());
    }
    let mut shown: Vec<String> = expected[..right].iter().map(Answer::said).collect();
    let room = (MOST_SHOWN + 1).saturating_sub(right);
    shown.extend(found.take(room).map(|answer| answer.said()));
    let expected: Vec<String> = expected.iter().take(MOST_SHOWN + 1).map(Answer::said).collect();
    Err(Breach { question: question(), found: listed(&shown), expected: listed(&expected) })
}

/// More answers of a star are not shown.
const MOST_SHOWN: usize = 12;

/// The answers of a star in a row, cut after twelve.
fn listed(answers: &[String]) -> String {
    match answers.len() {
        0 => "empty".to_owned(),
        1..=MOST_SHOWN => answers.join(" "),
        _ => format!("{} … (cut after {MOST_SHOWN} answers)", answers[..MOST_SHOWN].join(" ")),
    }
}

/// What a kernel answers, in a word.
pub(crate) trait Answer {
    /// The answer as it is shown.
    fn said(&self) -> String;
}

macro_rules! answers {
    ($($type:ty),*) => {
        $(impl Answer for $type {
            fn said(&self) -> String {
                self.to_string()
            }
        })*
    };
}

answers!(
    meshmend_core::VertexId,
    meshmend_core::EdgeId,
    meshmend_core::FaceId,
    meshmend_core::CornerId,
    meshmend_core::Cell,
    usize,
    bool,
    &str
);

impl<T: Answer> Answer for Option<T> {
    fn said(&self) -> String {
        self.as_ref().map_or_else(|| "None".to_owned(), Answer::said)
    }
}

impl<T: Answer> Answer for [T; 2] {
    fn said(&self) -> String {
        format!("[{}, {}]", self[0].said(), self[1].said())
    }
}

impl Answer for (meshmend_core::CornerId, bool) {
    fn said(&self) -> String {
        format!("{} {}", self.0, if self.1 { "forward" } else { "backward" })
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::CornerId;

    use super::*;

    fn star(found: &[u32], expected: &[u32]) -> Result<(), String> {
        let [found, expected] =
            [found, expected].map(|list| list.iter().copied().map(CornerId).collect::<Vec<_>>());
        same_star(|| "vertex_corners(v0)".to_owned(), found.into_iter(), &expected)
            .map_err(|breach| breach.to_string())
    }

    #[test]
    fn a_star_is_shown_as_it_is_and_cut_after_twelve() {
        assert_eq!(star(&[1, 2], &[1, 2]), Ok(()));
        assert_eq!(star(&[], &[]), Ok(()));
        let wrong = |found: &[u32], expected: &[u32]| star(found, expected).unwrap_err();
        assert_eq!(wrong(&[2, 1], &[1, 2]), "vertex_corners(v0) is c2 c1 and should be c1 c2");
        assert_eq!(wrong(&[1], &[1, 2]), "vertex_corners(v0) is c1 and should be c1 c2");
        assert_eq!(wrong(&[], &[1]), "vertex_corners(v0) is empty and should be c1");
        let endless: Vec<u32> = (0..13).collect();
        let cut = "c0 c1 c2 c3 c4 c5 c6 c7 c8 c9 c10 c11 … (cut after 12 answers)";
        assert_eq!(wrong(&endless, &[0]), format!("vertex_corners(v0) is {cut} and should be c0"));
        assert_eq!(wrong(&[], &endless), format!("vertex_corners(v0) is empty and should be {cut}"));
        assert!(!wrong(&endless[..12], &[0]).contains('…'));
    }
}
