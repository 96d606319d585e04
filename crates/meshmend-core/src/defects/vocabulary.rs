//! A defect, its kind, and the rule of a kind: a rule may look for defects, each has a kind, and a kind from another
//! crate is its rule.

use super::Element;
use crate::{Differences, PolygonMesh};

/// One thing that is wrong, with its place.
///
/// ```
/// use meshmend_core::{Defect, DefectKind, EdgeId, Element, VertexId};
///
/// let defect = Defect::non_manifold_edge(EdgeId(7), [VertexId(3), VertexId(4)], 3);
/// assert_eq!((defect.kind, defect.count), (DefectKind::NonManifoldEdge, 3));
/// assert_eq!(defect.at.ends(), Some([VertexId(3), VertexId(4)]));
/// assert_eq!(defect.to_string(), "e7 v3-v4 has 3 sides");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Defect {
    /// What kind of thing is wrong.
    pub kind: DefectKind,
    /// Where it is.
    pub at: Element,
    /// The element beside which that one is wrong: the face that it repeats, the vertex at whose place it is.
    pub beside: Option<Element>,
    /// How many there are of what the kind counts, such as sides or corners; 0 where it counts nothing.
    pub count: u32,
    /// What else some kinds tell.
    pub detail: Detail,
}

/// What some kinds of defect tell beside elements and a count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Detail {
    /// Nothing.
    None,
    /// Whether all umbrellas of a vertex are open fans.
    BoundaryOnly(bool),
    /// In what a face differs from the one that it repeats.
    Differs(Differences),
    /// Why a patch was not judged.
    Unjudged(Unjudged),
    /// How faces or vertices lie.
    Lies(Lie),
}

/// How faces or vertices lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Lie {
    /// Two faces pass through one another.
    Through,
    /// Two faces overlap in one plane.
    Overlapping,
    /// An edge of one face lies on the inside of another.
    EdgeFace,
    /// Edges of two faces cross or overlap.
    EdgeEdge,
    /// A corner of one face lies on the inside of another.
    VertexFace,
    /// A corner of one face lies on an edge of another.
    VertexEdge,
    /// A vertex lies on an edge, and one of its own edges runs along that.
    Aligned,
    /// A vertex lies on an edge, and none of its own edges runs along that.
    NotAligned,
    /// A triangle has two corners close to each other.
    Needle,
    /// A triangle has one corner close to the edge between the others.
    Cap,
}

impl Lie {
    /// It in a word or two, as reports have it.
    pub fn name(self) -> &'static str {
        match self {
            Lie::Through => "pass through one another",
            Lie::Overlapping => "overlap in one plane",
            Lie::EdgeFace => "edge-face",
            Lie::EdgeEdge => "edge-edge",
            Lie::VertexFace => "vertex-face",
            Lie::VertexEdge => "vertex-edge",
            Lie::Aligned => "aligned",
            Lie::NotAligned => "not aligned",
            Lie::Needle => "needle",
            Lie::Cap => "cap",
        }
    }
}

/// Why it can't be told which side of a patch is the outer one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Unjudged {
    /// The patch has a boundary.
    Open,
    /// The patch encloses no volume, or none that rounding could not have made.
    NoVolume,
}

macro_rules! kinds {
    ($($file:ident $kind:ident)*) => {
        /// What kind of thing is wrong, without its place.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[allow(missing_docs, reason = "each kind is explained by its rule")]
        #[non_exhaustive]
        pub enum DefectKind {
            $($kind,)*
            /// A kind from another crate, which [`Rules::with`](crate::Rules::with) makes known to a check.
            Own(&'static Rule),
        }
    };
}

registered_kinds!(kinds);

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
    /// What [`Defect::count`] counts, as the key of that number in JSON; `None` if the kind counts nothing.
    pub counts: Option<&'static str>,
    /// The sentence about one item. In it `{at}` stands for the element and `{beside}` for the one beside it,
    /// `{face}`, `{vertex}` and `{ends}` for what the element has of these, `{count}` and `{faces}` for the count,
    /// alone or of faces, and `{detail}` for what else the kind tells.
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
    /// Exact questions about where faces lie, when a check is asked for them.
    ByGeometry,
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
    /// In the record of the pass that left them alone, as the result no longer shows them; then what could be done
    /// about it.
    InRecord {
        /// What could be done, or an empty text.
        hint: &'static str,
    },
}
