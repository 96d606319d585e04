//! Which parts of a file a command is about.

use clap::ValueEnum;
use meshmend::files::{FaceNames, PartChoice};
use meshmend::formats::Placing;

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

/// By which names of faces a mesh is taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum ByWord {
    /// The objects of OBJ, or the nodes that a mesh was placed by
    Object,
    /// The groups of OBJ
    Group,
    /// Materials
    Material,
    /// The solids of a text STL
    Solid,
}

impl From<ByWord> for FaceNames {
    fn from(word: ByWord) -> Self {
        match word {
            ByWord::Object => FaceNames::Object,
            ByWord::Group => FaceNames::Group,
            ByWord::Material => FaceNames::Material,
            ByWord::Solid => FaceNames::Solid,
        }
    }
}

/// Which parts of a file a command is about.
#[derive(Clone, Debug, Default, clap::Args)]
pub(crate) struct PartWords {
    /// Only the part of this name or number, in file order from 0; may be given several times
    #[arg(long = "part", value_name = "NAME")]
    parts: Vec<String>,
    /// Take a mesh apart by the names of its faces, each part by itself
    #[arg(long, value_enum, value_name = "WHAT")]
    pub(crate) by: Option<ByWord>,
}

impl PartWords {
    /// The parts that are asked for.
    pub(crate) fn choice(&self) -> PartChoice {
        PartChoice::of(self.parts.clone()).taken_apart_by(self.by.map(FaceNames::from))
    }
}
