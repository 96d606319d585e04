//! Fills the loops of one round.

use std::borrow::Cow;

use meshmend_core::{CornerId, PolygonMesh, Provenance, VertexId};
use meshmend_geometry::{Edges, GatheredRoom};
use meshmend_spatial::Surface;
use rayon::prelude::*;

use super::built::Built;
use super::crossing::{Covered, crossings};
use super::hole::{Choice, Cover, Hole};
use super::judging::Judged;
use super::places::TrianglesByPlace;
use super::record::{FillCrossing, LeftOpen, LoopFate, LoopRecord};
use super::{CrossingFills, Fill};
use crate::{Context, PassError};

/// What a round of filling gives.
pub(super) struct Filled {
    /// Each loop with what became of it.
    pub(super) records: Vec<LoopRecord>,
    /// The mesh and where its elements come from, if any loop was filled.
    pub(super) mesh: Option<(PolygonMesh, Provenance)>,
    /// The sides of the boundary that were closed, in the mesh's complex.
    pub(super) closed: Vec<CornerId>,
}

/// Fills the loops that are to be filled.
pub(super) fn filled(
    options: &Fill,
    mesh: &PolygonMesh,
    judged: &[Judged],
    context: &Context<'_>,
) -> Result<Filled, PassError> {
    let holes: Vec<Hole<'_>> =
        judged.par_iter().filter_map(|judged| Some(Hole::of(mesh, judged.verdict.as_ref().ok()?))).collect();
    context.check_cancelled()?;
    let mut built = Built::of(mesh);
    context.check_cancelled()?;
    let mut fates = Vec::new();
    if !holes.is_empty() {
        let mut room = GatheredRoom::new(|| context.clearance.free_points(mesh));
        let choices = choices(options, mesh, &holes, context)?.into_iter();
        let covers: Vec<Result<Cover, LeftOpen>> =
            choices.zip(&holes).map(|(choice, hole)| hole.cover(choice, &mut room)).collect();
        context.check_cancelled()?;
        let covered: Vec<Covered<'_>> =
            holes.iter().zip(covers.iter().map(|cover| cover.as_ref().ok())).collect();
        let is_made =
            |crossing: Option<&FillCrossing>| options.crossing == CrossingFills::Keep || crossing.is_none();
        let surface = Surface::watched(mesh, context.watch())?;
        context.check_cancelled()?;
        let crossings = crossings(&surface, &covered, is_made)?;
        context.check_cancelled()?;
        for ((hole, cover), crossing) in holes.iter().zip(&covers).zip(crossings) {
            let made = cover.as_ref().ok().filter(|_| is_made(crossing.as_ref()));
            made.iter().for_each(|cover| built.add(hole, cover));
            fates.push((fate(cover, made), crossing));
        }
    }
    let mut fates = fates.into_iter();
    let record = |judged: &Judged| {
        let (fate, crossing) = match judged.verdict {
            Err(left) => (LoopFate::Left { left }, None),
            Ok(_) => fates.next().unwrap_or((LoopFate::Left { left: LeftOpen::Flat }, None)),
        };
        let found = &judged.found;
        let first_vertex = found.vertices.first().copied().unwrap_or(VertexId(0));
        let (edges, length, turned) = (found.vertices.len(), found.length, found.turned);
        LoopRecord { first_vertex, edges, length, turned, fate, crossing }
    };
    context.check_cancelled()?;
    let records = judged.iter().map(record).collect();
    Ok(Filled { records, closed: built.take_closed(), mesh: built.mesh()? })
}

/// What is best for each hole.
///
/// Holes whose vertices have places of their own can't get the same triangles, so they are looked at all at once; the others one
/// after another.
fn choices(
    options: &Fill,
    mesh: &PolygonMesh,
    holes: &[Hole<'_>],
    context: &Context<'_>,
) -> Result<Vec<Choice>, PassError> {
    let edges = Edges::new(Cow::Borrowed(mesh.complex().edges().all_ends()), mesh.counts().vertices);
    let mut there = TrianglesByPlace::of(mesh, context.clearance);
    context.check_cancelled()?;
    let at_once = |(place, hole): (usize, &Hole<'_>)| {
        context.look(place, holes.len())?;
        Ok(hole.is_apart(&there).then(|| hole.choice(options, &edges, &there)))
    };
    let first =
        holes.par_iter().enumerate().map(at_once).collect::<Result<Vec<Option<Choice>>, PassError>>()?;
    let in_turn = |(choice, hole): (Option<Choice>, &Hole<'_>)| {
        if let Some(choice) = choice {
            return Ok(choice);
        }
        context.check_cancelled()?;
        let choice = hole.choice(options, &edges, &there);
        if let Choice::Triangles(fill) = &choice {
            let triangles = fill.triangles.iter().map(|t| t.map(|corner| hole.vertices[corner]));
            triangles.for_each(|triangle| there.add(triangle));
        }
        Ok(choice)
    };
    first.into_iter().zip(holes).map(in_turn).collect()
}

/// What becomes of a loop with its cover, if it has one, and if that is made.
fn fate(cover: &Result<Cover, LeftOpen>, made: Option<&Cover>) -> LoopFate {
    match (cover, made) {
        (Err(left), _) => LoopFate::Left { left: *left },
        (Ok(_), None) => LoopFate::Left { left: LeftOpen::Crossing },
        (_, Some(Cover { shape, triangles, cost, .. })) => {
            LoopFate::Filled { fill: *shape, faces: triangles.len(), fold: cost.fold, area: cost.area }
        }
    }
}
