//! The figures that only surfaces have.

use super::{Reason, Undefined};
use crate::ComponentKind;

/// The figures that only surfaces have, summed over the components.
pub(super) struct SurfaceTotals {
    pub(super) boundary_loops: Option<u64>,
    pub(super) genus: Option<u64>,
    pub(super) cross_caps: Option<u64>,
}

impl SurfaceTotals {
    pub(super) fn of(kinds: &[ComponentKind]) -> Self {
        if kinds.iter().any(|kind| kind.boundary_loops.is_none()) {
            return SurfaceTotals { boundary_loops: None, genus: None, cross_caps: None };
        }
        let total = |figure: fn(&ComponentKind) -> Option<u64>| {
            let figures = kinds.iter().filter_map(|kind| Some(kind.count * figure(kind)?));
            figures.fold(None, |sum: Option<u64>, one| Some(sum.unwrap_or(0) + one))
        };
        SurfaceTotals {
            boundary_loops: Some(total(|kind| kind.boundary_loops).unwrap_or(0)),
            genus: total(|kind| kind.genus),
            cross_caps: total(|kind| kind.cross_caps),
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
