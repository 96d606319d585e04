//! Which passes need others before them, and which can't be together.

use crate::{Internal, PassKind, Plan, PlanError, SplitEdges};

impl Plan {
    /// Whether each pass comes after those without which it can't keep its promise, and none undoes in a second run what another
    /// did.
    ///
    /// # Errors
    /// The first reason why not:
    /// * `heal` runs twice, or without `orient` before it: they take turns until nothing is healed.
    /// * `fill` runs with what opens again what it closes, or leaves crowded edges at which it would close more in every run.
    /// * `slivers` runs before `triangulate`, and so would see no triangles yet.
    /// * `apart` runs without `weld`, and so would move all corners of a file without indices apart.
    pub fn check_order(&self) -> Result<(), PlanError> {
        let first = |kind: PassKind| self.passes.iter().position(|&pass| pass == kind);
        let runs = |kind: PassKind| first(kind).is_some();
        let comes_before = |kind: PassKind, later: PassKind| {
            first(later).is_none_or(|later| first(kind).is_some_and(|earlier| earlier < later))
        };
        let heals = self.passes.iter().filter(|&&pass| pass == PassKind::Heal).count();
        let opens = runs(PassKind::DropParts) && self.drop.internal == Internal::RemoveFaces;
        let crowds = runs(PassKind::Split) && self.split.edges == SplitEdges::PinchOnly;
        let is_cut_later = |slivers: usize| self.passes[slivers..].contains(&PassKind::Triangulate);
        let rules = [
            (heals > 1, "`heal` stands in a plan once: it goes on until nothing is healed"),
            (
                !comes_before(PassKind::Orient, PassKind::Heal),
                "`heal` needs `orient` before it: they take turns until nothing is healed",
            ),
            (
                opens && runs(PassKind::Fill),
                "`fill` would close again what `drop` opens by `internal = \"remove-faces\"`; take `remove-components`, or one \
                 repair after the other",
            ),
            (
                crowds && runs(PassKind::Fill),
                "`fill` needs edges of two sides, and `split` leaves others by `edges = \"pinch-only\"`",
            ),
            (
                first(PassKind::Slivers).is_some_and(is_cut_later),
                "`slivers` mends triangles, so `triangulate` has to come before it",
            ),
            (
                !comes_before(PassKind::Weld, PassKind::KeepApart),
                "`apart` needs `weld` before it: without it all corners of a file without indices are vertices of their own",
            ),
        ];
        match rules.into_iter().find(|(is_broken, _)| *is_broken) {
            Some((_, reason)) => Err(PlanError::new(reason.to_owned())),
            None => Ok(()),
        }
    }
}
