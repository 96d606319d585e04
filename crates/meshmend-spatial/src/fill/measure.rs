//! What a fill costs.

use std::cmp::Ordering;

use meshmend_geometry::polygon::Triangle;
use meshmend_geometry::vector::Point;

use super::facet::Facet;
use super::neighbours::{Across, neighbours, sides_of};
use super::scaled::Scaled;
use super::{FillBy, Opening};

/// What a fill costs, the worst first.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FillCost {
    /// How many triangles have all corners on one line.
    pub zero_area: usize,
    /// The greatest of 1 − cos of the angle between the directions on both sides of a side, those of the loop included; what has
    /// zero area does not count.
    pub fold: f64,
    /// The sum of all areas.
    pub area: f64,
}

impl FillCost {
    /// Which of two fills is the better one.
    pub(super) fn compared(&self, other: &FillCost, by: FillBy) -> Ordering {
        let fold = match by {
            FillBy::Fold => self.fold.total_cmp(&other.fold),
            FillBy::Area => Ordering::Equal,
        };
        self.zero_area.cmp(&other.zero_area).then(fold).then(self.area.total_cmp(&other.area))
    }
}

/// What the triangles of a fill cost; `None` if they do not fill the opening admissibly.
///
/// *Cost*: O(n log n).
pub(super) fn measure(opening: &Opening<'_>, scaled: &Scaled, triangles: &[Triangle]) -> Option<FillCost> {
    let across = neighbours(triangles, scaled.len())?;
    if triangles.iter().zip(&across).any(|(&triangle, across)| is_barred(opening, triangle, across)) {
        return None;
    }
    let facets: Vec<Facet> = triangles.iter().map(|&triangle| scaled.facet(triangle)).collect();
    let mut cost = FillCost::default();
    for (facet, across) in facets.iter().zip(&across) {
        cost.zero_area += usize::from(facet.is_flat);
        cost.area += facet.area;
        for &across in across {
            let other = match across {
                Across::Loop(corner) => scaled.beside(corner),
                Across::Triangle(other) => facets[other].direction,
            };
            cost.fold = cost.fold.max(facet.direction.fold(other));
        }
    }
    Some(FillCost { area: scaled.unscaled_area(cost.area), ..cost })
}

/// Whether a triangle is there already, or an edge joins two of its corners.
fn is_barred(opening: &Opening<'_>, triangle: Triangle, across: &[Across; 3]) -> bool {
    let is_taken = |([one, other], across): ([usize; 2], &Across)| {
        matches!(across, Across::Triangle(_)) && (opening.is_joined)(one, other)
    };
    (opening.is_there)(triangle) || sides_of(triangle).into_iter().zip(across).any(is_taken)
}

/// What the fan costs that joins all sides of an opening to a point.
///
/// *Cost*: linear.
pub fn fan_cost(opening: &Opening<'_>, centre: Point) -> FillCost {
    let scaled = Scaled::of(opening);
    let (count, centre) = (scaled.len(), scaled.scaled(centre));
    let facet = |corner: usize| {
        let next = if corner + 1 == count { 0 } else { corner + 1 };
        Facet::of([scaled.point(corner), scaled.point(next), centre])
    };
    let mut cost = FillCost::default();
    let mut last = facet(count.saturating_sub(1));
    for corner in 0..count {
        let here = facet(corner);
        cost.zero_area += usize::from(here.is_flat);
        cost.area += here.area;
        let folds = [here.direction.fold(last.direction), here.direction.fold(scaled.beside(corner))];
        cost.fold = folds.into_iter().fold(cost.fold, f64::max);
        last = here;
    }
    FillCost { area: scaled.unscaled_area(cost.area), ..cost }
}
