//! Makes every face a simple polygon with finite corners, and drops repeated ones.
//!
//! *Why*: a face that lists a vertex twice, or no area at all, breaks most data structures; a face at NaN breaks all
//! geometry; the same face twice makes every edge of it non-manifold.
//!
//! 1. Faces with a corner whose position is not finite go (policy: drop, keep or fail).
//! 2. Consecutive repeats and spikes are folded away.
//! 3. A face that comes back to a vertex is split there into simple faces; what has fewer than three corners goes.
//! 4. Of faces with the same directed cycle of vertices *as stored* the first stays.
//!
//! *Promises* no degenerate or non-simple face, no non-finite face (unless kept), no repeat as stored. *Requires*
//! nothing. *May introduce* boundary edges and what follows from them where a face went, and parts of faces that are
//! another face again. *Cost*: O(n log n). *Source*: the multiple-incidence repairs of A. Bærentzen, *On the Topology
//! of Polygonal Meshes*, 2025.

use meshmend_core::{
    CornerId, Defect, DefectKind, Draft, FaceId, FaceTableBuilder, Id, PolygonMesh, Sources, VertexId,
    canonical_rotation, distinct_count,
};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::words::WordSplitter;
use crate::{Context, Outcome, Pass, PassError};

/// Makes every face a simple polygon with finite corners, and drops repeated ones.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Clean {
    /// What to do with faces that have a corner whose position is not finite.
    pub non_finite: NonFinite,
}

/// What to do with faces that have a corner whose position is not finite.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NonFinite {
    /// Remove them, and say which.
    #[default]
    Drop,
    /// Keep them: topology does not mind.
    Keep,
    /// Give up.
    Fail,
}

impl Pass for Clean {
    fn name(&self) -> &'static str {
        "clean"
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
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        let mut pieces = self.simple_pieces(mesh)?;
        context.check_cancelled()?;
        pieces.drop_repeats(mesh, context);
        pieces.into_outcome(mesh)
    }
}

/// The faces that stay, as pieces of old ones.
struct Pieces {
    /// For each piece its old face, ascending.
    face: Vec<FaceId>,
    /// Where each piece's corners begin, and one more.
    starts: Vec<u32>,
    corners: Vec<CornerId>,
    mended: Vec<Defect>,
    is_kept: Vec<bool>,
}

impl Clean {
    fn simple_pieces(&self, mesh: &PolygonMesh) -> Result<Pieces, PassError> {
        let faces = mesh.faces();
        let is_finite: Vec<bool> =
            mesh.positions().par_iter().map(|p| p.iter().all(|x| x.is_finite())).collect();
        let all_finite = is_finite.iter().all(|&finite| finite);
        let mut splitter = None;
        let mut pieces = Pieces::with_capacity(faces.face_count(), faces.corner_count());
        let mut non_finite = Vec::new();
        for face in faces.faces() {
            let vertices = faces.face_vertices(face);
            let bad = if all_finite { None } else { vertices.iter().find(|v| !is_finite[v.index()]) };
            if let Some(&vertex) = bad {
                non_finite.push(Defect::NonFiniteFace { face, vertex });
                if self.non_finite != NonFinite::Keep {
                    continue;
                }
            }
            let range = faces.corner_range(face);
            if vertices.len() >= 3 && distinct_count(vertices) == vertices.len() {
                pieces.push(face, range.map(CornerId::new));
                continue;
            }
            let splitter = splitter.get_or_insert_with(|| WordSplitter::new(faces.vertex_count()));
            let found = splitter.split(vertices);
            pieces.mended.push(what_was_wrong(face, vertices, found.repeated, found.loops.is_empty()));
            for corners in found.loops {
                pieces.push(face, corners.into_iter().map(|place| CornerId::new(range.start + place)));
            }
        }
        match self.non_finite {
            NonFinite::Fail if !non_finite.is_empty() => {
                let kind = DefectKind::NonFiniteFace;
                return Err(PassError::Policy { pass: "clean", kind, defects: non_finite });
            }
            NonFinite::Drop => pieces.mended.extend(non_finite),
            _ => {}
        }
        Ok(pieces)
    }
}

fn what_was_wrong(face: FaceId, vertices: &[VertexId], repeated: Option<VertexId>, is_gone: bool) -> Defect {
    match (is_gone, repeated) {
        (true, _) => Defect::DegenerateFace { face },
        (false, Some(vertex)) => Defect::NonSimpleFace { face, vertex },
        (false, None) => {
            let mut places: Vec<(VertexId, usize)> = vertices.iter().copied().zip(0..).collect();
            places.sort_unstable();
            let again = places.windows(2).filter(|pair| pair[0].0 == pair[1].0).map(|pair| pair[1].1).min();
            Defect::RepeatedCorner { face, vertex: vertices[again.unwrap_or(0)] }
        }
    }
}

impl Pieces {
    fn with_capacity(faces: usize, corners: usize) -> Self {
        let mut starts = Vec::with_capacity(faces + 1);
        starts.push(0);
        Pieces {
            face: Vec::with_capacity(faces),
            starts,
            corners: Vec::with_capacity(corners),
            mended: Vec::new(),
            is_kept: Vec::new(),
        }
    }

    fn push(&mut self, face: FaceId, corners: impl Iterator<Item = CornerId>) {
        self.face.push(face);
        self.corners.extend(corners);
        self.starts.push(self.corners.len() as u32);
    }

    fn corners_of(&self, piece: usize) -> &[CornerId] {
        &self.corners[self.starts[piece] as usize..self.starts[piece + 1] as usize]
    }

    /// Marks the pieces to keep: of those with the same directed cycle of vertices as stored, the first.
    fn drop_repeats(&mut self, mesh: &PolygonMesh, context: &Context<'_>) {
        let stored = |corner: CornerId| {
            let present = mesh.faces().corner_vertex(corner);
            let Some(history) = context.history else { return present };
            match history.provenance().corners.of(corner) {
                Some(old) => history.stored().faces().corner_vertex(old),
                None => VertexId::new(history.stored().counts().vertices + present.index()),
            }
        };
        let count = self.face.len();
        self.is_kept = vec![true; count];
        let mut names: Vec<VertexId> = self.corners.iter().map(|&c| stored(c)).collect();
        for piece in 0..count {
            let cycle = &mut names[self.starts[piece] as usize..self.starts[piece + 1] as usize];
            cycle.rotate_left(canonical_rotation(cycle));
        }
        let cycle = |piece: u32| {
            &names[self.starts[piece as usize] as usize..self.starts[piece as usize + 1] as usize]
        };
        for (original, repeat) in equal_to_an_earlier_one(count, cycle) {
            self.is_kept[repeat as usize] = false;
            let (face, original) = (self.face[repeat as usize], self.face[original as usize]);
            self.mended.push(Defect::DuplicateFace { face, original });
        }
    }

    fn into_outcome(self, mesh: &PolygonMesh) -> Result<Outcome, PassError> {
        if self.mended.is_empty() {
            return Ok(Outcome::unchanged(mesh));
        }
        let mut builder = FaceTableBuilder::default();
        let (mut face_sources, mut corner_sources) = (Vec::new(), Vec::new());
        for piece in (0..self.face.len()).filter(|&piece| self.is_kept[piece]) {
            let corners = self.corners_of(piece);
            builder.push_face(corners.iter().map(|&c| mesh.faces().corner_vertex(c)));
            corner_sources.extend(corners.iter().map(|&c| Some(c)));
            face_sources.push(Some(self.face[piece]));
        }
        let faces = builder.build(mesh.counts().vertices)?;
        let draft =
            Draft::of_faces(mesh, faces, Sources::listed(face_sources), Sources::listed(corner_sources));
        Ok(Outcome::changed(mesh.rebuild(draft)?, self.mended.into()))
    }
}

/// Pairs (first, later) of equal cycles, each in its least rotation; for triangles the keys are sorted as numbers.
fn equal_to_an_earlier_one<'a>(
    count: usize,
    cycle: impl Fn(u32) -> &'a [VertexId] + Sync,
) -> Vec<(u32, u32)> {
    let mut triangles: Vec<u128> = Vec::new();
    let mut others: Vec<u32> = Vec::new();
    for piece in 0..count as u32 {
        match *cycle(piece) {
            [a, b, c] => triangles.push(
                u128::from(a.0) << 96 | u128::from(b.0) << 64 | u128::from(c.0) << 32 | u128::from(piece),
            ),
            _ => others.push(piece),
        }
    }
    triangles.par_sort_unstable();
    others.par_sort_unstable_by(|&one, &other| cycle(one).cmp(cycle(other)).then(one.cmp(&other)));
    let mut found = Vec::new();
    for run in triangles.chunk_by(|one, other| one >> 32 == other >> 32) {
        found.extend(run[1..].iter().map(|&later| (run[0] as u32, later as u32)));
    }
    for run in others.chunk_by(|&one, &other| cycle(one) == cycle(other)) {
        found.extend(run[1..].iter().map(|&later| (run[0], later)));
    }
    found
}

#[cfg(test)]
mod tests {
    use meshmend_testkit::Soup;

    use crate::{PassKind, Plan, TriangulateFaces};

    /// A vertex that triangulating created has the number of a vertex as stored that welding had joined to another.
    #[test]
    fn a_created_vertex_is_no_stored_one() {
        let square = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| [f64::from(x), f64::from(y), 0.0]);
        let soup = Soup {
            // Vertex 4 is where vertex 2 is.
            positions: [&square[..], &square[2..3]].concat(),
            // No diagonal of the squares is free, so that the first gets vertex 4 of the welded mesh inside it.
            faces: vec![vec![0, 1, 2, 3], vec![0, 2, 1, 3], vec![0, 1, 3, 2], vec![0, 1, 4]],
        };
        let mut plan =
            Plan { passes: vec![PassKind::Weld, PassKind::Triangulate, PassKind::Clean], ..Plan::default() };
        plan.triangulate.faces = TriangulateFaces::All;
        let repaired = plan.pipeline().run(&soup.mesh()).unwrap();
        assert_eq!(repaired.mesh.counts().faces, 3 * 4 + 1);
    }

    /// Triangles at the first vertex, and in the same squares as before three vertices that are created after many.
    #[test]
    fn created_vertices_are_no_stored_ones_however_many_there_are() {
        let mut soup = Soup::generic(4, [[0, 1, 2, 3], [0, 2, 1, 3], [0, 1, 3, 2]]);
        soup.positions.resize(1 << 16, [0.0; 3]);
        soup.faces.extend([[1, 2, 0], [2, 3, 0], [3, 1, 0]].map(Vec::from));
        let mut plan = Plan { passes: vec![PassKind::Triangulate, PassKind::Clean], ..Plan::default() };
        plan.triangulate.faces = TriangulateFaces::All;
        let repaired = plan.pipeline().run(&soup.mesh()).unwrap();
        assert_eq!(repaired.mesh.counts().faces, 3 * 4 + 3);
    }
}
