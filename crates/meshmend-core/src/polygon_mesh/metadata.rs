//! What a file says beside its elements, and where it says it.
//!
//! A statement that stands before an element, such as a comment, has a key that ends in `@` and the element: `comment@f7`
//! stands before face 7.

/// Something a file says beside its elements: a comment, a material library, the name of a solid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Metadata {
    /// What kind of statement it is, such as `comment`, `mtllib` or `solid`; for one that stands before an element, with
    /// that: `comment@f7` stands before face 7, counted from 1.
    pub key: String,
    /// What it says, as bytes: files need not be UTF-8.
    pub value: Vec<u8>,
}

impl Metadata {
    /// What kind of statement it is, wherever it stands: `comment` for the key `comment@f7`.
    pub fn kind(&self) -> &str {
        self.key.split_once('@').map_or(self.key.as_str(), |(kind, _)| kind)
    }

    /// What the statement stands before, if it does not stand for the file as a whole: the sign of a kind of element,
    /// such as `v` or `f`, and the element's number, counted from 0. A number beyond the last element is the end.
    pub fn anchor(&self) -> Option<(&str, usize)> {
        let (_, place) = self.key.split_once('@')?;
        let digits = place.find(|c: char| c.is_ascii_digit())?;
        let number: usize = place[digits..].parse().ok()?;
        Some((&place[..digits], number.checked_sub(1)?))
    }

    /// The statement before another element of the same kind, counted from 0.
    pub(crate) fn moved_to(&self, sign: &str, element: usize) -> Self {
        Metadata { key: format!("{}@{sign}{}", self.kind(), element + 1), value: self.value.clone() }
    }
}
