//! Which parts of a file a command is about.

use clap::ValueEnum;
use meshmend::PolygonMesh;
use meshmend::formats::{Document, Part, PartSource, PartStatus, Placing};
use meshmend::passes::NamedPart;

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

impl ByWord {
    /// The layer that has the names.
    pub(crate) fn layer(self) -> &'static str {
        match self {
            ByWord::Object | ByWord::Solid => "object",
            ByWord::Group => "group",
            ByWord::Material => "material",
        }
    }

    /// What each part is called.
    fn name(self) -> &'static str {
        match self {
            ByWord::Solid => "solid",
            _ => self.layer(),
        }
    }

    /// A file of one mesh with these parts of it in its place.
    pub(crate) fn document<'a>(
        self,
        document: Document,
        parts: impl Iterator<Item = &'a NamedPart>,
    ) -> Document {
        let part = |named: &NamedPart| Part {
            name: named.name.clone(),
            source: PartSource::Named { layer: self.name().to_owned() },
            mesh: named.mesh.clone(),
            status: PartStatus::Editable,
        };
        document.with_parts(parts.map(part).collect())
    }

    /// The failure when faces have no names of this kind.
    pub(crate) fn no_names(self, file: &str) -> Failure {
        Failure::usage(format!("{file}: its faces have no {} to take it apart by", self.name()))
    }

    /// The mesh of a file of one mesh.
    ///
    /// # Errors
    /// If the file has parts of its own.
    pub(crate) fn mesh(self, document: &Document, file: &str) -> Result<PolygonMesh, Failure> {
        match &document.parts[..] {
            [part] if document.is_whole() => Ok(part.mesh.clone()),
            _ => Err(Failure::usage(format!(
                "{file}: the file has parts of its own; --by takes one mesh apart"
            ))),
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
    /// The numbers of the parts that are asked for, ascending; all without a choice.
    ///
    /// # Errors
    /// If a word is neither the name nor the number of a part.
    pub(crate) fn chosen(&self, document: &Document) -> Result<Vec<usize>, Failure> {
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
