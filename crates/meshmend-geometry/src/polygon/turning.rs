//! Which way loops in space turn, exactly.

use crate::vector::Point;

/// Twice the area vector of a loop, without any rounding.
///
/// A loop far from the origin, or one of hardly any area, has a direction all the same: the one that exact fractions
/// would give.
pub struct ExactArea([Expansion; 3]);

impl ExactArea {
    /// The area of a loop of finite points.
    ///
    /// *Cost*: linear; some hundred operations a point.
    pub fn of(points: &[Point]) -> Self {
        let largest = points.iter().flatten().fold(0.0f64, |most, x| most.max(x.abs()));
        // Powers of two lose no digit; the sign of what follows does not depend on them.
        let scale = if largest > 0.0 { (-largest.log2().floor()).clamp(-1000.0, 1000.0).exp2() } else { 1.0 };
        let mut area = [const { Expansion(Vec::new()) }; 3];
        for (place, from) in points.iter().enumerate() {
            let to = points[if place + 1 == points.len() { 0 } else { place + 1 }].map(|x| x * scale);
            let from = from.map(|x| x * scale);
            for (axis, sum) in area.iter_mut().enumerate() {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                sum.add_product(from[i], to[j]);
                sum.add_product(-from[j], to[i]);
            }
        }
        ExactArea(area)
    }

    /// Whether a loop turns against another one: whether the product of their area vectors is below zero.
    pub fn turns_against(&self, other: &ExactArea) -> bool {
        let mut product = Expansion(Vec::new());
        for (one, other) in self.0.iter().zip(&other.0) {
            for (&a, &b) in one.0.iter().flat_map(|a| other.0.iter().map(move |b| (a, b))) {
                product.add_product(a, b);
            }
        }
        product.0.last().is_some_and(|most| *most < 0.0)
    }
}

/// A number as a sum of doubles that do not overlap, the largest last.
///
/// *Source*: J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates*,
/// 1997.
struct Expansion(Vec<f64>);

impl Expansion {
    fn add_product(&mut self, a: f64, b: f64) {
        let product = a * b;
        self.add(a.mul_add(b, -product));
        self.add(product);
    }

    fn add(&mut self, value: f64) {
        let mut sum = value;
        self.0.retain_mut(|part| {
            let total = sum + *part;
            let virtual_part = total - sum;
            let rest = (sum - (total - virtual_part)) + (*part - virtual_part);
            sum = total;
            *part = rest;
            rest != 0.0
        });
        if sum != 0.0 {
            self.0.push(sum);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reversed_loop_turns_against_itself_also_far_away_and_hardly_open() {
        for [far, open] in [[0.0, 1.0], [1e9, 1e-7], [-3e200, 1e185], [1e-200, 1e-216]] {
            let lie = [[far, far, far], [far + open, far, far], [far, far + open, far]];
            let mut reversed = lie;
            reversed.reverse();
            let [one, other] = [lie, reversed].map(|points| ExactArea::of(&points));
            assert!(one.turns_against(&other) && !one.turns_against(&one), "{far}");
        }
    }

    #[test]
    fn what_has_no_area_or_stands_upright_turns_against_nothing() {
        let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        let upright = square.map(|[x, y, z]| [x, z, y]);
        let line = [[0.1, 0.1, 0.1], [0.2, 0.2, 0.2], [0.7, 0.7, 0.7], [0.5, 0.5, 0.5]];
        let whole = ExactArea::of(&square);
        for points in [upright, line, [[f64::NAN; 3]; 4]] {
            assert!(!ExactArea::of(&points).turns_against(&whole));
        }
    }
}
