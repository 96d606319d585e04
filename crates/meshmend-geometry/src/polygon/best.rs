//! The best of all triangulations of a small polygon.
//!
//! *Source*: G. Klincsek, *Minimal triangulations of polygonal domains*, 1980, for the dynamic program.

use std::cmp::Ordering;

use super::corners::{Polygon, Triangle};
use super::cost::{Avoid, Cost, Costs};
use crate::vector::area_vector;

impl Polygon<'_> {
    /// The triangles of a polygon of four corners, and the diagonal between them: those of [`triangulate_polygon`].
    ///
    /// *Cost*: constant.
    pub(crate) fn in_two(
        self,
        avoid: Avoid,
        is_taken: &dyn Fn(usize, usize) -> bool,
    ) -> ([Triangle; 2], [usize; 2]) {
        let normal = area_vector(self.points.iter().copied());
        best_of_two(&Costs { polygon: self, avoid, is_taken, normal })
    }
}

/// The better of the two triangulations that four corners have, and its diagonal: what [`best_of_all`] finds.
fn best_of_two(costs: &Costs<'_>) -> ([Triangle; 2], [usize; 2]) {
    let cost = |[last, first]: [Triangle; 2], [one, other]: [usize; 2]| {
        costs.of(first).plus(costs.of_side(one, other)).plus(costs.of(last))
    };
    let (first, second) = ([[0, 1, 3], [1, 2, 3]], [[0, 2, 3], [0, 1, 2]]);
    let (cost_of_first, cost_of_second) = (cost(first, [1, 3]), cost(second, [0, 2]));
    match costs.compared(&cost_of_second, &cost_of_first) {
        Ordering::Less => (second, [0, 2]),
        _ => (first, [1, 3]),
    }
}

/// The cheapest triangulation of every range of corners, from short ranges to long ones.
pub(super) fn best_of_all(costs: &Costs<'_>) -> (Cost, Vec<Triangle>) {
    let count = costs.polygon.len();
    let mut table = vec![(Cost::default(), 0usize); count * count];
    for length in 2..count {
        for low in 0..count - length {
            let high = low + length;
            let mut best: Option<(Cost, usize)> = None;
            for middle in low + 1..high {
                let parts = table[low * count + middle].0.plus(table[middle * count + high].0);
                let cost = parts.plus(costs.of([low, middle, high]));
                if best.is_none_or(|(least, _)| costs.compared(&cost, &least) == Ordering::Less) {
                    best = Some((cost, middle));
                }
            }
            let (least, middle) = best.unwrap_or_default();
            table[low * count + high] = (least.plus(costs.of_side(low, high)), middle);
        }
    }
    let (mut triangles, mut ranges) = (Vec::with_capacity(count - 2), vec![(0, count - 1)]);
    while let Some((low, high)) = ranges.pop() {
        if high - low < 2 {
            continue;
        }
        let middle = table[low * count + high].1;
        triangles.push([low, middle, high]);
        ranges.extend([(middle, high), (low, middle)]);
    }
    (table[count - 1].0, triangles)
}

#[cfg(test)]
mod tests {
    use meshmend_core::VertexId;

    use super::*;

    #[test]
    fn four_corners_are_cut_as_the_general_way_cuts_them() {
        let at = |n: u32| [f64::from(n % 3), f64::from(n / 3 % 3), f64::from(n / 9)];
        let vertices: Vec<VertexId> = (0..4).map(VertexId).collect();
        for corners in (0..18_u32.pow(4)).step_by(7) {
            let points = [0, 1, 2, 3].map(|place| at(corners / 18_u32.pow(place) % 18));
            for taken in 0..8 {
                let avoid = if taken > 3 { Avoid::Folds } else { Avoid::TakenDiagonals };
                let is_taken = |one: usize, other: usize| taken >> ((one + other) / 4) & 1 == 1;
                let polygon = Polygon { points: &points, vertices: &vertices };
                let normal = area_vector(points.into_iter());
                let costs = Costs { polygon, avoid, is_taken: &is_taken, normal };
                assert_eq!(best_of_two(&costs).0.to_vec(), best_of_all(&costs).1, "{points:?}");
            }
        }
    }
}
