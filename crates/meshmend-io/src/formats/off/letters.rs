//! The letters before the word `OFF`, and what they stand for.

/// The columns of vertices after their coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) texcoord: bool,
    pub(super) color: bool,
    pub(super) normal: bool,
}

impl Columns {
    /// The columns that the letters before `OFF` stand for. Letters may come in any order.
    pub(super) fn of_letters(mut letters: &[u8]) -> Option<Columns> {
        let mut columns = Columns::default();
        while !letters.is_empty() {
            let (rest, column) = match letters {
                [b'S', b'T', rest @ ..] => (rest, &mut columns.texcoord),
                [b'C', rest @ ..] => (rest, &mut columns.color),
                [b'N', rest @ ..] => (rest, &mut columns.normal),
                _ => return None,
            };
            if std::mem::replace(column, true) {
                return None;
            }
            letters = rest;
        }
        Some(columns)
    }
}

/// The letters before `OFF` in a word, and the digits that follow it.
pub(super) fn letters_and_count(word: &[u8]) -> Option<(&[u8], &[u8])> {
    let at = word.windows(3).position(|window| window == b"OFF")?;
    let (letters, count) = (&word[..at], &word[at + 3..]);
    count.iter().all(u8::is_ascii_digit).then_some((letters, count))
}
