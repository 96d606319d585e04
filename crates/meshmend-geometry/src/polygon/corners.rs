//! A polygon in space, and its corners by their places.

use meshmend_core::VertexId;

use crate::vector::Point;

/// A polygon in space. Its corners are named after their places.
#[derive(Clone, Copy, Debug)]
pub struct Polygon<'a> {
    /// The point of each corner.
    pub points: &'a [Point],
    /// The vertex at which each corner stands.
    pub vertices: &'a [VertexId],
}

impl Polygon<'_> {
    pub(super) fn len(&self) -> usize {
        self.points.len()
    }

    pub(super) fn vertex(&self, corner: usize) -> VertexId {
        self.vertices[corner]
    }
}

/// Three corners of a polygon, by their places, the way round that the polygon has.
pub type Triangle = [usize; 3];

/// Whether two places of a polygon are neighbours.
pub(super) fn are_neighbours(count: usize, one: usize, other: usize) -> bool {
    one.abs_diff(other) == 1 || one.abs_diff(other) == count - 1
}
