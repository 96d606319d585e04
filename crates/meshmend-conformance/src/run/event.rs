//! What a run tells, line by line, to the process that began it.

use serde::{Deserialize, Serialize};

use crate::laws::Breach;

/// What is to be done in a run.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Job {
    pub(crate) effort: crate::Effort,
    /// Milliseconds for a law on a mesh.
    pub(crate) patience: u64,
    /// Whether the size is measured; else all other laws are asked.
    pub(crate) is_of_size: bool,
    /// The laws, by number, that are not asked any more.
    pub(crate) shut: Vec<u32>,
    /// The questions, by number, that are not asked any more from a mesh on.
    pub(crate) closed: Vec<(u8, u32)>,
    /// The first mesh.
    pub(crate) from: u32,
    /// Whether each step is written down before it is taken.
    pub(crate) is_recorded: bool,
}

/// What a run tells.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) enum Event {
    /// The run has come to a mesh.
    At(u32),
    /// A law is broken.
    Found(Finding),
    /// The run can't go on, since a question does not come back: of which law, on which mesh, and which question.
    Stuck { law: u32, mesh: u32, query: u8 },
    /// Every mesh so far that breaks a law needs these capabilities; the last one of them breaks this law.
    Needs { capabilities: u8, law: u32, example: Example },
    /// The run is through.
    Done { tried: u32, held: u32 },
}

/// How a law is broken, and on which mesh.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Finding {
    /// The law, by number.
    pub(crate) law: u32,
    pub(crate) manner: Manner,
    pub(crate) example: Example,
    /// What was asked.
    pub(crate) question: String,
    /// What came of it.
    pub(crate) found: String,
    /// What is right, where an answer was wrong.
    pub(crate) expected: Option<String>,
}

/// In which manner a law is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Manner {
    /// By a wrong answer.
    Broken,
    /// By a panic, or by the end of the program.
    Panics,
    /// By an answer that does not come, or takes memory without end.
    Hangs,
}

/// The mesh that breaks a law.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Example {
    pub(crate) faces: Vec<Vec<u32>>,
    pub(crate) vertex_count: usize,
    /// Whether it was made smaller from a random mesh.
    pub(crate) is_shrunk: bool,
    /// What it is called, where it is too large to be shown.
    pub(crate) family: Option<String>,
}

impl Example {
    pub(crate) fn of(soup: &crate::Soup) -> Self {
        Example {
            faces: soup.faces.clone(),
            vertex_count: soup.vertex_count(),
            is_shrunk: false,
            family: None,
        }
    }

    /// Whether it is a mesh that can be shown; not where no mesh is to blame, or it is a large one.
    pub(crate) fn is_mesh(&self) -> bool {
        self.family.is_none() && self.vertex_count + self.faces.len() > 0
    }

    pub(crate) fn of_family(name: String) -> Self {
        Example { family: Some(name), ..Example::default() }
    }
}

impl Finding {
    pub(crate) fn wrong(law: u32, example: Example, breach: Breach) -> Self {
        let Breach { question, found, expected } = breach;
        Finding { law, manner: Manner::Broken, example, question, found, expected: Some(expected) }
    }

    /// What happened, in a sentence.
    pub(crate) fn message(&self) -> String {
        match (&self.manner, &self.expected) {
            (_, Some(expected)) => format!("{} is {} and should be {expected}", self.question, self.found),
            (_, None) => format!("{} {}", self.question, self.found),
        }
    }
}
