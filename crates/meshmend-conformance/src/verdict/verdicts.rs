//! The verdict on each law.

use serde::Serialize;

use crate::Effort;
use crate::laws::{LAWS, Law, number};
use crate::run::{Finding, Manner, Results};
use crate::worlds::World;

/// The verdicts on a kernel.
#[derive(Debug)]
pub struct Verdicts {
    /// The kernel's name.
    pub(crate) kernel: &'static str,
    pub(crate) each: Vec<Verdict>,
    pub(crate) meshes: Meshes,
}

/// The verdict on a law.
#[derive(Debug)]
pub struct Verdict {
    /// The law.
    pub law: &'static Law,
    /// Whether it is kept, and if not, how it is broken.
    pub outcome: Outcome,
    pub(crate) finding: Option<Finding>,
}

/// Whether a law is kept, and if not, how it is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Outcome {
    /// No mesh breaks it.
    Kept,
    /// An answer is wrong.
    Broken,
    /// The kernel panics, or ends the process.
    Panics,
    /// An answer does not come, or takes memory without end.
    Hangs,
}

/// How many meshes were tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) struct Meshes {
    /// How many the kernel holds; `None` where the run did not get through all.
    pub(crate) held: Option<u32>,
    pub(crate) refused: Option<u32>,
    pub(crate) tried: u32,
    /// How many of them are random.
    #[serde(skip)]
    pub(crate) random: u32,
}

impl Verdicts {
    pub(crate) fn of(kernel: &'static str, effort: Effort, is_of_size: bool, mut results: Results) -> Self {
        let asked = |law: &&&'static Law| (law.id == "size") == is_of_size;
        let verdict = |law: &&'static Law| {
            let finding = results.findings.remove(&number(law.id));
            let outcome = finding.as_ref().map_or(Outcome::Kept, |finding| match finding.manner {
                Manner::Broken => Outcome::Broken,
                Manner::Panics => Outcome::Panics,
                Manner::Hangs => Outcome::Hangs,
            });
            Verdict { law, outcome, finding }
        };
        let each = LAWS.iter().filter(asked).map(verdict).collect();
        let (tried, held) = (results.tried, results.held);
        let random = if is_of_size { 0 } else { World::of(effort).random_count() as u32 };
        let meshes = Meshes { held, refused: held.map(|held| tried - held), tried, random };
        Verdicts { kernel, each, meshes }
    }

    /// The verdict on each law, in the order of the laws.
    pub fn each(&self) -> &[Verdict] {
        &self.each
    }

    /// The verdict on a law by its id.
    pub fn on(&self, law: &str) -> Option<&Verdict> {
        self.each.iter().find(|verdict| verdict.law.id == law)
    }

    /// Whether a law is kept; a law that was not asked is not.
    pub fn is_kept(&self, law: &str) -> bool {
        self.on(law).is_some_and(|verdict| verdict.outcome == Outcome::Kept)
    }

    /// Whether every law is kept.
    pub fn are_all_kept(&self) -> bool {
        self.each.iter().all(|verdict| verdict.outcome == Outcome::Kept)
    }
}

impl Verdict {
    /// What was asked, what was answered and what is right, in a sentence; `None` where the law is kept.
    pub fn message(&self) -> Option<String> {
        self.finding.as_ref().map(Finding::message)
    }

    /// The faces of the smallest mesh that breaks the law; `None` where it is kept, and where the mesh is a large one.
    pub fn faces(&self) -> Option<&[Vec<u32>]> {
        let example = &self.finding.as_ref()?.example;
        example.is_mesh().then_some(example.faces.as_slice())
    }
}
