//! Turns faces so that neighbours agree, and drops patches that are there twice.
//!
//! *Why*: half of a mesh looks inward, a wall is stored twice, a body once more on top of itself. Turning comes before
//! any splitting: a torus with half its faces flipped needs nothing but flips.
//!
//! 1. On the patches of rule 1 alone, with the directions as stored, drop duplicate patches: a doubled object goes
//!    whole, and a closed solid that merely touches another one is never torn.
//! 2. On the patches of rules 1 and 2 orient, drop duplicate patches, and again until there is none. Only edges that
//!    lost a use and patches that merged are looked at again.
//! 3. Opposite duplicates (double-sided walls) stay, unless the policy says otherwise; if faces go, step 2 is done
//!    again.
//! 4. A flipped face keeps its first corner first and reverses the rest.
//!
//! *Promises* no inconsistent edge in any orientable patch. *Requires* simple faces for its duplicates to be those of
//! the text; works on any. *May introduce* boundary edges where duplicates went, and unreferenced vertices. *Cost*:
//! O(n log n), however many rounds there are. Where patches are turned outward, those that have no outer side are named,
//! and the walls of hollows that were turned. A patch without a consistent side is left as it is and named, with a
//! witness; or the policy cuts it or gives up.

use meshmend_core::{
    Column, Connectivity, CornerId, Defect, DefectKind, Differences, Draft, EdgeId, EdgeUse, FaceId,
    FaceTableBuilder, FlippedNormals, Id, PolygonMesh, Sources, VertexId, is_inconsistent,
};
use meshmend_kernels::KernelTask;
use meshmend_topology::{OneSidedStrip, TopologyReport, orientability, patches as patches_of};
use serde::{Deserialize, Serialize};

use crate::copies::looks;
use crate::stored_vertices::StoredVertices;
use crate::telling::Telling;
use crate::{Context, Fixed, Outcome, Pass, PassError, TellingLayers};

mod crossing;
mod live_matching;
mod manifold_fast_path;
mod nesting;
mod outward;
mod patches;
mod repeats;
mod seams;
mod winding;

use live_matching::LiveUses;
use outward::{Nested, PatchNamed};
use patches::{Contradiction, Patches, Sides};
use repeats::Cycles;

/// Turns faces so that neighbours agree, and drops patches that are there twice.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
pub struct Orient {
    /// Which of a patch's two sides is taken.
    pub side: Side,
    /// What to do with a patch that has no consistent side.
    pub non_orientable: NonOrientable,
    /// What to do with faces that are there once in each direction.
    pub duplicates: Duplicates,
    /// Whether the stored normals of a face turn with it.
    pub flipped_normals: FlippedNormals,
}

/// Which of a patch's two consistent sides is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// The one that flips fewer faces; on a tie the one that keeps the lowest face.
    #[default]
    Majority,
    /// For a closed patch the one with positive signed volume; any other patch goes by majority.
    Outward,
    /// The same, but a closed patch inside an odd number of others gets negative signed volume: nested shells
    /// alternate, as the walls of hollows do.
    OutwardNested,
}

/// What to do with a patch that has no consistent side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum NonOrientable {
    /// Leave it as it is and name it, with a witness.
    #[default]
    Report,
    /// Choose sides all the same, so that they clash along few edges; `split` opens that seam.
    Cut,
    /// Give up.
    Fail,
}

/// What to do with faces that are there once in each direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Duplicates {
    /// Keep and report them: a double-sided wall.
    #[default]
    Keep,
    /// Remove as many of each direction as there are pairs.
    RemovePair,
    /// Keep the first face of each group.
    KeepFirst,
}

impl Pass for Orient {
    fn name(&self) -> &'static str {
        "orient"
    }
    fn removes(&self) -> &'static [DefectKind] {
        &[DefectKind::InconsistentEdge]
    }
    fn requires(&self) -> &'static [DefectKind] {
        &[DefectKind::DegenerateFace, DefectKind::NonSimpleFace, DefectKind::RepeatedCorner]
    }
    fn may_introduce(&self) -> &'static [DefectKind] {
        &[
            DefectKind::BoundaryEdge,
            DefectKind::UnreferencedVertex,
            DefectKind::NonOrientablePatch,
            DefectKind::PinchedVertex,
            // A face that is turned may run as another one does, or against it.
            DefectKind::DuplicateFace,
            DefectKind::OppositeFace,
        ]
    }

    fn apply(&self, mesh: &PolygonMesh, context: &Context<'_>) -> Result<Outcome, PassError> {
        if self.side == Side::Majority && context.report.is_some_and(is_oriented) {
            return Ok(Outcome::unchanged(mesh));
        }
        context.kernel.run(mesh.complex(), Task { options: self, mesh, context })?
    }
}

/// Whether no face is there twice, either way round, and all that share an edge, two at each, agree.
fn is_oriented(report: &TopologyReport) -> bool {
    report.duplicate_faces.same == 0
        && report.duplicate_faces.opposite == 0
        && report.non_manifold_edges == 0
        && report.consistently_oriented
}

struct Task<'a> {
    options: &'a Orient,
    mesh: &'a PolygonMesh,
    context: &'a Context<'a>,
}

/// Which faces stay, which of them are turned, and the lowest face of each non-orientable patch.
struct Found {
    is_alive: Column<FaceId, bool>,
    is_flipped: Column<FaceId, bool>,
    non_orientable: Vec<FaceId>,
    /// What is to be said of patches that were to be turned outward.
    outward: Vec<PatchNamed>,
}

impl KernelTask for Task<'_> {
    type Output = Result<Outcome, PassError>;

    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        let names = StoredVertices::new(self.mesh, self.context);
        let cycles = Cycles::of(kernel, self.mesh, self.context);
        let count = kernel.face_count();
        if cycles.is_empty()
            && self.options.side == Side::Majority
            && let Some(is_flipped) = manifold_fast_path::flips(kernel)
        {
            let is_alive = Column::filled(true, count);
            let found = Found { is_alive, is_flipped, non_orientable: Vec::new(), outward: Vec::new() };
            return self.outcome(kernel, &cycles, found);
        }
        let mut alive = Column::filled(true, count);
        let mut flipped = Column::filled(false, count);
        if !cycles.is_empty() {
            alive = self.without_stored_duplicates(kernel, &names, &cycles);
        }
        loop {
            self.context.check_cancelled()?;
            let found = self.oriented(kernel, &names, &cycles, (alive, flipped))?;
            let opposite = self.opposite_to_remove(&cycles, &found);
            if opposite.is_empty() {
                return self.outcome(kernel, &cycles, found);
            }
            (alive, flipped) = (found.is_alive, found.is_flipped);
            opposite.into_iter().for_each(|face| alive[face] = false);
        }
    }
}

impl Task<'_> {
    /// Step 1. One round is enough here: patches that merge without a flip unblock nothing.
    fn without_stored_duplicates<K: Connectivity>(
        &self,
        kernel: &K,
        names: &StoredVertices<'_>,
        cycles: &Cycles,
    ) -> Column<FaceId, bool> {
        let count = kernel.face_count();
        let start = (Column::filled(true, count), Column::filled(false, count));
        let policy = (Sides::Stored, Contradiction::Twists);
        let mut patches = Patches::new(kernel, self.mesh, cycles, policy, start);
        patches.merge(&live_matching::pairs_as_stored(kernel, names, cycles.copies()));
        patches.drop_duplicates();
        patches.is_alive
    }

    /// Step 2.
    fn oriented<K: Connectivity>(
        &self,
        kernel: &K,
        names: &StoredVertices<'_>,
        cycles: &Cycles,
        start: (Column<FaceId, bool>, Column<FaceId, bool>),
    ) -> Result<Found, PassError> {
        let sides = match self.options.side {
            Side::Majority => Sides::Majority,
            Side::Outward | Side::OutwardNested => Sides::Outward,
        };
        let contradiction = match self.options.non_orientable {
            NonOrientable::Cut => Contradiction::Cuts,
            _ => Contradiction::Twists,
        };
        let mut live = LiveUses::new(kernel, names, cycles.copies(), &start.0);
        let mut patches = Patches::new(kernel, self.mesh, cycles, (sides, contradiction), start);
        let mut pairs = live.new_pairs(kernel, names, &patches.is_alive);
        if contradiction == Contradiction::Cuts {
            pairs = seams::seams_last(kernel, names, pairs);
        }
        loop {
            patches.merge(&pairs);
            let gone = patches.drop_duplicates();
            if gone.is_empty() {
                break;
            }
            self.context.check_cancelled()?;
            gone.into_iter().for_each(|face| live.remove_face(kernel, face));
            pairs = live.new_pairs(kernel, names, &patches.is_alive);
        }
        let outward = match self.options.side {
            Side::Majority => Vec::new(),
            Side::Outward => outward::judge(kernel, self.mesh, &mut patches, Nested::Outward),
            Side::OutwardNested => outward::judge(kernel, self.mesh, &mut patches, Nested::Alternating),
        };
        let non_orientable = patches.non_orientable();
        Ok(Found { is_alive: patches.is_alive, is_flipped: patches.is_flipped, non_orientable, outward })
    }

    /// Step 3: the faces that go because they are there in the other direction too.
    fn opposite_to_remove(&self, cycles: &Cycles, found: &Found) -> Vec<FaceId> {
        let mut removed = Vec::new();
        if self.options.duplicates == Duplicates::Keep {
            return removed;
        }
        for group in cycles.groups() {
            let alive = group.iter().copied().filter(|&f| found.is_alive[f]);
            let (backward, forward): (Vec<FaceId>, Vec<FaceId>) =
                alive.partition(|&f| cycles.runs_backward(f, found.is_flipped[f]));
            let pairs = backward.len().min(forward.len());
            if self.options.duplicates == Duplicates::RemovePair {
                removed.extend(backward[..pairs].iter().chain(&forward[..pairs]));
            } else if pairs > 0 {
                let first = backward[0].min(forward[0]);
                let way = |f: FaceId| cycles.runs_backward(f, found.is_flipped[f]);
                // What runs as the first does and differs from it is no opposite duplicate.
                let goes = |&f: &FaceId| f != first && (way(f) != way(first) || cycles.are_alike(f, first));
                removed.extend(backward.iter().chain(&forward).copied().filter(goes));
            }
        }
        removed
    }

    /// Step 4, and the record.
    fn outcome<K: Connectivity>(
        &self,
        kernel: &K,
        cycles: &Cycles,
        found: Found,
    ) -> Result<Outcome, PassError> {
        let has_dropped = found.is_alive.values().contains(&false);
        let mut outcome = if has_dropped {
            self.rebuilt(&found)?
        } else if found.is_flipped.values().contains(&true) {
            self.turned(&found.is_flipped)?
        } else {
            Outcome::unchanged(self.mesh)
        };
        if !outcome.provenance.is_same() {
            let dropped = self.dropped(cycles, &found);
            outcome.differed = self.differed(kernel, &dropped);
            outcome.fixed = Fixed::turned(turned_edges(kernel, &found.is_flipped), dropped);
        }
        outcome.left = self.alike_left(kernel, cycles, &found);
        let faces: Vec<FaceId> = found.outward.iter().map(PatchNamed::face).collect();
        let named = found.outward.iter().zip(self.new_ids(&found, &faces));
        outcome.left.extend(named.map(|(patch, face)| patch.defect(face)));
        if !found.non_orientable.is_empty() {
            let lowest = self.new_ids(&found, &found.non_orientable);
            self.judge_non_orientable(&mut outcome, &lowest)?;
        }
        Ok(outcome)
    }

    /// What the policy makes of patches without a consistent side.
    ///
    /// `lowest` is a face of each of them, for a mesh whose faces are not simple: there a strip may not be found.
    fn judge_non_orientable(&self, outcome: &mut Outcome, lowest: &[FaceId]) -> Result<(), PassError> {
        if self.options.non_orientable == NonOrientable::Cut {
            return Ok(());
        }
        let history = self.context.history.map(|h| h.extended(&outcome.provenance, &outcome.mesh));
        let context = Context { history: history.as_ref(), report: None, ..*self.context };
        let mut found = one_sided_patches(&outcome.mesh, &context)?;
        if found.is_empty() {
            let patch = |&face: &FaceId| Defect::non_orientable_patch(vec![face], Vec::new());
            found = lowest.iter().map(patch).collect();
        }
        if self.options.non_orientable == NonOrientable::Fail {
            return Err(PassError::Policy {
                pass: "orient",
                kind: DefectKind::NonOrientablePatch,
                defects: found,
            });
        }
        outcome.left.extend(found);
        Ok(())
    }

    fn dropped(&self, cycles: &Cycles, found: &Found) -> Vec<Defect> {
        let gone = found.is_alive.iter().filter(|(_, alive)| !**alive).map(|(face, _)| face);
        let turned = |f: FaceId| cycles.runs_backward(f, found.is_flipped[f]);
        gone.map(|face| {
            let group = cycles.group_of(face).map_or(&[][..], |group| &cycles.groups()[group]);
            let alive = || group.iter().copied().filter(|&f| found.is_alive[f]);
            match alive().find(|&f| turned(f) == turned(face) && cycles.are_alike(f, face)) {
                Some(original) => Defect::duplicate_face(face, original),
                None => Defect::opposite_face(face, alive().next().unwrap_or(face)),
            }
        })
        .collect()
    }

    /// In what faces that went differ from those that they repeat.
    fn differed<K: Connectivity>(&self, kernel: &K, dropped: &[Defect]) -> Vec<(FaceId, Differences)> {
        let Some(telling) = Telling::of(self.mesh, TellingLayers::All) else { return Vec::new() };
        let differs = |defect: &Defect| {
            let (face, original) = (defect.at.face()?, defect.beside.as_ref()?.face()?);
            let [one, other] = [face, original].map(|face| looks(kernel, self.mesh, face));
            Some((face, telling.differences(&one, &other)))
        };
        dropped.iter().filter_map(differs).filter(|(_, differs)| !differs.is_empty()).collect()
    }

    /// The mesh with faces turned and none dropped.
    fn turned(&self, is_flipped: &Column<FaceId, bool>) -> Result<Outcome, PassError> {
        let old = self.mesh.faces();
        let turns = |&face: &FaceId| is_flipped[face] && old.corner_range(face).len() > 1;
        let flipped: Vec<FaceId> = old.faces().filter(turns).collect();
        let mut corners = old.corner_vertices().to_vec();
        let mut sources: Vec<CornerId> = old.corners().collect();
        for &face in &flipped {
            // Turned round, a face begins with the same corner.
            let range = old.corner_range(face);
            corners[range.start + 1..range.end].reverse();
            sources[range.start + 1..range.end].reverse();
        }
        let faces = old.over(old.vertex_count(), corners)?;
        let faces_from = Sources::same(old.face_count());
        let draft = Draft {
            flipped,
            flipped_normals: self.options.flipped_normals,
            ..Draft::of_faces(self.mesh, faces, faces_from, sources.into())
        };
        Ok(Outcome::changed(self.mesh.rebuild(draft)?, Fixed::default()))
    }

    /// The mesh without dropped faces, and with others turned.
    fn rebuilt(&self, found: &Found) -> Result<Outcome, PassError> {
        let old = self.mesh.faces();
        let mut builder = FaceTableBuilder::default();
        let (mut face_sources, mut flipped) = (Vec::new(), Vec::new());
        let mut corner_sources = Vec::with_capacity(old.corner_count());
        for face in old.faces().filter(|&f| found.is_alive[f]) {
            let range = old.corner_range(face);
            let turns = found.is_flipped[face] && range.len() > 1;
            if turns {
                flipped.push(FaceId::new(face_sources.len()));
            }
            for place in range.clone() {
                // Turned round, a face begins with the same corner.
                let is_first = place == range.start;
                let corner = if turns && !is_first { range.start + range.end - place } else { place };
                let corner = CornerId::new(corner);
                builder.push_corner(old.corner_vertex(corner));
                corner_sources.push(Some(corner));
            }
            builder.end_face();
            face_sources.push(Some(face));
        }
        let faces = builder.build(old.vertex_count())?;
        let (faces_from, corners_from) = (Sources::listed(face_sources), Sources::listed(corner_sources));
        let draft = Draft {
            flipped,
            flipped_normals: self.options.flipped_normals,
            ..Draft::of_faces(self.mesh, faces, faces_from, corners_from)
        };
        Ok(Outcome::changed(self.mesh.rebuild(draft)?, Fixed::default()))
    }

    /// The new ids of some faces that stay.
    fn new_ids(&self, found: &Found, faces: &[FaceId]) -> Vec<FaceId> {
        let mut next = 0;
        let ids: Vec<FaceId> = found
            .is_alive
            .values()
            .iter()
            .map(|&alive| {
                next += u32::from(alive);
                FaceId(next.max(1) - 1)
            })
            .collect();
        faces.iter().map(|face| ids[face.index()]).collect()
    }

    /// Opposite duplicates, and repeated faces that differ, by the new faces' ids.
    fn alike_left<K: Connectivity>(&self, kernel: &K, cycles: &Cycles, found: &Found) -> Vec<Defect> {
        if cycles.is_empty() {
            return Vec::new();
        }
        let all: Vec<FaceId> = found.is_alive.iter().map(|(face, _)| face).collect();
        let new_id = self.new_ids(found, &all);
        let mut left = Vec::new();
        for group in cycles.groups() {
            let mut alive = group.iter().copied().filter(|&f| found.is_alive[f]);
            let Some(first) = alive.next() else { continue };
            let way = |f: FaceId| cycles.runs_backward(f, found.is_flipped[f]);
            let original = new_id[first.index()];
            let opposite = alive.filter(|&f| way(f) != way(first));
            left.extend(opposite.map(|f| Defect::opposite_face(new_id[f.index()], original)));
        }
        for (face, original, differs) in self.differing_left(kernel, cycles, found) {
            let [face, original] = [face, original].map(|face| new_id[face.index()]);
            left.push(Defect::differing_face(face, original, differs));
        }
        left.sort();
        left
    }

    /// The faces that stay, run as an earlier one does that stays too, and differ from it: face, the earlier one, in what.
    fn differing_left<K: Connectivity>(
        &self,
        kernel: &K,
        cycles: &Cycles,
        found: &Found,
    ) -> Vec<(FaceId, FaceId, Differences)> {
        let Some(telling) = Telling::of(self.mesh, self.context.telling) else { return Vec::new() };
        let mut differing = Vec::new();
        for (group, is_backward) in cycles.groups().iter().flat_map(|group| [(group, false), (group, true)]) {
            let stays = |&f: &FaceId| {
                found.is_alive[f] && cycles.runs_backward(f, found.is_flipped[f]) == is_backward
            };
            let mut faces = group.iter().copied().filter(stays);
            let Some(first) = faces.next() else { continue };
            for face in faces.filter(|&face| !cycles.are_alike(face, first)) {
                let [one, other] = [face, first].map(|face| looks(kernel, self.mesh, face));
                differing.push((face, first, telling.differences(&one, &other)));
            }
        }
        differing
    }
}

/// The inconsistent edges of which one face is turned and the other is not.
fn turned_edges<K: Connectivity>(
    kernel: &K,
    is_flipped: &Column<FaceId, bool>,
) -> Vec<(EdgeId, [VertexId; 2])> {
    let is_turned = |&edge: &EdgeId| {
        is_inconsistent(kernel, edge) && {
            let mut faces = kernel.edge_faces(edge).map(|face| is_flipped[face]);
            faces.next() != faces.next()
        }
    };
    kernel.edges().filter(is_turned).map(|edge| (edge, kernel.edge_ends(edge))).collect()
}

/// The non-orientable patches of a repair's matching, each with its witness.
///
/// Taken apart along everything that is not matched, the mesh has these patches as its own. Faces keep their ids
/// there, and edges are led back through their corners.
fn one_sided_patches(mesh: &PolygonMesh, context: &Context<'_>) -> Result<Vec<Defect>, PassError> {
    let (apart, provenance) = crate::apart::along_rules(mesh, context)?;
    let kernel = EdgeUse::assemble(apart.complex());
    let strips = orientability(&kernel, &patches_of(&kernel)).one_sided;
    let here = mesh.complex();
    let edge_here = |edge| {
        let old = |c: CornerId| provenance.corners.of(apart.complex().stored_corner(c));
        let corner = kernel.edge_corners(edge).find_map(old)?;
        here.is_as_stored().then(|| here.edges().corner_edge(corner))
    };
    let defect = |strip: OneSidedStrip| {
        let edges = strip.edges.iter().filter_map(|&edge| edge_here(edge)).collect();
        Defect::non_orientable_patch(strip.faces, edges)
    };
    Ok(strips.into_iter().map(defect).collect())
}
