//! The one vocabulary of what can be wrong with a mesh.
//!
//! Why a kernel refuses, what a check finds, what a pass mends, requires and promises: all are [`Defect`]s. A defect is
//! data: its kind, the [`Element`] at which it is, another element beside that one, and a count. Each kind is one file
//! here with its [`Rule`], and one row of the registry below. Places, reports, explanations and refusals follow from the
//! element and the rule.

macro_rules! registered_kinds {
    ($with:ident) => {
        $with! {
            degenerate_face DegenerateFace
            non_simple_face NonSimpleFace
            face_with_hole FaceWithHole
            crossing_face CrossingFace
            repeated_corner RepeatedCorner
            duplicate_face DuplicateFace
            opposite_face OppositeFace
            differing_face DifferingFace
            polygon_face PolygonFace
            non_finite_face NonFiniteFace
            boundary_edge BoundaryEdge
            non_manifold_edge NonManifoldEdge
            inconsistent_edge InconsistentEdge
            seam_edge SeamEdge
            coincident_edges CoincidentEdges
            pinched_vertex PinchedVertex
            singular_vertex SingularVertex
            non_finite_vertex NonFiniteVertex
            unreferenced_vertex UnreferencedVertex
            coincident_vertex CoincidentVertex
            loose_edge LooseEdge
            loose_point LoosePoint
            non_orientable_patch NonOrientablePatch
            unjudged_patch UnjudgedPatch
            turned_cavity TurnedCavity
            inside_out_component InsideOutComponent
            solid_within SolidWithin
            no_volume NoVolume
            crossing_faces CrossingFaces
            coincident_faces CoincidentFaces
            touching_faces TouchingFaces
            self_crossing_face SelfCrossingFace
            t_junction TJunction
            internal_face InternalFace
            internal_component InternalComponent
            zero_area_face ZeroAreaFace
            sliver_face SliverFace
            undecided_component UndecidedComponent
            small_component SmallComponent
        }
    };
}

mod defect;
mod element;
mod place;
mod rule;
mod rules;
mod vocabulary;

pub use element::{Element, Strip};
pub use rules::{RuleError, Rules};
pub use vocabulary::{Defect, DefectKind, Defects, Detail, Found, Lie, Listed, Rule, Severity, Unjudged};

use std::fmt;

macro_rules! files {
    ($($file:ident $kind:ident)*) => {
        $(mod $file;)*

        impl DefectKind {
            /// Every kind that meshmend has, in the order in which reports list them.
            pub const ALL: &'static [Self] = &[$(DefectKind::$kind,)*];

            /// All that is said of the kind.
            pub fn rule(self) -> &'static Rule {
                match self {
                    $(DefectKind::$kind => &$file::RULE,)*
                    DefectKind::Own(rule) => rule,
                }
            }
        }
    };
}

registered_kinds!(files);

impl DefectKind {
    /// The stable name in reports and on the command line.
    pub fn code(self) -> &'static str {
        self.rule().code
    }

    /// What it is called in a sentence, in the plural.
    pub fn title(self) -> &'static str {
        self.rule().title
    }

    /// Whether it fails a check.
    pub fn severity(self) -> Severity {
        self.rule().severity
    }

    /// What it is, why it matters, and what mends it.
    pub fn explanation(self) -> &'static str {
        self.rule().explanation
    }

    /// The kind of meshmend's own with a code; [`Rules::kind`] knows others too.
    pub fn from_code(code: &str) -> Option<Self> {
        Rules::builtin().kind(code)
    }
}

impl fmt::Display for DefectKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_unique_and_lead_back() {
        for &kind in DefectKind::ALL {
            assert_eq!(DefectKind::from_code(kind.code()), Some(kind));
            assert!(!kind.explanation().is_empty() && !kind.title().is_empty());
        }
        assert_eq!(DefectKind::from_code("no-such-defect"), None);
    }

    #[test]
    fn a_sentence_has_no_place_holder_that_stands_for_nothing() {
        let known = ["at", "beside", "face", "vertex", "ends", "count", "faces", "detail"];
        for kind in DefectKind::ALL {
            let holders = kind.rule().sentence.split('{').skip(1);
            let mut names = holders.map(|rest| rest.split_once('}').map_or("", |(name, _)| name));
            assert!(names.all(|name| known.contains(&name)), "{kind}");
        }
    }

    #[test]
    fn the_file_of_a_kind_has_the_name_of_its_code() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/defects");
        for kind in DefectKind::ALL {
            let file = format!("{folder}/{}.rs", kind.code().replace('-', "_"));
            assert!(std::path::Path::new(&file).exists(), "{file}");
        }
    }
}
