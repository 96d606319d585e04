//! The figures that only surfaces have.

use super::{Reason, Undefined};
use crate::Surface;
use crate::surfaces::component_kinds::ComponentFacts;

/// The figures that only surfaces have, summed over the components.
pub(super) struct SurfaceTotals {
    pub(super) boundary_loops: Option<u64>,
    pub(super) genus: Option<u64>,
    pub(super) cross_caps: Option<u64>,
}

impl SurfaceTotals {
    pub(super) fn of(components: &[ComponentFacts]) -> Self {
        let surfaces = || components.iter().map(ComponentFacts::surface);
        if surfaces().any(|surface| surface.is_none()) {
            return SurfaceTotals { boundary_loops: None, genus: None, cross_caps: None };
        }
        let total = |figure: fn(Surface) -> Option<u64>| {
            surfaces()
                .flatten()
                .filter_map(figure)
                .fold(None, |sum: Option<u64>, one| Some(sum.unwrap_or(0) + one))
        };
        SurfaceTotals {
            boundary_loops: Some(surfaces().flatten().map(Surface::holes).sum()),
            genus: total(Surface::genus),
            cross_caps: total(Surface::cross_caps),
        }
    }

    /// Which of them are absent, and why.
    pub(super) fn undefined(&self, has_components: bool) -> Vec<Undefined> {
        let not_all_manifold = self.boundary_loops.is_none();
        let why = |otherwise| match (has_components, not_all_manifold) {
            (false, _) => Reason::NoFaces,
            (true, true) => Reason::NonManifoldComponent,
            (true, false) => otherwise,
        };
        let figures = [
            ("boundary_loops", self.boundary_loops, Reason::NonManifoldComponent),
            ("genus", self.genus, why(Reason::NoOrientableComponent)),
            ("cross_caps", self.cross_caps, why(Reason::NoNonOrientableComponent)),
        ];
        let absent = figures.into_iter().filter(|(_, value, _)| value.is_none());
        absent.map(|(figure, _, reason)| Undefined { figure, reason }).collect()
    }
}
