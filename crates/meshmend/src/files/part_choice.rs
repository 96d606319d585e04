//! Which parts of a file are worked on.

use meshmend_io::{Document, Part};
use thiserror::Error;

use super::FaceNames;

/// Which parts of a file are worked on; by default all that it has of its own.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct PartChoice {
    /// The names or numbers of parts, in file order from 0; all parts without one.
    pub parts: Vec<String>,
    /// The names of faces by which a mesh is taken apart, if it is.
    pub by: Option<FaceNames>,
}

/// A word is neither the name nor the number of a part.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("there is no part `{word}`; the parts are {parts}")]
pub struct NoSuchPart {
    /// The word.
    pub word: String,
    /// The parts that there are: the first of them, and how many more.
    pub parts: String,
}

impl PartChoice {
    /// The choice of these parts, by their names or numbers.
    pub fn of(parts: Vec<String>) -> Self {
        PartChoice { parts, by: None }
    }

    /// This choice, of the parts that the names of faces make.
    #[must_use]
    pub fn taken_apart_by(self, names: impl Into<Option<FaceNames>>) -> Self {
        PartChoice { by: names.into(), ..self }
    }

    /// The numbers of the parts that are chosen, ascending.
    ///
    /// # Errors
    /// If a word is neither the name nor the number of a part.
    pub fn chosen(&self, document: &Document) -> Result<Vec<usize>, NoSuchPart> {
        let all = || document.parts.iter().enumerate();
        if let Some(word) = self.parts.iter().find(|word| !all().any(|part| is(part, word))) {
            return Err(unknown(word, document));
        }
        let is_asked_for =
            |part: &(usize, &Part)| self.parts.is_empty() || self.parts.iter().any(|word| is(*part, word));
        Ok(all().filter(is_asked_for).map(|(number, _)| number).collect())
    }
}

/// Whether a word is the name or the number of a part.
fn is((number, part): (usize, &Part), word: &str) -> bool {
    (!part.name.is_empty() && part.name == word.as_bytes()) || number.to_string() == word
}

fn unknown(word: &str, document: &Document) -> NoSuchPart {
    const MOST: usize = 8;
    let parts = document.parts.iter().enumerate().take(MOST);
    let names: Vec<String> = parts.map(|(number, part)| format!("{number}: {}", part.title())).collect();
    let more = match document.parts.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(", and {more} more"),
    };
    NoSuchPart { word: word.to_owned(), parts: format!("{}{more}", names.join(", ")) }
}
