//! Room for new vertices that is looked for late.

use crate::vector::Point;
use crate::{FreePoints, OnDiagonal, Room};

/// Room whose points are gathered when a place is first asked for: most meshes need none.
pub struct GatheredRoom<G> {
    gather: G,
    free: Option<FreePoints>,
}

impl<G: FnMut() -> FreePoints> GatheredRoom<G> {
    /// Room beside the points that a function gathers.
    pub fn new(gather: G) -> Self {
        GatheredRoom { gather, free: None }
    }

    /// The free points, gathered.
    ///
    /// *Cost*: that of gathering them, once.
    pub fn free(&mut self) -> &mut FreePoints {
        self.free.get_or_insert_with(&mut self.gather)
    }
}

impl<G: FnMut() -> FreePoints> Room for GatheredRoom<G> {
    fn is_between(&mut self, ends: [Point; 2]) -> bool {
        self.free().is_room_on_edge(ends)
    }
    fn take_between(&mut self, ends: [Point; 2]) -> OnDiagonal {
        self.free().on_edge(ends)
    }
}
