//! What a check asks about where the faces lie.

use meshmend_core::DefectKind;
use meshmend_repair::Distance;
use meshmend_spatial::Budget;

/// A question about where the faces of a mesh lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Question {
    /// Which faces cross or touch others, or themselves.
    Crossings,
    /// Which vertices of the boundary lie on edges of it, and which loops of it are holes.
    TJunctions,
    /// Which closed components are inside out, or inside others.
    Nesting,
    /// Which faces are inside of what closed components enclose. What crosses and what is nested is asked with it.
    Internal,
    /// Which faces are too thin.
    Shape,
}

impl Question {
    /// All of them.
    pub const ALL: [Question; 5] =
        [Question::Crossings, Question::TJunctions, Question::Nesting, Question::Internal, Question::Shape];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Question::Crossings => "crossings",
            Question::TJunctions => "t-junctions",
            Question::Nesting => "nesting",
            Question::Internal => "internal",
            Question::Shape => "shape",
        }
    }

    /// The question whose answer has defects of a kind, if that is about where the faces lie.
    pub fn about(kind: DefectKind) -> Option<Self> {
        match kind {
            DefectKind::CrossingFaces
            | DefectKind::CoincidentFaces
            | DefectKind::TouchingFaces
            | DefectKind::SelfCrossingFace => Some(Question::Crossings),
            DefectKind::TJunction => Some(Question::TJunctions),
            DefectKind::InsideOutComponent | DefectKind::SolidWithin | DefectKind::NoVolume => {
                Some(Question::Nesting)
            }
            DefectKind::InternalFace | DefectKind::InternalComponent => Some(Question::Internal),
            DefectKind::ZeroAreaFace | DefectKind::SliverFace => Some(Question::Shape),
            _ => None,
        }
    }
}

/// Some questions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Questions(u8);

impl Questions {
    /// All of them.
    pub fn all() -> Self {
        Question::ALL.into_iter().collect()
    }

    /// Whether a question is among them.
    pub fn contains(self, question: Question) -> bool {
        self.0 & (1 << question as u8) != 0
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }
}

impl FromIterator<Question> for Questions {
    fn from_iter<I: IntoIterator<Item = Question>>(questions: I) -> Self {
        Questions(questions.into_iter().fold(0, |all, question| all | 1 << question as u8))
    }
}

/// What is asked about where the faces lie, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct GeometryOptions {
    /// The questions.
    pub questions: Questions,
    /// From which distance on a vertex is on an edge.
    pub near: Distance,
    /// How many pairs of triangles are compared.
    pub budget: Budget,
    /// From how many times its height on a triangle is too long.
    pub aspect: f64,
    /// How many pairs of faces that cross, touch or coincide are listed, of each.
    pub limit: usize,
}

/// No question; exactly on the edge, the usual budget, an aspect of 1000, and every pair listed.
impl Default for GeometryOptions {
    fn default() -> Self {
        GeometryOptions {
            questions: Questions::default(),
            near: Distance::Exact,
            budget: Budget::Usual,
            aspect: 1000.0,
            limit: usize::MAX,
        }
    }
}

impl GeometryOptions {
    /// All questions.
    pub fn all() -> Self {
        GeometryOptions::default().asking(Questions::all())
    }

    /// These options with these questions.
    #[must_use]
    pub fn asking(self, questions: Questions) -> Self {
        GeometryOptions { questions, ..self }
    }

    /// These options with this distance from which on a vertex is on an edge.
    #[must_use]
    pub fn with_near(self, near: Distance) -> Self {
        GeometryOptions { near, ..self }
    }

    /// These options with this many pairs of triangles to compare.
    #[must_use]
    pub fn with_budget(self, budget: Budget) -> Self {
        GeometryOptions { budget, ..self }
    }

    /// These options with this many pairs listed of each kind.
    #[must_use]
    pub fn with_limit(self, limit: usize) -> Self {
        GeometryOptions { limit, ..self }
    }
}
