//! What is asked of positions, and holes that are filled.

use meshmend::Pass;
use meshmend::mesh::{Build, EdgeUse};
use meshmend::passes::{Context, Fill, FillLoops};
use meshmend::spatial::{IntersectionOptions, Surface, intersections as intersecting};
use meshmend::topology::topology;
use meshmend::{PassError, PolygonMesh};

use super::{Answer, figures};
use crate::failure::Failure;

/// Pairs that are listed, as by the command.
const LISTED: usize = 100;

pub(super) fn intersections(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let surface = Surface::of(mesh).map_err(PassError::from)?;
    let options = IntersectionOptions { limit: LISTED, ..IntersectionOptions::default() };
    let found = intersecting(&surface, options)?;
    Ok(Box::new(move || {
        let count = found.figures.map_or(u64::MAX, |figures| figures.crossing_faces as u64);
        Ok(figures([("crossing_faces", count)]))
    }))
}

/// With all the new faces tested against what is there and each other.
pub(super) fn fill(mesh: &PolygonMesh) -> Result<Answer, Failure> {
    let fill = Fill { loops: FillLoops::All, ..Fill::default() };
    let filled = fill.apply(mesh, &Context::default())?.mesh;
    Ok(Box::new(move || {
        let found = topology(&EdgeUse::build(filled.complex())?, &filled);
        let (boundary, non_manifold) = (found.boundary_edges, found.non_manifold_edges);
        Ok(figures([("boundary_edges", boundary), ("non_manifold_edges", non_manifold)]))
    }))
}
