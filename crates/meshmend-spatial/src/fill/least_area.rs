//! The least area that a fill of a small opening can have, among those that fold no further than a limit.

use std::cmp::Ordering;

use meshmend_geometry::polygon::Triangle;

use super::EQUAL;
use super::facet::Direction;
use super::least_fold::FoldLimit;
use super::lists::{compared, listed};
use super::ranges::{Range, Ranges};

/// A triangle on top of a range, and what the best fill below it costs.
#[derive(Clone, Copy)]
struct Top {
    triangle: usize,
    zero_area: u32,
    area: f64,
}

impl Top {
    /// Whether this costs as much as another one that costs no more.
    fn is_equal_to(&self, first: &Top) -> bool {
        self.zero_area == first.zero_area && self.area - first.area <= EQUAL * self.area
    }
}

/// The admissible fill with the fewest triangles of zero area, then with the least area, then with the first list; `None` where
/// no admissible fill is within the limit.
///
/// *Cost*: O(n³) for n corners without a limit, O(n⁴) at worst with one.
pub(super) fn least_area(ranges: &Ranges<'_>, limit: Option<FoldLimit>) -> Option<Vec<Triangle>> {
    let mut tops = Tops {
        ranges,
        limit,
        best: Vec::with_capacity(ranges.len()),
        counts: vec![0; ranges.len()],
        choices: vec![[None; 2]; ranges.len()],
    };
    ranges.all().for_each(|range| tops.add(range));
    let top = tops.first_over(ranges.whole(), ranges.beside_last())?;
    Some(listed(ranges, &tops.choices, top.triangle))
}

/// For each range the triangles that can be on top of it, the best first; of those that cost the same as that, one with the first
/// list.
struct Tops<'a> {
    ranges: &'a Ranges<'a>,
    limit: Option<FoldLimit>,
    /// By the numbers of the range's triangles; `None` behind the last.
    best: Vec<Option<Top>>,
    /// How many there are, at the first number of a range.
    counts: Vec<usize>,
    /// For each triangle what was chosen below it.
    choices: Vec<[Option<u32>; 2]>,
}

impl Tops<'_> {
    /// Finds the triangles that can be on top of a range, once all shorter ranges are known.
    fn add(&mut self, range: Range) {
        let over = self.ranges.triangles_over(range);
        let mut found: Vec<Top> = Vec::new();
        for triangle in over.clone() {
            found.extend(self.top(triangle));
        }
        let by_cost = |one: &Top, other: &Top| {
            one.zero_area.cmp(&other.zero_area).then(one.area.total_cmp(&other.area))
        };
        found.sort_unstable_by(|one, other| by_cost(one, other).then(one.triangle.cmp(&other.triangle)));
        let equal = found.iter().take_while(|top| top.is_equal_to(&found[0])).count();
        if let Some(first) = (0..equal).min_by(|&a, &b| self.by_list(&found[a], &found[b])) {
            found[..=first].rotate_right(1);
        }
        self.counts[over.start] = found.len();
        let rest = over.len() - found.len();
        self.best.extend(found.into_iter().map(Some).chain(std::iter::repeat_n(None, rest)));
    }

    /// A triangle on top of its range, if the range below it can be filled; keeps what is chosen below it.
    fn top(&mut self, triangle: usize) -> Option<Top> {
        let is_possible = self.limit.as_ref().is_none_or(|limit| limit.is_possible[triangle]);
        if self.ranges.is_barred(triangle) || !is_possible {
            return None;
        }
        let facet = *self.ranges.facet(triangle);
        let mut top = Top { triangle, zero_area: u32::from(facet.is_flat), area: facet.area };
        for (side, range) in self.ranges.below(triangle).into_iter().enumerate() {
            if let Some(beside) = self.ranges.beside(range) {
                if !self.is_within(beside, facet.direction) {
                    return None;
                }
                continue;
            }
            let part = self.first_over(range, facet.direction)?;
            top.zero_area += part.zero_area;
            top.area += part.area;
            self.choices[triangle][side] = Some(part.triangle as u32);
        }
        Some(top)
    }

    /// The best triangle on top of a range that folds no further than the limit against something of this direction above it.
    fn first_over(&self, range: Range, above: Direction) -> Option<Top> {
        let over = self.ranges.triangles_over(range);
        let mut tops = self.best[over.start..over.start + self.counts[over.start]].iter().flatten();
        let is_within = |top: &&Top| self.is_within(self.ranges.facet(top.triangle).direction, above);
        let best_of_all = tops.clone().next()?;
        if is_within(&best_of_all) {
            return Some(*best_of_all);
        }
        let cheapest = tops.find(is_within)?;
        let equal = tops.take_while(|top| top.is_equal_to(cheapest)).filter(is_within);
        equal.chain([cheapest]).min_by(|one, other| self.by_list(one, other)).copied()
    }

    fn by_list(&self, one: &Top, other: &Top) -> Ordering {
        compared(self.ranges, &self.choices, one.triangle, other.triangle)
    }

    fn is_within(&self, one: Direction, other: Direction) -> bool {
        self.limit.as_ref().is_none_or(|limit| one.fold(other) <= limit.fold)
    }
}
