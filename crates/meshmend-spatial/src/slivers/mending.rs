//! The steps, one after another, until none is left that may be made.

use std::collections::BTreeMap;

use meshmend_core::{FaceId, Id, PolygonMesh, VertexId};
use meshmend_geometry::vector::Point;

use super::SliverTask;
use super::collapse::{Collapse, collapse_of};
use super::flip::{CapStep, Flip, cap_step};
use super::ground::Ground;
use super::measure::extreme_sides;
use super::queue::Queue;
use super::record::{FoundSliver, LeftSliver, MendedSlivers, Reshaped, SliverMend, SliverReason, SliverStep};
use super::stood_for::StoodFor;
use super::surface::Faces;
use crate::shape::aspect;
use crate::{SliverKind, is_straight, shapes, sliver_kind};

/// So many steps for each sliver at the start, at most.
const MOST_STEPS: usize = 100;

/// Mends the slivers of a mesh; `None` if `goes_on` says no.
pub(super) fn mend(task: &SliverTask<'_>, goes_on: &dyn Fn() -> bool) -> Option<MendedSlivers> {
    let (found, polygons) = find(task);
    let mut mended = MendedSlivers { found, left: polygons, ..MendedSlivers::default() };
    if mended.found.len() > mended.left.len() {
        let mut mending = Mending::of(task, &mended.found);
        mending.run(goes_on)?;
        mending.give(&mut mended);
    }
    mended.left.sort_by_key(|left| left.sliver.face);
    Some(mended)
}

/// The slivers of a mesh, and those among them that are not stored as triangles: they are left.
fn find(task: &SliverTask<'_>) -> (Vec<FoundSliver>, Vec<LeftSliver>) {
    let shapes = shapes(task.mesh, task.aspect);
    let thin = shapes.slivers.iter();
    let thin = thin.map(|s| FoundSliver { face: s.face, kind: s.kind, aspect: Some(s.aspect) });
    let flat = shapes.zero_area.iter().map(|&face| {
        let points = triangle(task.mesh, face).map(|corners| corners.map(|v| task.mesh.position(v)));
        let kind = points.and_then(|points| sliver_kind(points, task.aspect)).unwrap_or(SliverKind::Cap);
        FoundSliver { face, kind, aspect: None }
    });
    let mut found: Vec<FoundSliver> = thin.chain(flat).collect();
    found.sort_by_key(|sliver| sliver.face);
    let larger = found.iter().filter(|sliver| triangle(task.mesh, sliver.face).is_none());
    let left = larger.map(|&sliver| LeftSliver { sliver, reason: SliverReason::NonTriangle });
    let left = left.collect();
    (found, left)
}

/// The corners of a face that is stored with three.
fn triangle(mesh: &PolygonMesh, face: FaceId) -> Option<[VertexId; 3]> {
    mesh.faces().face_vertices(face).try_into().ok()
}

/// A sliver with its aspect.
fn measured(face: FaceId, kind: SliverKind, points: [Point; 3]) -> FoundSliver {
    FoundSliver { face, kind, aspect: (!is_straight(&points)).then(|| aspect(points)) }
}

/// A sliver that is left for now.
struct Left {
    reason: SliverReason,
    /// How many steps had been made.
    steps: u32,
}

struct Mending<'a> {
    ground: Ground<'a>,
    queue: Queue,
    steps: Vec<SliverStep>,
    most_steps: usize,
    farthest: f64,
    left: BTreeMap<FaceId, Left>,
    /// For each vertex after how many steps a face at it was changed last.
    changed: Vec<u32>,
}

impl<'a> Mending<'a> {
    fn of(task: &SliverTask<'a>, found: &[FoundSliver]) -> Self {
        let SliverTask { mesh, aspect, reach, stood_for, attributes } = *task;
        let stood_for = StoodFor::of(mesh, stood_for);
        let ground = Ground { faces: Faces::of(mesh), stood_for, attributes, aspect, reach };
        let mut mending = Mending {
            ground,
            queue: Queue::default(),
            steps: Vec::new(),
            most_steps: MOST_STEPS.saturating_mul(found.len()).min(u32::MAX as usize),
            farthest: 0.0,
            left: BTreeMap::new(),
            changed: vec![0; mesh.counts().vertices],
        };
        found.iter().for_each(|sliver| mending.wait(sliver.face));
        mending
    }

    /// Mends until nothing more may be; says whether it was not told to stop.
    fn run(&mut self, goes_on: &dyn Fn() -> bool) -> Option<()> {
        let mut looks: u32 = 0;
        loop {
            while let Some(face) = self.queue.pop() {
                looks = looks.wrapping_add(1);
                if looks.is_multiple_of(1024) && !goes_on() {
                    return None;
                }
                self.look_at(face);
            }
            let again = self.to_judge_again();
            if again.is_empty() {
                return Some(());
            }
            again.into_iter().for_each(|face| self.wait(face));
        }
    }

    /// The slivers that are left for now, and at one of whose corners a face has changed since.
    fn to_judge_again(&self) -> Vec<FaceId> {
        let has_changed = |(face, left): &(&FaceId, &Left)| {
            let corners = self.ground.faces.of_face(**face);
            corners.iter().any(|vertex| self.changed[vertex.index()] > left.steps)
        };
        let has_steps = self.steps.len() < self.most_steps;
        self.left.iter().filter(|left| has_steps && has_changed(left)).map(|(face, _)| *face).collect()
    }

    /// Puts a face into the queue if it is a sliver.
    fn wait(&mut self, face: FaceId) {
        if let Some((kind, _, points)) = self.sliver(face) {
            self.queue.push(face, kind, points);
        }
    }

    /// A face as a sliver, if it is there and is one.
    fn sliver(&self, face: FaceId) -> Option<(SliverKind, [VertexId; 3], [Point; 3])> {
        let faces = &self.ground.faces;
        let corners = faces.triangle(face).filter(|_| faces.is_there(face))?;
        let points = faces.points(corners)?;
        Some((sliver_kind(points, self.ground.aspect)?, corners, points))
    }

    fn look_at(&mut self, face: FaceId) {
        self.left.remove(&face);
        let Some((kind, corners, points)) = self.sliver(face) else { return };
        let made = if self.steps.len() < self.most_steps {
            self.step(face, kind, corners, points)
        } else {
            Err(SliverReason::StepLimit)
        };
        match made {
            Ok(mend) => self.steps.push(SliverStep { sliver: measured(face, kind, points), mend }),
            Err(reason) => {
                self.left.insert(face, Left { reason, steps: self.steps.len() as u32 });
            }
        }
    }

    /// Makes the step that mends a sliver, if it may be made.
    fn step(
        &mut self,
        face: FaceId,
        kind: SliverKind,
        corners: [VertexId; 3],
        points: [Point; 3],
    ) -> Result<SliverMend, SliverReason> {
        let [shortest, longest] = extreme_sides(points);
        let from = |at: usize| [0, 1, 2].map(|step| corners[(at + step) % 3]);
        match kind {
            SliverKind::Needle => {
                let [one, other, _] = from(shortest);
                let collapse = collapse_of(&self.ground, [one, other])?;
                let mend = SliverMend::Collapse { from: collapse.from, into: collapse.into };
                self.collapse(face, collapse);
                Ok(mend)
            }
            SliverKind::Cap => match cap_step(&self.ground, face, from(longest))? {
                CapStep::Flip(flip) => {
                    let mend = SliverMend::Flip { edge: flip.edge, to: flip.to, with: flip.with };
                    self.flip(face, &flip);
                    Ok(mend)
                }
                CapStep::Drop => {
                    self.take_away(face);
                    Ok(SliverMend::Drop)
                }
            },
        }
    }

    fn collapse(&mut self, needle: FaceId, Collapse { from, into, kept, gone, bound }: Collapse) {
        let origin = self.ground.faces.corner(needle, into).map(|corner| self.ground.faces.origin(corner));
        gone.iter().for_each(|&face| self.take_away(face));
        let Some(origin) = origin else { return };
        kept.iter().for_each(|&face| self.ground.faces.put(face, from, into, origin));
        self.ground.stood_for.join(from, into, bound);
        self.farthest = self.farthest.max(bound);
        kept.iter().for_each(|&face| self.has_changed(face));
    }

    fn flip(&mut self, cap: FaceId, &Flip { edge: [a, b], to: [c, d], with }: &Flip) {
        let faces = &mut self.ground.faces;
        let origin = |faces: &Faces<'_>, face, vertex| faces.corner(face, vertex).map(|c| faces.origin(c));
        let (at_c, at_d) = (origin(faces, cap, c), origin(faces, with, d));
        let Some((at_c, at_d)) = at_c.zip(at_d) else { return };
        faces.put(cap, b, d, at_d);
        faces.put(with, a, c, at_c);
        self.mark([a, b, c, d]);
        [cap, with].into_iter().for_each(|face| self.has_changed(face));
    }

    fn take_away(&mut self, face: FaceId) {
        if let Some(corners) = self.ground.faces.triangle(face) {
            self.mark(corners);
        }
        self.left.remove(&face);
        self.ground.faces.remove(face);
    }

    /// Puts a face that a step has changed back into the queue.
    fn has_changed(&mut self, face: FaceId) {
        self.left.remove(&face);
        if let Some(corners) = self.ground.faces.triangle(face) {
            self.mark(corners);
        }
        self.wait(face);
    }

    /// Notes that the step under way has changed a face at some vertices.
    fn mark<const N: usize>(&mut self, vertices: [VertexId; N]) {
        let step = self.steps.len() as u32 + 1;
        vertices.into_iter().for_each(|vertex| self.changed[vertex.index()] = step);
    }

    /// What was done and what is left.
    fn give(self, mended: &mut MendedSlivers) {
        let left = self.left.iter().filter_map(|(&face, left)| {
            let (kind, _, points) = self.sliver(face)?;
            Some(LeftSliver { sliver: measured(face, kind, points), reason: left.reason })
        });
        mended.left.extend(left);
        (mended.steps, mended.farthest) = (self.steps, self.farthest);
        if !mended.steps.is_empty() {
            let (vertices, origins, is_gone) = self.ground.faces.into_parts();
            mended.reshaped = Some(Reshaped { vertices, origins, is_gone });
        }
    }
}
