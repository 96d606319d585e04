//! Which boundary loops are to be filled, and why the others are not.

use meshmend_core::{Connectivity, CornerId, FaceId, Id, PolygonMesh, VertexId};
use meshmend_geometry::vector::{Point, length};
use meshmend_kernels::KernelTask;
use meshmend_spatial::{LoopKind, NoSide, OpenLoop, open_loops};
use meshmend_topology::{ComponentId, components};

use super::borders::Borders;
use super::limits::{FillLoops, Reach};
use super::record::LeftOpen;
use super::{Fill, FillRims};
use crate::{Context, PassError};

/// A boundary loop, and what is to be done with it.
pub(super) struct Judged {
    pub(super) found: OpenLoop,
    /// The sides of a loop that is to be filled, or why it is not.
    pub(super) verdict: Result<Vec<SideBeside>, LeftOpen>,
}

/// A side of a loop as the fill runs along it: from a vertex of the loop to the one before.
#[derive(Clone, Copy, Debug)]
pub(super) struct SideBeside {
    /// Where the fill's side begins.
    pub(super) from: VertexId,
    /// The side of the loop along which it lies, in the mesh's complex.
    pub(super) side: CornerId,
    /// The face beside it.
    pub(super) face: FaceId,
    /// The two corners of the mesh at `from` that lie along the loop.
    pub(super) corners: [CornerId; 2],
}

/// The boundary loops of a mesh, by lowest vertex, each with what is to be done.
pub(super) fn judged(
    options: &Fill,
    mesh: &PolygonMesh,
    context: &Context<'_>,
) -> Result<Vec<Judged>, PassError> {
    let complex = mesh.complex();
    context.check_cancelled()?;
    context.kernel.run_on_all_vertices(complex, Judge { options, mesh, context })?
}

struct Judge<'a> {
    options: &'a Fill,
    mesh: &'a PolygonMesh,
    context: &'a Context<'a>,
}

impl KernelTask for Judge<'_> {
    type Output = Result<Vec<Judged>, PassError>;

    fn run<K: Connectivity>(self, kernel: &K) -> Self::Output {
        self.context.check_cancelled()?;
        let loops = open_loops(kernel, self.mesh, self.context.watch())?;
        if loops.is_empty() {
            return Ok(Vec::new());
        }
        self.context.check_cancelled()?;
        let borders = Borders::of(kernel);
        let diagonals = self.diagonals(kernel);
        self.context.check_cancelled()?;
        let judge = |found: OpenLoop| {
            let reason = self.reason_to_leave(&found, &diagonals);
            let sides = || self.sides(kernel, &borders, &found.vertices).ok_or(LeftOpen::NotSimple);
            let verdict = reason.map_or_else(sides, Err);
            let verdict = verdict.and_then(|sides| {
                if is_back_of_a_face(kernel, &sides) { Err(LeftOpen::LoneFace) } else { Ok(sides) }
            });
            Judged { found, verdict }
        };
        Ok(loops.into_iter().map(judge).collect())
    }
}

impl Judge<'_> {
    fn reason_to_leave(&self, found: &OpenLoop, diagonals: &[f64]) -> Option<LeftOpen> {
        match found.kind {
            LoopKind::Undecided(NoSide::NotFinite) => return Some(LeftOpen::NotFinite),
            LoopKind::Undecided(_) => return Some(LeftOpen::NoSide),
            LoopKind::Rim | LoopKind::Hole => {}
        }
        if found.is_of_lone_face {
            return Some(LeftOpen::LoneFace);
        }
        if found.kind == LoopKind::Rim && self.options.rims == FillRims::Leave {
            return Some(LeftOpen::Rim);
        }
        let FillLoops::Within(limits) = self.options.loops else { return None };
        let diagonal = diagonals.get(found.component.index()).copied().unwrap_or(0.0);
        let is_beyond = |limit: Option<f64>, size: f64| limit.is_some_and(|limit| size > limit);
        if limits.edges.is_some_and(|most| found.vertices.len() > most as usize) {
            Some(LeftOpen::Edges)
        } else if is_beyond(limits.length.map(|reach| reach.length(diagonal)), found.length) {
            Some(LeftOpen::Length)
        } else if is_beyond(limits.area.map(|reach| reach.area(diagonal)), found.area) {
            Some(LeftOpen::Area)
        } else {
            None
        }
    }

    /// The sides of a simple loop in the order in which its fill runs along them.
    fn sides<K: Connectivity>(
        &self,
        kernel: &K,
        borders: &Borders,
        vertices: &[VertexId],
    ) -> Option<Vec<SideBeside>> {
        let sides = borders.sides(kernel, vertices).filter(|_| borders.is_simple(vertices))?;
        let stored = |corner| self.mesh.complex().stored_corner(corner);
        let count = vertices.len();
        // The fill runs against the loop: its side from a vertex lies along the loop's side to that vertex.
        let beside = |place: usize| {
            let before = sides[(place + count - 1) % count];
            SideBeside {
                from: vertices[place],
                side: before,
                face: kernel.corner_face(before),
                corners: [stored(kernel.next_corner(before)), stored(sides[place])],
            }
        };
        Some((0..count).rev().map(beside).collect())
    }

    /// For each component how long the diagonal of its bounding box is, if a limit asks.
    fn diagonals<K: Connectivity>(&self, kernel: &K) -> Vec<f64> {
        let is_relative = |reach: Option<Reach>| matches!(reach, Some(Reach::Relative(_)));
        match self.options.loops {
            FillLoops::Within(limits) if is_relative(limits.length) || is_relative(limits.area) => {}
            _ => return Vec::new(),
        }
        let components = components(kernel);
        let empty = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        let mut boxes: Vec<[Point; 2]> = vec![empty; components.count()];
        for vertex in kernel.vertices() {
            let Some(component) = components.of_vertex(vertex) else { continue };
            let (point, [low, high]) =
                (self.mesh.position(vertex), &mut boxes[ComponentId::index(component)]);
            for axis in 0..3 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let diagonal = |[low, high]: [Point; 2]| length(std::array::from_fn(|axis| high[axis] - low[axis]));
        boxes.into_iter().map(diagonal).collect()
    }
}

/// Whether a loop runs round one triangle that meets others at a vertex alone. Its fill would be the back of that triangle.
fn is_back_of_a_face<K: Connectivity>(kernel: &K, sides: &[SideBeside]) -> bool {
    let first = sides.first().map(|side| side.face);
    let is_triangle = first.is_some_and(|face| kernel.face_corners(face).count() == 3);
    sides.len() == 3 && is_triangle && sides.iter().all(|side| Some(side.face) == first)
}
