//! Whether a repair is final, and what is done where it is not.
//!
//! A second repair with the same options must find nothing to change. The default policies leave nothing for it: what
//! they match as welded they match as stored the next time. Other policies may: a face that was turned outward repeats
//! another one, a patch that `pinch-only` left is no longer held together by what it was, two faces that are the same
//! as welded are now the same as stored. Then all passes run again on the result as it will be read, round by round,
//! until a round changes nothing. That round is not part of the record. Faces that repeat others and differ from them are
//! looked at again under any policy: which faces those are depends on the sides that were chosen.

use std::ops::Range;
use std::sync::atomic::AtomicBool;

use meshmend_core::{CornerId, Draft, FaceTable, Id, Loose, PolygonMesh, Provenance, Sources, VertexId};
use rayon::prelude::*;

use super::Pipeline;
use super::run::Run;
use crate::{
    AnyPass, Context, Distance, Duplicates, NonFinite, NonOrientable, Pass, PassError, PassKind, Seams, Side,
    SplitEdges, Triangulate, TriangulateFaces,
};

/// More rounds than any mesh is known to need.
const MOST_ROUNDS: usize = 16;

/// How many times the corners of the first result a later one may have. Where `clean` is left out, faces that come back
/// to a vertex may be subdivided again in each round, without an end.
const MOST_GROWTH: usize = 3;

/// How the faces of a result are stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FaceStorage {
    /// By the vertices that they share.
    #[default]
    Indexed,
    /// As triangles, each with points of its own, as in STL.
    Apart,
}

/// What tells that a repair is final.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Finality {
    /// It always is.
    Always,
    /// No face came apart from another, and none was cut: then the result is manifold, and no two of its vertices are
    /// welded, so that the same sides are matched again.
    UnlessTakenApart,
    /// Nothing was changed.
    IfUnchanged,
}

impl Pipeline {
    /// Runs the passes on the result as it will be read, again and again, until that changes nothing.
    pub(super) fn settled(&self, mut run: Run, cancel: Option<&AtomicBool>) -> Result<Run, PassError> {
        if !self.may_change_again(&run) || self.faces.are_alike(run.stored(), &run.mesh) {
            return Ok(run);
        }
        let looks = |pass: &&AnyPass| pass.kind() == PassKind::Recompute;
        let (looking, changing): (Vec<&AnyPass>, Vec<&AnyPass>) = self.passes().iter().partition(looks);
        let most_corners = MOST_GROWTH * run.mesh.counts().corners;
        for _ in 0..MOST_ROUNDS {
            let (read, reading) = self.faces.read_again(&run.mesh)?;
            let mut next = Run::begin(&read, self.takes_figures);
            self.run_round(changing.iter().copied(), &mut next, cancel, |_| {})?;
            if self.faces.are_alike(&read, &next.mesh) || next.mesh.counts().corners > most_corners {
                break;
            }
            self.run_round(looking.iter().copied(), &mut next, cancel, |_| {})?;
            run.follow((&read, &reading), next);
            if !self.may_change_again(&run) {
                break;
            }
        }
        Ok(run)
    }

    /// Whether the passes might change what the last round left.
    fn may_change_again(&self, run: &Run) -> bool {
        let changed = |kind| run.last_round().iter().any(|record| record.pass == kind && record.is_changed);
        match self.finality() {
            Finality::Always => run.has_copies() && run.last_round().iter().any(|record| record.is_changed),
            Finality::UnlessTakenApart => {
                let is_cut_by_writer =
                    self.faces == FaceStorage::Apart && !run.mesh.faces().is_all_triangles();
                changed(PassKind::Split) || changed(PassKind::Triangulate) || is_cut_by_writer
            }
            Finality::IfUnchanged => run.last_round().iter().any(|record| record.is_changed),
        }
    }

    /// What tells that a repair by these passes is final.
    fn finality(&self) -> Finality {
        let mut kinds: Vec<PassKind> = self.passes().iter().map(AnyPass::kind).collect();
        // Where closed patches are turned outward, `orient` runs once more after `split`.
        if let Some(again) = kinds.windows(2).position(|two| two == [PassKind::Split, PassKind::Orient]) {
            kinds.remove(again + 1);
        }
        let needed = [PassKind::Weld, PassKind::Clean, PassKind::Orient, PassKind::Split];
        let is_whole = needed.iter().all(|kind| kinds.contains(kind))
            && kinds.windows(2).all(|two| two[0] < two[1])
            && !self.passes().iter().any(leaves_edges);
        if !is_whole {
            Finality::IfUnchanged
        } else if self.passes().iter().all(|pass| self.is_usual(pass)) && self.faces == FaceStorage::Indexed {
            Finality::Always
        } else {
            Finality::UnlessTakenApart
        }
    }

    /// Whether a pass has a policy that leaves nothing for a second run.
    fn is_usual(&self, pass: &AnyPass) -> bool {
        let cuts = |pass: &AnyPass| matches!(pass, AnyPass::Orient(orient) if orient.non_orientable == NonOrientable::Cut);
        match pass {
            AnyPass::Weld(weld) => weld.distance == Distance::Exact,
            AnyPass::Orient(orient) => orient.side == Side::Majority && orient.duplicates == Duplicates::Keep,
            AnyPass::Split(split) => split.seams == Seams::Keep || self.passes().iter().any(cuts),
            _ => true,
        }
    }
}

/// Whether a pass leaves edges of three sides or more, or vertices that can't be welded again.
fn leaves_edges(pass: &AnyPass) -> bool {
    match pass {
        AnyPass::Split(split) => split.edges == SplitEdges::PinchOnly,
        AnyPass::Clean(clean) => clean.non_finite == NonFinite::Keep,
        _ => false,
    }
}

impl FaceStorage {
    /// A mesh as it is read when it was stored this way.
    pub(super) fn read_again(self, mesh: &PolygonMesh) -> Result<(PolygonMesh, Provenance), PassError> {
        match self {
            FaceStorage::Indexed => Ok((mesh.detached(), Provenance::same(mesh.counts()))),
            FaceStorage::Apart => apart(mesh),
        }
    }

    /// Whether two meshes are written alike when they are stored this way.
    pub(super) fn are_alike(self, one: &PolygonMesh, other: &PolygonMesh) -> bool {
        match self {
            FaceStorage::Indexed => {
                one.counts() == other.counts()
                    && one.faces() == other.faces()
                    && are_in_place(one.counts().vertices, |v| [one, other].map(|mesh| mesh.positions()[v]))
                    && one.loose_edges() == other.loose_edges()
                    && one.loose_points() == other.loose_points()
            }
            FaceStorage::Apart => {
                let point = |mesh: &PolygonMesh, corner| {
                    mesh.position(mesh.faces().corner_vertex(CornerId::new(corner)))
                };
                let corners = one.counts().corners;
                corners == other.counts().corners
                    && corner_ranges(one.faces()).eq(corner_ranges(other.faces()))
                    && are_in_place(corners, |corner| [one, other].map(|mesh| point(mesh, corner)))
            }
        }
    }
}

/// The corners of each face.
fn corner_ranges(faces: &FaceTable) -> impl Iterator<Item = Range<usize>> {
    faces.faces().map(|face| faces.corner_range(face))
}

/// Whether all pairs of points are equal to the bit.
fn are_in_place(count: usize, pair: impl Fn(usize) -> [[f64; 3]; 2] + Sync) -> bool {
    (0..count).into_par_iter().all(|at| {
        let [one, other] = pair(at).map(|point| point.map(f64::to_bits));
        one == other
    })
}

/// Each corner at a vertex of its own, and each face a triangle.
fn apart(mesh: &PolygonMesh) -> Result<(PolygonMesh, Provenance), PassError> {
    let triangles = Triangulate { faces: TriangulateFaces::All }.apply(mesh, &Context::default())?;
    let old = triangles.mesh.faces();
    let corners: Vec<VertexId> = (0..old.corner_count()).map(VertexId::new).collect();
    let faces = old.over(corners.len(), corners)?;
    let (face_sources, corner_sources) = (Sources::same(old.face_count()), Sources::same(old.corner_count()));
    let draft = Draft {
        vertex_sources: Sources::listed(old.corner_vertices().iter().copied().map(Some)),
        drop_loose: Loose { edges: true, points: true },
        ..Draft::of_faces(&triangles.mesh, faces, face_sources, corner_sources)
    };
    let (apart, provenance) = triangles.mesh.rebuild(draft)?;
    let whole = triangles.provenance.then(&provenance, mesh.faces(), apart.faces());
    Ok((apart, whole))
}
