//! Which parts of a file a command is about.

use clap::ValueEnum;
use meshmend::formats::{Document, Part, Placing};

use crate::failure::Failure;

/// How the parts of a file become one mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum PlacingWord {
    /// As the file shows them: moved by the transforms of nodes or build items, once for each time that they are placed
    Scene,
    /// Each once, in its own space
    Parts,
}

impl From<PlacingWord> for Placing {
    fn from(word: PlacingWord) -> Self {
        match word {
            PlacingWord::Scene => Placing::Scene,
            PlacingWord::Parts => Placing::Parts,
        }
    }
}

/// Which parts of a file a command is about.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct PartWords {
    /// Only the part of this name or number, in file order from 0; may be given several times
    #[arg(long = "part", value_name = "NAME")]
    parts: Vec<String>,
}

impl PartWords {
    /// The parts that are asked for, with their numbers; all without a choice.
    ///
    /// # Errors
    /// If a word is neither the name nor the number of a part.
    pub(crate) fn chosen<'a>(&self, document: &'a Document) -> Result<Vec<(usize, &'a Part)>, Failure> {
        if let Some(word) =
            self.parts.iter().find(|word| !document.parts.iter().enumerate().any(|p| is(p, word)))
        {
            return Err(unknown(word, document));
        }
        let is_asked_for =
            |part: &(usize, &Part)| self.parts.is_empty() || self.parts.iter().any(|word| is(*part, word));
        Ok(document.parts.iter().enumerate().filter(is_asked_for).collect())
    }
}

/// Whether a word is the name or the number of a part.
fn is((number, part): (usize, &Part), word: &str) -> bool {
    (!part.name.is_empty() && part.name == word.as_bytes()) || number.to_string() == word
}

fn unknown(word: &str, document: &Document) -> Failure {
    const MOST: usize = 8;
    let names: Vec<String> = document
        .parts
        .iter()
        .enumerate()
        .take(MOST)
        .map(|(number, part)| format!("{number}: {}", part.title()))
        .collect();
    let more = match document.parts.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(", and {more} more"),
    };
    Failure::usage(format!("there is no part `{word}`; the parts are {}{more}", names.join(", ")))
}
