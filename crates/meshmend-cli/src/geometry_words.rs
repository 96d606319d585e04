//! The words of a check that ask where the faces lie.

use clap::{Args, ValueEnum};
use meshmend::spatial::Budget;
use meshmend::{DefectKind, Distance, GeometryOptions, Question, Questions};

use crate::failure::Failure;
use crate::words::{self, Welding};

/// What is asked about where the faces lie.
#[derive(Clone, Debug, Args)]
pub(crate) struct GeometryWords {
    /// Ask where the faces lie too, exactly: all of it, or some questions
    #[arg(long, value_enum, value_name = "QUESTION", value_delimiter = ',', num_args = 0.., require_equals = true)]
    geometry: Option<Vec<QuestionWord>>,
    /// From which distance on a vertex of the boundary is on an edge of it: exact, a length, or a percentage of the
    /// bounding box's diagonal
    #[arg(long, value_name = "DISTANCE", value_parser = words::welding, default_value = "exact")]
    near: Welding,
    /// After how many compared pairs of triangles the search for crossings stops; by default 64 a face, and ten million
    #[arg(long, value_name = "N")]
    pair_budget: Option<u64>,
}

/// A question about where the faces lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum QuestionWord {
    /// Which faces cross or touch others
    Crossings,
    /// Which vertices of the boundary lie on edges of it, and which loops of it are holes
    TJunctions,
    /// Which closed components are inside out, or inside others
    Nesting,
    /// Which faces are inside of what closed components enclose; crossings and nesting are asked with it
    Internal,
    /// Which faces are too thin
    Shape,
}

impl From<QuestionWord> for Question {
    fn from(word: QuestionWord) -> Self {
        match word {
            QuestionWord::Crossings => Question::Crossings,
            QuestionWord::TJunctions => Question::TJunctions,
            QuestionWord::Nesting => Question::Nesting,
            QuestionWord::Internal => Question::Internal,
            QuestionWord::Shape => Question::Shape,
        }
    }
}

impl GeometryWords {
    /// What is asked, with what kinds of defect need that are to fail the check; `None` if that is nothing.
    ///
    /// # Errors
    /// If the distance is none.
    pub(crate) fn options(
        &self,
        fail_on: &[DefectKind],
        limit: usize,
    ) -> Result<Option<GeometryOptions>, Failure> {
        let asked = match self.geometry.as_deref() {
            Some([]) => Questions::all(),
            Some(words) => words.iter().map(|&word| word.into()).collect(),
            None => Questions::default(),
        };
        let needed = fail_on.iter().filter_map(|&kind| Question::about(kind));
        let questions: Questions =
            Question::ALL.into_iter().filter(|&question| asked.contains(question)).chain(needed).collect();
        if questions.is_empty() {
            return Ok(None);
        }
        let near = match self.near.view().distance() {
            Some(near @ (Distance::Exact | Distance::Absolute(_) | Distance::Relative(_))) => near,
            _ => return Err(Failure::usage("--near takes exact, a length or a percentage".to_owned())),
        };
        let budget = self.pair_budget.map_or(Budget::Usual, Budget::Tests);
        let options = GeometryOptions::default().asking(questions).with_near(near);
        Ok(Some(options.with_budget(budget).with_limit(limit)))
    }
}
