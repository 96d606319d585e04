//! The one vocabulary of what can be wrong with a mesh.
//!
//! Why a kernel refuses, what a check finds, what a pass mends, requires and promises: all are [`Defect`]s, and
//! each has a [`DefectKind`] with a stable code, a severity and an explanation.

use std::fmt;

use serde::Serialize;

use crate::{Differences, EdgeId, FaceId, VertexId};

/// One thing that is wrong, with its place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(tag = "kind", rename_all = "kebab-case")]
#[allow(
    missing_docs,
    reason = "the fields are ids named after what they identify; the variants are explained"
)]
pub enum Defect {
    /// A face with fewer than three different vertices.
    DegenerateFace { face: FaceId },
    /// A face that comes back to a vertex.
    NonSimpleFace { face: FaceId, vertex: VertexId },
    /// A face that comes back to a vertex round a hole, so that splitting it there would fill the hole.
    FaceWithHole { face: FaceId, vertex: VertexId },
    /// A face that has a hole by the way its parts turn, but crosses itself.
    CrossingFace { face: FaceId, vertex: VertexId },
    /// A face that lists a vertex twice in a row, or walks to a vertex and straight back.
    RepeatedCorner { face: FaceId, vertex: VertexId },
    /// A face whose directed cycle of vertices an earlier face has too.
    DuplicateFace { face: FaceId, original: FaceId },
    /// A face whose cycle an earlier face runs the other way round, and none the same way.
    OppositeFace { face: FaceId, original: FaceId },
    /// A face whose directed cycle an earlier face has too, but which looks otherwise or belongs elsewhere.
    DifferingFace { face: FaceId, original: FaceId, differs: Differences },
    /// A face with more than three corners.
    PolygonFace { face: FaceId, corners: u32 },
    /// A face with a corner whose position is not finite.
    NonFiniteFace { face: FaceId, vertex: VertexId },
    /// An edge with one side.
    BoundaryEdge { edge: EdgeId, ends: [VertexId; 2] },
    /// An edge with three sides or more.
    NonManifoldEdge { edge: EdgeId, ends: [VertexId; 2], degree: u32 },
    /// An edge with two sides that run the same way.
    InconsistentEdge { edge: EdgeId, ends: [VertexId; 2] },
    /// An edge of the seam along which a non-orientable patch is cut.
    SeamEdge { edge: EdgeId, ends: [VertexId; 2] },
    /// Two vertices that several edges would join, if faces were only told apart by index.
    CoincidentEdges { ends: [VertexId; 2] },
    /// A vertex at which two or more umbrellas meet, all edges there having one side or two.
    PinchedVertex { vertex: VertexId, umbrellas: u32, boundary_only: bool },
    /// A vertex at an edge with three sides or more.
    SingularVertex { vertex: VertexId },
    /// A vertex with a coordinate that is infinite or no number.
    NonFiniteVertex { vertex: VertexId },
    /// A vertex in no face of the complex.
    UnreferencedVertex { vertex: VertexId },
    /// A vertex at the position of an earlier one.
    CoincidentVertex { vertex: VertexId, original: VertexId },
    /// An edge that is no face's side, by its place in the list of loose edges.
    LooseEdge { index: u32, ends: [VertexId; 2] },
    /// A point that is an element of its own, by its place in the list of loose points.
    LoosePoint { index: u32, vertex: VertexId },
    /// A patch that has no consistent side: a closed strip of faces reverses orientation.
    NonOrientablePatch { faces: Vec<FaceId>, edges: Vec<EdgeId> },
    /// A patch of so many faces, by its lowest face, of which it can't be told which side is the outer one.
    UnjudgedPatch { face: FaceId, faces: u32, reason: Unjudged },
    /// A closed patch of so many faces, by its lowest face, that was turned outward although it lies inside another.
    TurnedCavity { face: FaceId, faces: u32 },
}

/// Why it can't be told which side of a patch is the outer one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Unjudged {
    /// The patch has a boundary.
    Open,
    /// The patch encloses no volume, or none that rounding could not have made.
    NoVolume,
}

/// Whether a defect fails a check.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// Shown, and failing only when named.
    Note,
    /// Wrong: most tools downstream can't be trusted with it.
    Defect,
}

macro_rules! kinds {
    ($($variant:ident $code:literal $severity:ident $title:literal $explanation:literal)*) => {
        /// What kind of thing is wrong, without its place.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
        #[serde(rename_all = "kebab-case")]
        #[allow(missing_docs, reason = "named after the variants of Defect, which are explained there")]
        pub enum DefectKind { $($variant,)* }

        impl DefectKind {
            /// Every kind, in the order in which reports list them.
            pub const ALL: &'static [Self] = &[$(DefectKind::$variant,)*];

            /// The stable name in reports and on the command line.
            pub fn code(self) -> &'static str {
                match self { $(DefectKind::$variant => $code,)* }
            }

            /// What it is called in a sentence, in the plural.
            pub fn title(self) -> &'static str {
                match self { $(DefectKind::$variant => $title,)* }
            }

            /// Whether it fails a check.
            pub fn severity(self) -> Severity {
                match self { $(DefectKind::$variant => Severity::$severity,)* }
            }

            /// What it is, why it matters, and what mends it.
            pub fn explanation(self) -> &'static str {
                match self { $(DefectKind::$variant => $explanation,)* }
            }
        }

        impl Defect {
            /// What kind of defect this is.
            pub fn kind(&self) -> DefectKind {
                match self { $(Defect::$variant { .. } => DefectKind::$variant,)* }
            }
        }
    };
}

kinds! {
    DegenerateFace "degenerate-face" Defect "degenerate faces"
        "Fewer than three different vertices are left when consecutive repeats are dropped, so the face bounds \
         nothing. It takes no part in the complex that is analysed. `clean` removes it and names it."
    NonSimpleFace "non-simple-face" Defect "non-simple faces"
        "The face has three or more different vertices but comes back to one of them: its rim touches itself. \
         Most data structures can't hold it. `clean` splits it into simple faces at the repeated vertex, or, if it \
         has a hole, cuts it along diagonals."
    FaceWithHole "face-with-hole" Defect "faces with holes"
        "The face comes back to a vertex round a hole: a part of it turns against the whole, as where a bridge leads \
         from the rim to a hole and back. Splitting it at the vertex would fill the hole, so `clean` cuts it along \
         diagonals between its own corners."
    CrossingFace "crossing-face" Defect "faces that cross themselves"
        "The face comes back to a vertex, and a part of it turns against the whole as round a hole, but it crosses \
         itself so that no diagonals cut it into simple faces. `clean` splits it at the repeated vertex."
    RepeatedCorner "repeated-corner" Note "faces with repeated corners or spikes"
        "The face lists a vertex twice in a row (a a b c), or walks to a vertex and straight back (a b a c). The \
         extra corners bound nothing; `clean` drops them and keeps the face."
    DuplicateFace "duplicate-face" Defect "duplicate faces"
        "An earlier face has the same directed cycle of vertices. Both count as faces, so every edge of theirs \
         tends to become non-manifold. `clean` drops repeats as stored; `orient` drops a patch each of whose \
         faces is doubled in another patch."
    OppositeFace "opposite-face" Note "opposite duplicate faces"
        "An earlier face has the same cycle the other way round: a double-sided wall. It is kept unless \
         `--duplicates` says `remove-pair` or `keep-first`."
    DifferingFace "differing-face" Note "repeated faces that differ"
        "An earlier face has the same directed cycle of vertices, but another material, object, group, solid, part \
         or colour, or other texture coordinates: a decal, or a second object over the same vertices. Such faces \
         are kept, and `split` takes them apart. `--repeated drop` keeps the first alone."
    PolygonFace "polygon-face" Note "faces with more than three corners"
        "Only a kernel for triangles minds. `triangulate` with `all` cuts polygons into triangles."
    NonFiniteFace "non-finite-face" Defect "faces with non-finite corners"
        "A corner's position is infinite or no number, so the face has no shape. `clean` drops it unless \
         `--non-finite` says `keep` or `fail`."
    BoundaryEdge "boundary-edge" Note "boundary edges"
        "One face side runs along the edge: the surface is open there. meshmend does not fill holes unasked."
    NonManifoldEdge "non-manifold-edge" Defect "non-manifold edges"
        "Three or more face sides run along the edge, so the surface branches. `split` pairs the sides into \
         sheets and gives each sheet its own edge; no face is deleted."
    InconsistentEdge "inconsistent-edge" Defect "inconsistently oriented edges"
        "Both face sides run the same way along the edge, so one of the two faces looks to the other side. \
         `orient` flips whole patches' minorities until none is left, where the patch is orientable."
    SeamEdge "seam-edge" Defect "seam edges"
        "A non-orientable patch is cut open along these edges when `--non-orientable cut` asks for it: what is \
         left can be oriented."
    CoincidentEdges "coincident-edges" Defect "edges that would coincide"
        "Two different edges of the result join the same two vertices, the surface being connected elsewhere. By \
         index they would be one edge again, so `split` gives each of them a vertex of its own."
    PinchedVertex "pinched-vertex" Defect "pinched vertices"
        "Two or more umbrellas of faces meet in the vertex alone, like two cones tip to tip. If all of them are \
         open fans it becomes manifold when the holes are closed (`boundary_only`). `split` gives each umbrella \
         its own vertex."
    SingularVertex "singular-vertex" Defect "singular vertices"
        "An edge with three sides or more ends here. `split` mends it together with the edge."
    NonFiniteVertex "non-finite-vertex" Defect "non-finite vertices"
        "A coordinate is infinite or no number. Faces that use the vertex are dropped by `clean`, unless \
         `--non-finite` says otherwise, and then `compact` removes the vertex."
    UnreferencedVertex "unreferenced-vertex" Note "unreferenced vertices"
        "No face of the complex uses the vertex. It is not counted in V or in any figure. `compact` removes it."
    CoincidentVertex "coincident-vertex" Note "vertices that exact welding would join"
        "An earlier vertex has the same position. Files without shared vertices (STL) have them all over; where \
         they hold a surface together they are stitched by `weld`, and where they keep it manifold they stay."
    LooseEdge "loose-edge" Note "loose edges"
        "An edge that is an element of its own and no face's side. `compact` removes it unless told to keep it."
    LoosePoint "loose-point" Note "loose points"
        "A point that is an element of its own. `compact` removes it unless told to keep it."
    NonOrientablePatch "non-orientable-patch" Defect "non-orientable patches"
        "However its faces are flipped, some edge of the patch stays inconsistent: there is a closed strip of \
         faces that comes back mirrored, as on a Moebius band or a Klein bottle. The strip is the witness. \
         `--non-orientable` says whether to report it, cut it open, or fail."
    UnjudgedPatch "unjudged-patch" Note "patches whose outer side is not known"
        "`--orient outward` turns closed patches so that they enclose a positive volume. A patch that is open, or \
         that encloses no volume, has no outer side; it keeps the side that most of its faces have."
    TurnedCavity "turned-cavity" Note "cavities turned outward"
        "The closed patch lies inside another one and looked inward, as the wall of a hollow does. \
         `--orient outward` turned it all the same. `--orient outward-nested` keeps the walls of hollows."
}

impl DefectKind {
    /// The kind with a code.
    pub fn from_code(code: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|kind| kind.code() == code)
    }
}

impl fmt::Display for DefectKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.code())
    }
}

impl Defect {
    /// The defect with other names for its vertices: those of another numbering of the same mesh.
    pub fn with_vertices(mut self, name: impl Fn(VertexId) -> VertexId) -> Self {
        use Defect as D;
        match &mut self {
            D::NonSimpleFace { vertex, .. }
            | D::FaceWithHole { vertex, .. }
            | D::CrossingFace { vertex, .. }
            | D::RepeatedCorner { vertex, .. }
            | D::NonFiniteFace { vertex, .. }
            | D::PinchedVertex { vertex, .. }
            | D::SingularVertex { vertex }
            | D::NonFiniteVertex { vertex }
            | D::UnreferencedVertex { vertex }
            | D::LoosePoint { vertex, .. } => *vertex = name(*vertex),
            D::BoundaryEdge { ends, .. }
            | D::NonManifoldEdge { ends, .. }
            | D::InconsistentEdge { ends, .. }
            | D::SeamEdge { ends, .. }
            | D::CoincidentEdges { ends }
            | D::LooseEdge { ends, .. } => *ends = ends.map(name),
            D::CoincidentVertex { vertex, original } => {
                (*vertex, *original) = (name(*vertex), name(*original));
            }
            D::DegenerateFace { .. }
            | D::DuplicateFace { .. }
            | D::OppositeFace { .. }
            | D::DifferingFace { .. }
            | D::PolygonFace { .. }
            | D::NonOrientablePatch { .. }
            | D::UnjudgedPatch { .. }
            | D::TurnedCavity { .. } => {}
        }
        self
    }
}

impl fmt::Display for Defect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Defect::DegenerateFace { face } => write!(f, "{face} has fewer than three different vertices"),
            Defect::NonSimpleFace { face, vertex } => write!(f, "{face} comes back to {vertex}"),
            Defect::FaceWithHole { face, vertex } => write!(f, "{face} comes back to {vertex} round a hole"),
            Defect::CrossingFace { face, vertex } => {
                write!(f, "{face} comes back to {vertex} and crosses itself")
            }
            Defect::RepeatedCorner { face, vertex } => write!(f, "{face} repeats {vertex}"),
            Defect::DuplicateFace { face, original } => write!(f, "{face} is {original} again"),
            Defect::OppositeFace { face, original } => write!(f, "{face} is {original} the other way round"),
            Defect::DifferingFace { face, original, differs } => {
                write!(f, "{face} is {original} again, but for {differs}")
            }
            Defect::PolygonFace { face, corners } => write!(f, "{face} has {corners} corners"),
            Defect::NonFiniteFace { face, vertex } => write!(f, "{face} uses {vertex}, which is not finite"),
            Defect::BoundaryEdge { edge, ends: [a, b] } => write!(f, "{edge} {a}-{b} has one side"),
            Defect::NonManifoldEdge { edge, ends: [a, b], degree } => {
                write!(f, "{edge} {a}-{b} has {degree} sides")
            }
            Defect::InconsistentEdge { edge, ends: [a, b] } => {
                write!(f, "{edge} {a}-{b} has both sides running the same way")
            }
            Defect::SeamEdge { edge, ends: [a, b] } => write!(f, "{edge} {a}-{b} is cut open"),
            Defect::CoincidentEdges { ends: [a, b] } => write!(f, "several edges would join {a}-{b}"),
            Defect::PinchedVertex { vertex, umbrellas, boundary_only } => {
                let open = if *boundary_only { ", all open" } else { "" };
                write!(f, "{vertex} joins {umbrellas} umbrellas{open}")
            }
            Defect::SingularVertex { vertex } => write!(f, "{vertex} is on a non-manifold edge"),
            Defect::NonFiniteVertex { vertex } => write!(f, "{vertex} is not finite"),
            Defect::UnreferencedVertex { vertex } => write!(f, "{vertex} is in no face"),
            Defect::CoincidentVertex { vertex, original } => write!(f, "{vertex} is where {original} is"),
            Defect::LooseEdge { index, ends: [a, b] } => write!(f, "loose edge {index} joins {a}-{b}"),
            Defect::LoosePoint { index, vertex } => write!(f, "loose point {index} at {vertex}"),
            Defect::NonOrientablePatch { faces, .. } => match faces.first() {
                Some(first) => {
                    write!(f, "a strip of {} faces from {first} comes back reversed", faces.len())
                }
                None => write!(f, "a patch is not orientable"),
            },
            Defect::UnjudgedPatch { face, faces, reason } => {
                let why = match reason {
                    Unjudged::Open => "is open",
                    Unjudged::NoVolume => "encloses no volume",
                };
                write!(f, "the patch of {face}, {} in all, {why}", count_of_faces(*faces))
            }
            Defect::TurnedCavity { face, faces } => {
                write!(f, "the closed patch of {face}, {} in all, is inside another", count_of_faces(*faces))
            }
        }
    }
}

fn count_of_faces(count: u32) -> String {
    if count == 1 { "1 face".to_owned() } else { format!("{count} faces") }
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
    fn the_serialised_name_is_the_code() {
        let tagged = serde_json::to_value(Defect::DegenerateFace { face: FaceId(3) }).unwrap();
        assert_eq!(tagged, serde_json::json!({"kind": "degenerate-face", "face": 3}));
        for &kind in DefectKind::ALL {
            assert_eq!(serde_json::to_value(kind).unwrap(), kind.code());
        }
    }
}
