//! What passes that create vertices keep clear of.

use meshmend_core::{Id, PolygonMesh};
use meshmend_geometry::{FreePoints, Precision, Spacing};

/// What a pass that creates vertices keeps clear of, so that they are there when the result is read again.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clearance {
    /// How precisely the result is stored.
    pub precision: Precision,
    /// How precisely positions are told apart when the result is welded.
    pub apart: Precision,
    /// Vertices within this distance of each other become one when the result is welded; 0 if only equal ones do.
    pub tolerance: f64,
    /// What becomes of vertices that no face uses.
    pub unused: Unused,
    /// Where vertices go that tell edges apart.
    pub subdivision: Subdivision,
}

/// Where the vertices go that are put into edges which would coincide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Subdivision {
    /// Those of edges at one place into one point: they are told apart by what names them.
    #[default]
    InOnePoint,
    /// Each into a point of its own, as a later weld joins what is at one.
    InOwnPoints,
}

/// What becomes of vertices that no face uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unused {
    /// They are part of the result.
    #[default]
    Kept,
    /// They go, so that a new vertex may take their place.
    Removed,
}

impl Clearance {
    /// How far a created vertex has to be from all others.
    pub(crate) fn spacing(&self) -> Spacing {
        Spacing { precision: self.precision, apart: self.apart, tolerance: self.tolerance }
    }

    /// Where there is room beside the vertices of a mesh.
    ///
    /// *Cost*: O(n log n).
    pub(crate) fn free_points(&self, mesh: &PolygonMesh) -> FreePoints {
        let mut is_used = vec![false; mesh.counts().vertices];
        mesh.faces().corner_vertices().iter().for_each(|v| is_used[v.index()] = true);
        let is_in_result = |v: usize| self.unused == Unused::Kept || is_used[v];
        let vertices = mesh.positions().iter().enumerate().filter(|(v, _)| is_in_result(*v));
        FreePoints::beside(self.spacing(), vertices.map(|(_, &position)| position))
    }
}
