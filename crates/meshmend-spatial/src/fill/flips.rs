//! Makes a fill better by flipping diagonals, as long as that lowers the greatest fold round one.
//!
//! A flip lowers the list of all folds, the greatest first, so the whole ends; the greatest of all never rises.

use std::collections::VecDeque;

use meshmend_geometry::polygon::Triangle;

use super::facet::{Direction, Facet};
use super::measure::FillCost;
use super::neighbours::{Across, Side, ascending, neighbours, sides_of};
use super::scaled::Scaled;
use super::{EQUAL, FillBy, Opening};

/// For each triangle so many flips are made at most.
const MOST_FLIPS: usize = 16;

/// An admissible fill, made better by flips. What is not a fill stays as it is.
///
/// *Cost*: O(n log n).
pub(super) fn flipped(
    opening: &Opening<'_>,
    scaled: &Scaled,
    triangles: Vec<Triangle>,
    by: FillBy,
) -> Vec<Triangle> {
    let Some(across) = neighbours(&triangles, scaled.len()) else { return triangles };
    let facets = triangles.iter().map(|&triangle| scaled.facet(triangle)).collect();
    let mut left = MOST_FLIPS * triangles.len();
    let mut waiting: VecDeque<(usize, Side)> =
        triangles.iter().enumerate().map(|(at, &[a, _, c])| (at, [a, c])).collect();
    let mut patch = Patch { opening, scaled, by, triangles, across, facets };
    while let Some((triangle, side)) = waiting.pop_front() {
        let Some(flip) = patch.flip(triangle, side) else { continue };
        if left == 0 {
            break;
        }
        left -= 1;
        for &(of, outer, _) in &flip.outer {
            waiting.push_back((flip.pair[of], outer));
        }
        patch.make(flip);
    }
    patch.triangles
}

/// A fill whose diagonals are flipped.
struct Patch<'a> {
    opening: &'a Opening<'a>,
    scaled: &'a Scaled,
    by: FillBy,
    triangles: Vec<Triangle>,
    across: Vec<[Across; 3]>,
    facets: Vec<Facet>,
}

/// A diagonal that is to be flipped.
struct Flip {
    /// The two triangles beside it.
    pair: [usize; 2],
    /// These as they will be, and their facets.
    triangles: [Triangle; 2],
    facets: [Facet; 2],
    /// The diagonal as it will be.
    diagonal: Side,
    /// The four sides round both: which of the new triangles has it, its ends, and what lies across it.
    outer: [(usize, Side, Across); 4],
}

impl Patch<'_> {
    /// The flip of a side of a triangle, if it is a diagonal, may be flipped, and that makes the fill better.
    fn flip(&self, one: usize, side: Side) -> Option<Flip> {
        let Across::Triangle(other) = self.across_side(one, side)? else { return None };
        let pair = [one, other];
        let [from, to] = side;
        let mut apexes = [0; 2];
        for (apex, &triangle) in apexes.iter_mut().zip(&pair) {
            *apex = self.triangles[triangle].into_iter().find(|&corner| corner != from && corner != to)?;
        }
        let [a, b] = apexes;
        let diagonal = [a.min(b), a.max(b)];
        let triangles = [ascending([from, a, b]), ascending([to, a, b])];
        let is_there = |&triangle: &Triangle| (self.opening.is_there)(triangle);
        if (self.opening.is_joined)(diagonal[0], diagonal[1]) || triangles.iter().any(is_there) {
            return None;
        }
        let ends = |x: usize, y: usize| [x.min(y), x.max(y)];
        let outer =
            |new: usize, old: usize, side: Side| Some((new, side, self.across_side(pair[old], side)?));
        let outer = [
            outer(0, 0, ends(from, a))?,
            outer(1, 0, ends(to, a))?,
            outer(0, 1, ends(from, b))?,
            outer(1, 1, ends(to, b))?,
        ];
        let facets = triangles.map(|triangle| self.scaled.facet(triangle));
        let old_outer = [(0, outer[0].2), (0, outer[1].2), (1, outer[2].2), (1, outer[3].2)];
        let new_outer = outer.map(|(of, _, across)| (of, across));
        let before = self.cost(pair.map(|triangle| self.facets[triangle]), old_outer);
        let after = self.cost(facets, new_outer);
        self.is_better(&after, &before).then_some(Flip { pair, triangles, facets, diagonal, outer })
    }

    fn is_better(&self, after: &FillCost, before: &FillCost) -> bool {
        let gain = match self.by {
            FillBy::Fold => before.fold - after.fold,
            FillBy::Area => (before.area - after.area) / before.area,
        };
        after.zero_area < before.zero_area || after.zero_area == before.zero_area && gain > EQUAL
    }

    /// What two neighbours cost, with what lies round them.
    fn cost(&self, facets: [Facet; 2], outer: [(usize, Across); 4]) -> FillCost {
        let across_outer = outer.map(|(of, across)| facets[of].direction.fold(self.direction_across(across)));
        let inner = facets[0].direction.fold(facets[1].direction);
        FillCost {
            zero_area: facets.iter().filter(|facet| facet.is_flat).count(),
            fold: across_outer.into_iter().fold(inner, f64::max),
            area: facets[0].area + facets[1].area,
        }
    }

    fn direction_across(&self, across: Across) -> Direction {
        match across {
            Across::Loop(corner) => self.scaled.beside(corner),
            Across::Triangle(triangle) => self.facets[triangle].direction,
        }
    }

    /// What lies across a side of a triangle, if it still has that side.
    fn across_side(&self, triangle: usize, side: Side) -> Option<Across> {
        let at = sides_of(self.triangles[triangle]).iter().position(|ends| *ends == side)?;
        Some(self.across[triangle][at])
    }

    fn make(&mut self, flip: Flip) {
        for new in 0..2 {
            let triangle = flip.pair[new];
            self.triangles[triangle] = flip.triangles[new];
            self.facets[triangle] = flip.facets[new];
            self.set_across(triangle, flip.diagonal, Across::Triangle(flip.pair[1 - new]));
        }
        for (of, side, across) in flip.outer {
            self.set_across(flip.pair[of], side, across);
            if let Across::Triangle(beyond) = across {
                self.set_across(beyond, side, Across::Triangle(flip.pair[of]));
            }
        }
    }

    fn set_across(&mut self, triangle: usize, side: Side, across: Across) {
        let sides = sides_of(self.triangles[triangle]);
        for (at, ends) in sides.iter().enumerate() {
            if *ends == side {
                self.across[triangle][at] = across;
            }
        }
    }
}
