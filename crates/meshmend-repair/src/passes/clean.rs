//! Makes every face a simple polygon with finite corners, and drops repeated ones.
//!
//! *Why*: a face that lists a vertex twice, or no area at all, breaks most data structures; a face at NaN breaks all
//! geometry; the same face twice makes every edge of it non-manifold.
//!
//! 1. Faces with a corner whose position is not finite go (policy: drop, keep or fail).
//! 2. Consecutive repeats and spikes are folded away.
//! 3. A face that comes back to a vertex is split there into simple faces; parts of fewer than three corners go. But if
//!    the face has a hole (some part of it turns against the whole), it is cut along diagonals, so that no hole is filled.
//! 4. Of faces with the same directed cycle of vertices *as stored* the first stays, and of those that differ from it
//!    the first of each kind (policy: keep those that differ, or drop them).
//!
//! *Promises* no degenerate or non-simple face, no non-finite face (unless kept), no repeat as stored. *Requires*
//! nothing. *May introduce* boundary edges and what follows from them where a face went, parts of faces that repeat
//! another face, and a non-manifold edge where faces with holes leave a diagonal no other place. *Cost*: O(n log n);
//! for faces with holes as [`Triangulate`](crate::Triangulate). *Source*: the multiple-incidence repairs of A. Bærentzen, *On the Topology
//! of Polygonal Meshes*, 2025.

use std::borrow::Cow;

use meshmend_core::{
    CornerId, Defect, DefectKind, Differences, Draft, FaceId, FaceTable, FaceTableBuilder, Id, PolygonMesh,
    Sources, VertexId, distinct_count,
};
use meshmend_geometry::words::{Loops, WordSplitter};
use meshmend_topology::TopologyReport;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::telling::{Looks, Telling};
use crate::{
    Context, Form, OptionValues, Outcome, Pass, PassError, PassKind, PassOption, PassRow, TellingLayers, Word,
};

mod holes;
mod repeats;
#[cfg(test)]
mod tests;

use holes::{HoleCutter, Parts};
use repeats::repeats;

/// Makes every face a simple polygon with finite corners, and drops repeated ones.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Clean {
    /// What happens to faces that have a corner whose position is not finite.
    pub non_finite: NonFinite,
    /// What happens to faces that repeat another one but differ from it. In a pipeline `orient` and `split` do the same.
    pub repeated: Repeated,
}

/// What happens to faces that repeat another one but differ from it: in material, object, group, solid, part or colour,
/// or in texture coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Repeated {
    /// They are kept, and the record says in what they differ.
    #[default]
    KeepDifferent,
    /// Only the first is kept, and the record says what went with the others.
    Drop,
}

/// What happens to faces that have a corner whose position is not finite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NonFinite {
    /// They are removed and named.
    #[default]
    Drop,
    /// They are kept: topology does not depend on positions.
    Keep,
    /// The repair gives up.
    Fail,
}

/// All that is said of the pass.
pub(crate) const ROW: PassRow = PassRow {
    name: "clean",
    explanation: "Removes faces with non-finite corners, folds repeated corners and spikes away, splits faces that come back \
                  to a vertex, removes degenerate faces, and of faces that are the same as stored keeps the first.",
    is_default: true,
    before: None,
    options: &[
        PassOption {
            name: "clean",
            help: "Whether faces are made simple, and degenerate, non-finite and repeated ones removed",
            sets: &[],
            values: OptionValues::Words(&[Word::new("on", "Run the pass")]),
        },
        PassOption {
            name: "non-finite",
            help: "Faces with a corner that is infinite or not a number",
            sets: &["non-finite"],
            values: OptionValues::Words(&[
                Word::new("drop", "Remove them, and say which"),
                Word::new("keep", "Keep them"),
                Word::new("fail", "Give up"),
            ]),
        },
        PassOption {
            name: "repeated",
            help: "Faces that repeat another one but differ in material, object, group, colour or texture coordinates",
            sets: &["repeated"],
            values: OptionValues::Words(&[
                Word::new(
                    "keep-different",
                    "Keep them, and say in what they differ; what the output's format can't hold is not a difference",
                ),
                Word::new("drop", "Keep the first alone, and say what went with the others"),
            ]),
        },
    ],
    form: Form::of::<Clean>(),
};

impl Pass for Clean {
    fn kind(&self) -> PassKind {
        PassKind::Clean
    }
    fn removes(&self) -> &'static [DefectKind] {
        match self.non_finite {
            NonFinite::Keep => {
                &[DefectKind::DegenerateFace, DefectKind::NonSimpleFace, DefectKind::RepeatedCorner]
            }
            _ => &[
                DefectKind::DegenerateFace,
                DefectKind::NonSimpleFace,
                DefectKind::RepeatedCorner,
                DefectKind::NonFiniteFace,
            ],
        }
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[
            DefectKind::BoundaryEdge,
            DefectKind::UnreferencedVertex,
            DefectKind::InconsistentEdge,
            DefectKind::PinchedVertex,
            DefectKind::NonOrientablePatch,
            // A part of a face may be another face, either way round.
            DefectKind::DuplicateFace,
            DefectKind::OppositeFace,
            // Where a diagonal has no other place, or faces with the same hole are the same by position only.
            DefectKind::NonManifoldEdge,
            DefectKind::SingularVertex,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        if context.known.is_some_and(is_clean) {
            return Ok(Outcome::unchanged(mesh));
        }
        let pieces = self.simple_pieces(mesh)?;
        context.check_cancelled()?;
        let stored = stored_vertices(mesh, context);
        context.check_cancelled()?;
        let telling = match self.repeated {
            Repeated::KeepDifferent => context.telling,
            Repeated::Drop => TellingLayers::Only(&[]),
        };
        let repeats = pieces.sorted_repeats(mesh, &stored, telling);
        drop(stored);
        context.check_cancelled()?;
        pieces.into_outcome(mesh, repeats, context)
    }
}

/// Whether this pass has nothing to fix. A repeat as stored is also a repeat of the mesh.
fn is_clean(report: &TopologyReport) -> bool {
    report.degenerate_faces == 0
        && report.non_simple_faces == 0
        && report.repeated_corner_faces == 0
        && report.duplicate_faces.same == 0
        && report.non_finite_vertices == 0
}

/// The faces that stay, as pieces of old ones.
struct Pieces<'a> {
    faces: &'a FaceTable,
    /// Absent if each face stays as it is.
    listed: Option<Listed>,
    fixed: Vec<Defect>,
}

/// Pieces that repeat an earlier one.
#[derive(Default)]
struct Repeats {
    /// Those that go: the piece, the one that it repeats, and in what it differs from that one nevertheless.
    dropped: Vec<(u32, u32, Differences)>,
    /// Those that differ and stay, in the same form.
    kept: Vec<(u32, u32, Differences)>,
}

/// Pieces that are listed, by ascending face.
struct Listed {
    face: Vec<FaceId>,
    /// Where each piece's corners begin, and one more.
    starts: Vec<u32>,
    corners: Vec<CornerId>,
}

impl Clean {
    fn simple_pieces<'a>(&self, mesh: &'a PolygonMesh) -> Result<Pieces<'a>, PassError> {
        let (faces, positions) = (mesh.faces(), mesh.positions());
        let is_finite = |v: &VertexId| positions[v.index()].iter().all(|x| x.is_finite());
        let all_finite = positions.par_iter().all(|p| p.iter().all(|x| x.is_finite()));
        let bad_vertex = |face| faces.face_vertices(face).iter().find(|v| !all_finite && !is_finite(v));
        let is_simple = |face| is_simple(faces.face_vertices(face));
        if faces.faces().all(|face| is_simple(face) && bad_vertex(face).is_none()) {
            return Ok(Pieces { faces, listed: None, fixed: Vec::new() });
        }
        let (mut splitter, mut holes) = (None, None);
        let mut listed = Listed::with_capacity(faces.face_count(), faces.corner_count());
        let (mut fixed, mut non_finite) = (Vec::new(), Vec::new());
        for face in faces.faces() {
            if let Some(&vertex) = bad_vertex(face) {
                non_finite.push(Defect::non_finite_face(face, vertex));
                if self.non_finite != NonFinite::Keep {
                    continue;
                }
            }
            let (range, vertices) = (faces.corner_range(face), faces.face_vertices(face));
            if is_simple(face) {
                listed.push(face, range.map(CornerId::new));
                continue;
            }
            let splitter = splitter.get_or_insert_with(|| WordSplitter::new(faces.vertex_count()));
            let found = splitter.split(vertices);
            let parts = match found.loops.len() {
                0 | 1 => Parts::Loops,
                _ => holes.get_or_insert_with(|| HoleCutter::new(mesh)).parts(vertices, &found),
            };
            fixed.push(what_was_wrong(face, vertices, &found, &parts));
            let pieces = if let Parts::Pieces(pieces) = parts { pieces } else { found.loops };
            for corners in pieces {
                listed.push(face, corners.into_iter().map(|place| CornerId::new(range.start + place)));
            }
        }
        match self.non_finite {
            NonFinite::Fail if !non_finite.is_empty() => {
                let kind = DefectKind::NonFiniteFace;
                return Err(PassError::Policy { pass: "clean", kind, defects: non_finite });
            }
            NonFinite::Drop => fixed.extend(non_finite),
            _ => {}
        }
        Ok(Pieces { faces, listed: Some(listed), fixed })
    }
}

/// Whether a face has three corners or more, all at different vertices.
fn is_simple(vertices: &[VertexId]) -> bool {
    match *vertices {
        [a, b, c] => a != b && b != c && c != a,
        _ => vertices.len() > 3 && distinct_count(vertices) == vertices.len(),
    }
}

fn what_was_wrong(face: FaceId, vertices: &[VertexId], found: &Loops, parts: &Parts) -> Defect {
    match (found.loops.is_empty(), found.repeated, parts) {
        (true, ..) => Defect::degenerate_face(face),
        (false, Some(vertex), Parts::Loops) => Defect::non_simple_face(face, vertex),
        (false, Some(vertex), Parts::Pieces(_)) => Defect::face_with_hole(face, vertex),
        (false, Some(vertex), Parts::Crossing) => Defect::crossing_face(face, vertex),
        (false, None, _) => {
            let mut places: Vec<(VertexId, usize)> = vertices.iter().copied().zip(0..).collect();
            places.sort_unstable();
            let again = places.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1).min();
            Defect::repeated_corner(face, vertices[again.unwrap_or(0)])
        }
    }
}

impl Listed {
    fn with_capacity(faces: usize, corners: usize) -> Self {
        let mut starts = Vec::with_capacity(faces + 1);
        starts.push(0);
        Listed { face: Vec::with_capacity(faces), starts, corners: Vec::with_capacity(corners) }
    }

    fn push(&mut self, face: FaceId, corners: impl Iterator<Item = CornerId>) {
        self.face.push(face);
        self.corners.extend(corners);
        self.starts.push(self.corners.len() as u32);
    }

    fn corners_of(&self, piece: usize) -> &[CornerId] {
        &self.corners[self.starts[piece] as usize..self.starts[piece + 1] as usize]
    }
}

/// The vertex as stored behind each corner. Created vertices have ids beyond those of stored ones.
fn stored_vertices<'a>(mesh: &'a PolygonMesh, context: &Context<'a>) -> Cow<'a, [VertexId]> {
    let present = mesh.faces().corner_vertices();
    let Some(history) = context.history else { return Cow::Borrowed(present) };
    let (corners, stored) = (&history.provenance().corners, history.stored());
    let stored_vertices = stored.faces().corner_vertices();
    if corners.is_same() {
        return Cow::Borrowed(&stored_vertices[..present.len()]);
    }
    let behind = |(corner, present): (usize, &VertexId)| match corners.of(CornerId::new(corner)) {
        Some(old) => stored_vertices[old.index()],
        None => VertexId::new(stored.counts().vertices + present.index()),
    };
    present.iter().enumerate().map(behind).collect()
}

impl Pieces<'_> {
    fn count(&self) -> usize {
        self.listed.as_ref().map_or(self.faces.face_count(), |listed| listed.face.len())
    }

    fn face(&self, piece: usize) -> FaceId {
        self.listed.as_ref().map_or(FaceId::new(piece), |listed| listed.face[piece])
    }

    fn corners(&self, piece: usize) -> impl Iterator<Item = CornerId> {
        let listed = self.listed.as_ref().map(|listed| listed.corners_of(piece));
        let range = match listed {
            None => self.faces.corner_range(FaceId::new(piece)),
            Some(corners) => 0..corners.len(),
        };
        range.map(move |at| listed.map_or(CornerId::new(at), |corners| corners[at]))
    }

    /// Pairs (first, later) of pieces with the same directed cycle of vertices as stored.
    fn repeats(&self, behind: &[VertexId]) -> Vec<(u32, u32)> {
        let (faces, count) = (self.faces, self.count());
        match &self.listed {
            None => repeats(count, |face| behind[faces.corner_range(FaceId(face))].iter().copied()),
            Some(listed) => {
                repeats(count, |piece| listed.corners_of(piece as usize).iter().map(|c| behind[c.index()]))
            }
        }
    }

    /// The repeats: those that go, and those that stay because they differ in some layer.
    fn sorted_repeats(&self, mesh: &PolygonMesh, behind: &[VertexId], telling: TellingLayers<'_>) -> Repeats {
        let pairs = self.repeats(behind);
        let all = if pairs.is_empty() { None } else { Telling::of(mesh, TellingLayers::All) };
        let Some(all) = all else {
            let dropped = pairs.into_iter().map(|(first, later)| (later, first, Differences::default()));
            return Repeats { dropped: dropped.collect(), kept: Vec::new() };
        };
        let telling = Telling::of(mesh, telling);
        let mut repeats = Repeats::default();
        for pairs in pairs.chunk_by(|one, other| one.0 == other.0) {
            let mut pieces = vec![pairs[0].0];
            pieces.extend(pairs.iter().map(|pair| pair.1));
            let looks: Vec<Looks> = pieces.iter().map(|&piece| self.looks(piece, behind)).collect();
            let first_alike = telling.as_ref().map_or(vec![0; looks.len()], |by| by.first_alike(&looks));
            for (place, &first) in first_alike.iter().enumerate().skip(1) {
                let (original, list) =
                    if first == place { (0, &mut repeats.kept) } else { (first, &mut repeats.dropped) };
                let differs = all.differences(&looks[place], &looks[original]);
                list.push((pieces[place], pieces[original], differs));
            }
        }
        repeats
    }

    fn looks(&self, piece: u32, behind: &[VertexId]) -> Looks {
        let corners = self.corners(piece as usize).map(|corner| (behind[corner.index()], corner));
        Looks::new(self.face(piece as usize), corners.collect())
    }

    fn into_outcome(
        mut self,
        mesh: &PolygonMesh,
        repeats: Repeats,
        context: &Context<'_>,
    ) -> Result<Outcome, PassError> {
        let mut is_kept = vec![true; if repeats.dropped.is_empty() { 0 } else { self.count() }];
        let mut differed = Vec::new();
        for &(repeat, original, differs) in &repeats.dropped {
            is_kept[repeat as usize] = false;
            let (face, original) = (self.face(repeat as usize), self.face(original as usize));
            self.fixed.push(Defect::duplicate_face(face, original));
            if !differs.is_empty() {
                differed.push((face, differs));
            }
        }
        let left = differing_faces(&repeats.kept, &is_kept);
        if self.fixed.is_empty() {
            return Ok(Outcome { left, ..Outcome::unchanged(mesh) });
        }
        let mut builder = FaceTableBuilder::default();
        let (mut face_sources, mut corner_sources) = (Vec::new(), Vec::new());
        for piece in (0..self.count()).filter(|&piece| is_kept.get(piece) != Some(&false)) {
            builder.push_face(self.corners(piece).map(|corner| mesh.faces().corner_vertex(corner)));
            corner_sources.extend(self.corners(piece).map(Some));
            face_sources.push(Some(self.face(piece)));
        }
        context.check_cancelled()?;
        let faces = builder.build(mesh.counts().vertices)?;
        context.check_cancelled()?;
        let draft =
            Draft::of_faces(mesh, faces, Sources::listed(face_sources), Sources::listed(corner_sources));
        let outcome = Outcome::changed(mesh.rebuild(draft)?, self.fixed);
        Ok(Outcome { left, differed, ..outcome })
    }
}

/// The repeats that stay, by the ids that they get. No face goes if `is_kept` is empty.
fn differing_faces(kept: &[(u32, u32, Differences)], is_kept: &[bool]) -> Vec<Defect> {
    if kept.is_empty() {
        return Vec::new();
    }
    let mut next = 0;
    let number = |&is_kept: &bool| {
        next += u32::from(is_kept);
        next.saturating_sub(1)
    };
    let numbers: Vec<u32> = is_kept.iter().map(number).collect();
    let face = |piece: u32| FaceId(numbers.get(piece as usize).copied().unwrap_or(piece));
    let defect = |&(repeat, original, differs): &(u32, u32, Differences)| {
        Defect::differing_face(face(repeat), face(original), differs)
    };
    let mut left: Vec<Defect> = kept.iter().map(defect).collect();
    left.sort();
    left
}
