//! All that is said of a kind of defect, in one place.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

use super::{Defect, DefectKind};
use crate::PolygonMesh;

/// All that is said of a kind of defect.
///
/// Rules are told apart by their codes.
#[derive(Clone, Copy, Debug)]
pub struct Rule {
    /// The stable name in reports and on the command line.
    pub code: &'static str,
    /// What it is called in a sentence, in the plural.
    pub title: &'static str,
    /// Whether it fails a check.
    pub severity: Severity,
    /// What it is, why it matters, and what mends it.
    pub explanation: &'static str,
    /// Who finds it.
    pub found: Found,
    /// Where its items are listed.
    pub listed: Listed,
    /// What [`Defect::count`] counts, as the key under which it is told; `None` where nothing is counted.
    pub counts: Option<&'static str>,
    /// The sentence about one item. In it `{at}` stands for the element and `{beside}` for the one beside it, `{face}`,
    /// `{vertex}` and `{ends}` for what the element has of these, `{count}` and `{faces}` for the count, alone or of
    /// faces, and `{detail}` for what else the kind tells.
    pub sentence: &'static str,
}

/// Whether a defect fails a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Severity {
    /// Shown, and failing only when named.
    Note,
    /// Wrong: most tools downstream can't be trusted with it.
    Defect,
}

/// Defects of one kind, by ascending id.
pub type Defects<'a> = Box<dyn Iterator<Item = Defect> + 'a>;

/// Who finds the defects of a kind.
#[derive(Clone, Copy)]
#[non_exhaustive]
pub enum Found {
    /// The survey of all faces, edges and vertices that makes the topology report, which keeps them all.
    InSurvey,
    /// A function of the mesh, when a check is asked for them. The elements that it names are the mesh's.
    InMesh(for<'a> fn(&'a PolygonMesh) -> Defects<'a>),
    /// A comparison of all positions, as an exact weld makes it.
    ByWelding,
    /// A pass of a repair, and nobody else.
    ByPass,
}

/// Where the items of a kind are listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Listed {
    /// In every report.
    Unasked,
    /// Nowhere unless asked for: they are what was to be expected, as polygons are.
    OnRequest,
    /// Nowhere unless asked for: items of another kind tell them already, and without those there are none of these.
    AlreadyBy(DefectKind),
    /// In the record of the pass that left them alone, as the result no longer shows them; then what could be done about
    /// it.
    InRecord {
        /// What could be done, or an empty text.
        hint: &'static str,
    },
}

impl fmt::Debug for Found {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Found::InSurvey => "InSurvey",
            Found::InMesh(_) => "InMesh",
            Found::ByWelding => "ByWelding",
            Found::ByPass => "ByPass",
        })
    }
}

impl PartialEq for Rule {
    fn eq(&self, other: &Self) -> bool {
        self.code == other.code
    }
}

impl Eq for Rule {}

impl PartialOrd for Rule {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rule {
    fn cmp(&self, other: &Self) -> Ordering {
        self.code.cmp(other.code)
    }
}

impl Hash for Rule {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.code.hash(state);
    }
}
