//! A hole as its fill sees it.

use meshmend_core::VertexId;
use meshmend_geometry::vector::Point;

/// A boundary loop as its fill runs round it, against the faces beside it. Its corners are named after their places.
///
/// All lists have one entry for each corner.
pub struct Opening<'a> {
    /// Where each corner is.
    pub points: &'a [Point],
    /// At which vertex each corner stands.
    pub vertices: &'a [VertexId],
    /// The direction of the face beside the side that begins at each corner, of any length; zero where it has none. See
    /// [`direction_of_face`](super::direction_of_face).
    pub beside: &'a [Point],
    /// Whether an edge joins two corners that are not neighbours.
    pub is_joined: &'a dyn Fn(usize, usize) -> bool,
    /// Whether three corners have a triangle already, either way round.
    pub is_there: &'a dyn Fn([usize; 3]) -> bool,
}

impl std::fmt::Debug for Opening<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Opening").field("vertices", &self.vertices).finish_non_exhaustive()
    }
}
