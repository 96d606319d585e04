//! How far a vertex is from all those, as stored, that went into it.

use meshmend_core::{Id, PolygonMesh, VertexId};
use meshmend_geometry::vector::{Point, length, minus};

use super::measure::are_within;

/// The vertices that went into each vertex, and how far they are from it at most.
pub(super) struct StoodFor<'a> {
    mesh: &'a PolygonMesh,
    /// Points as stored that vertices stand for beside their own, ascending by vertex.
    stored: &'a [(VertexId, Point)],
    /// The next vertex in the ring of those that became one.
    next: Vec<VertexId>,
    /// No point that a vertex stands for is farther from it.
    bound: Vec<f64>,
}

/// Less than this a length can't be told from its square.
const LEAST: f64 = 1e-70;
/// More than rounding takes away from a length.
const ROUND_UP: f64 = 1.0 + 1e-12;

impl<'a> StoodFor<'a> {
    pub(super) fn of(mesh: &'a PolygonMesh, stored: &'a [(VertexId, Point)]) -> Self {
        let count = mesh.counts().vertices;
        let mut bound = vec![0.0; count];
        for &(vertex, point) in stored {
            let place = &mut bound[vertex.index()];
            *place = distance(mesh.position(vertex), point).max(*place);
        }
        StoodFor { mesh, stored, next: (0..count).map(VertexId::new).collect(), bound }
    }

    /// A bound of how far all that a vertex stands for is from another vertex, if none of it is farther than a reach.
    ///
    /// *Cost*: constant, or linear in what it stands for where the bound does not tell.
    pub(super) fn bound_at(&self, from: VertexId, into: VertexId, reach: f64) -> Option<f64> {
        let place = self.mesh.position(into);
        let bound = (self.bound[from.index()] + distance(self.mesh.position(from), place)) * ROUND_UP;
        if bound < reach {
            return Some(bound);
        }
        let mut farthest: f64 = 0.0;
        let mut vertex = from;
        loop {
            for point in self.points(vertex) {
                if !are_within(point, place, reach) {
                    return None;
                }
                farthest = farthest.max(distance(point, place));
            }
            vertex = self.next[vertex.index()];
            if vertex == from {
                return Some(farthest);
            }
        }
    }

    /// A vertex goes into another one, from which all that it stands for is not farther than a bound.
    pub(super) fn join(&mut self, from: VertexId, into: VertexId, bound: f64) {
        self.next.swap(from.index(), into.index());
        let place = &mut self.bound[into.index()];
        *place = place.max(bound);
    }

    /// The vertex itself, and the points as stored behind it.
    fn points(&self, vertex: VertexId) -> impl Iterator<Item = Point> {
        let first = self.stored.partition_point(|(other, _)| *other < vertex);
        let stored = self.stored[first..].iter().take_while(move |(other, _)| *other == vertex);
        std::iter::once(self.mesh.position(vertex)).chain(stored.map(|&(_, point)| point))
    }
}

/// The distance of two points, rounded up.
fn distance(one: Point, other: Point) -> f64 {
    if one == other { 0.0 } else { length(minus(one, other)).max(LEAST) * ROUND_UP }
}
