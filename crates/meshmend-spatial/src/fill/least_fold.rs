//! The least greatest fold that a fill of a small opening can have, among those with the fewest triangles of zero area.
//!
//! A state is a triangle over a range: what it costs to fill the range with this triangle on top. The fold against what comes
//! above depends on the top triangle alone.

use std::cmp::Ordering;

use super::facet::Direction;
use super::ranges::{Range, Ranges};

/// How bad a fill is: by its triangles of zero area, and then by its greatest fold.
#[derive(Clone, Copy, Debug)]
struct Worst {
    zero_area: u32,
    fold: f64,
}

impl Worst {
    fn cmp(&self, other: &Worst) -> Ordering {
        self.zero_area.cmp(&other.zero_area).then(self.fold.total_cmp(&other.fold))
    }
}

/// A triangle on top of a range, and how bad the best fill below it is.
#[derive(Clone, Copy)]
struct Top {
    triangle: usize,
    worst: Worst,
}

/// How far fills may fold, and the triangles that can be in one which folds no further.
pub(super) struct FoldLimit {
    pub(super) fold: f64,
    /// For each triangle whether the range below it can be filled within the limit.
    pub(super) is_possible: Vec<bool>,
}

/// The least greatest fold of an admissible fill with the fewest triangles of zero area; `None` if no fill is
/// admissible.
///
/// *Cost*: O(n⁴) for n corners at worst, mostly n³.
pub(super) fn least_fold(ranges: &Ranges<'_>) -> Option<FoldLimit> {
    let mut tops = Tops { ranges, best: Vec::with_capacity(ranges.len()), counts: vec![0; ranges.len()] };
    for range in ranges.all() {
        let over = ranges.triangles_over(range);
        let mut found: Vec<Top> = over.clone().filter_map(|triangle| tops.top(triangle)).collect();
        found.sort_unstable_by(|one, other| one.worst.cmp(&other.worst));
        tops.counts[over.start] = found.len();
        let rest = over.len() - found.len();
        tops.best.extend(found.into_iter().map(Some).chain(std::iter::repeat_n(None, rest)));
    }
    let Worst { fold, .. } = tops.least_over(ranges.whole(), ranges.beside_last())?;
    let mut is_possible = vec![false; ranges.len()];
    let within = |top: &&Top| top.worst.fold <= fold + super::EQUAL;
    tops.best.iter().flatten().filter(within).for_each(|top| is_possible[top.triangle] = true);
    Some(FoldLimit { fold: fold + super::EQUAL, is_possible })
}

/// For each range the triangles that can be on top of it, the best first.
struct Tops<'a> {
    ranges: &'a Ranges<'a>,
    /// By the numbers of the range's triangles; `None` behind the last.
    best: Vec<Option<Top>>,
    /// How many there are, at the first number of a range.
    counts: Vec<usize>,
}

impl Tops<'_> {
    /// A triangle on top of its range, if the range below it can be filled.
    fn top(&self, triangle: usize) -> Option<Top> {
        if self.ranges.is_barred(triangle) {
            return None;
        }
        let facet = self.ranges.facet(triangle);
        let mut worst = Worst { zero_area: u32::from(facet.is_flat), fold: 0.0 };
        for range in self.ranges.below(triangle) {
            let part = self.least_over(range, facet.direction)?;
            worst.zero_area += part.zero_area;
            worst.fold = worst.fold.max(part.fold);
        }
        Some(Top { triangle, worst })
    }

    /// The best fill of a range with something of this direction above it.
    fn least_over(&self, range: Range, above: Direction) -> Option<Worst> {
        if let Some(beside) = self.ranges.beside(range) {
            return Some(Worst { zero_area: 0, fold: beside.fold(above) });
        }
        let over = self.ranges.triangles_over(range);
        let tops = &self.best[over.start..over.start + self.counts[over.start]];
        let mut least: Option<Worst> = None;
        for top in tops.iter().flatten() {
            if least.is_some_and(|least| top.worst.cmp(&least).is_ge()) {
                break;
            }
            let fold = self.ranges.facet(top.triangle).direction.fold(above);
            let worst = Worst { fold: top.worst.fold.max(fold), ..top.worst };
            if least.is_none_or(|least| worst.cmp(&least).is_lt()) {
                least = Some(worst);
            }
        }
        least
    }
}
