//! Fills of large openings: what triangulating the polygon gives, and ears in the order of their folds, each made better by
//! flipping diagonals. The best one is taken.

use meshmend_geometry::polygon::{Avoid, Polygon, Triangle, triangulate_polygon};

use super::ears::by_ears;
use super::flips::flipped;
use super::measure::{FillCost, measure};
use super::neighbours::ascending;
use super::scaled::Scaled;
use super::{FillBy, Opening};

/// The best admissible fill that was found.
///
/// *Cost*: O(n log n), where triangulating the polygon takes no longer.
pub(super) fn best_candidate(opening: &Opening<'_>, scaled: &Scaled, by: FillBy) -> Option<Vec<Triangle>> {
    let polygon = Polygon { points: opening.points, vertices: opening.vertices };
    let cut = |avoid| {
        let triangles = triangulate_polygon(polygon, avoid, opening.is_joined);
        triangles.into_iter().map(ascending).collect::<Vec<Triangle>>()
    };
    let candidates =
        [Some(cut(Avoid::Folds)), Some(cut(Avoid::TakenDiagonals)), by_ears(opening, scaled, by)];
    let mut best: Option<(FillCost, Vec<Triangle>)> = None;
    for triangles in candidates.into_iter().flatten() {
        if measure(opening, scaled, &triangles).is_none() {
            continue;
        }
        let triangles = flipped(opening, scaled, triangles, by);
        let Some(cost) = measure(opening, scaled, &triangles) else { continue };
        if best.as_ref().is_none_or(|(least, _)| cost.compared(least, by).is_lt()) {
            best = Some((cost, triangles));
        }
    }
    best.map(|(_, mut triangles)| {
        triangles.sort_unstable();
        triangles
    })
}
