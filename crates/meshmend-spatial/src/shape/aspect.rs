//! How much longer than high a triangle is.

use std::cmp::Ordering;

use meshmend_geometry::vector::{Point, cross, dot, minus};
use num_bigint::BigInt;

use crate::exact::integers::{self, integer, integer_points, lowest_exponent};
use serde::Serialize;

use crate::exact::nearest::root_of_quotient;

/// What a triangle that is too thin looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SliverKind {
    /// One of its edges is at most a tenth of the longest one.
    Needle,
    /// All of its edges are long: one corner is near the opposite edge.
    Cap,
}

impl SliverKind {
    /// The kind in a word, as reports have it.
    pub fn name(self) -> &'static str {
        match self {
            SliverKind::Needle => "needle",
            SliverKind::Cap => "cap",
        }
    }
}

/// Whether a triangle of finite corners is at least so many times as long as it is high, and then what it looks like. One
/// of zero area always is.
///
/// *Cost*: constant; big integers where doubles can't tell.
pub fn sliver_kind(triangle: [Point; 3], limit: f64) -> Option<SliverKind> {
    let rounded = Rounded::of(triangle);
    let is_sliver = rounded.reaches(limit).unwrap_or_else(|| Exact::of(triangle).reaches(limit));
    let is_needle = || rounded.has_short_edge().unwrap_or_else(|| Exact::of(triangle).has_short_edge());
    is_sliver.then(|| if is_needle() { SliverKind::Needle } else { SliverKind::Cap })
}

/// Which of two triangles of finite corners is longer by its height, exactly. Zero area is the longest of all.
///
/// *Cost*: constant; big integers where doubles can't tell.
pub fn compare_aspects(one: [Point; 3], other: [Point; 3]) -> Ordering {
    let [a, b] = [one, other].map(|triangle| Rounded::of(triangle).aspect_between());
    if let (Some([low, high]), Some([other_low, other_high])) = (a, b) {
        if low > other_high {
            return Ordering::Greater;
        } else if high < other_low {
            return Ordering::Less;
        }
    }
    let [a, b] = [one, other].map(Exact::of);
    match (a.area == BigInt::ZERO, b.area == BigInt::ZERO) {
        (false, false) => (a.longest.pow(2) * &b.area).cmp(&(b.longest.pow(2) * &a.area)),
        (is_flat, other_is) => is_flat.cmp(&other_is),
    }
}

/// The longest edge of a triangle by the height over it, in doubles; the largest double where it has no area.
pub(crate) fn aspect(triangle: [Point; 3]) -> f64 {
    match Rounded::of(triangle).aspect_between() {
        // Where the area has digits, so has the aspect.
        Some([low, high]) if high - low < 1e-9 * low => low / 2.0 + high / 2.0,
        _ => Exact::of(triangle).aspect(),
    }
}

/// The squares of a triangle's longest and shortest edge, and twice its area, in doubles.
struct Rounded {
    longest: f64,
    shortest: f64,
    area: f64,
}

/// Rounding changes a squared length by less than this part of it, and the area by less than this part of the longest
/// squared edge.
const ERROR: f64 = 16.0 * f64::EPSILON;

impl Rounded {
    fn of([a, b, c]: [Point; 3]) -> Self {
        let sides = [minus(b, a), minus(c, b), minus(a, c)];
        let squares = sides.map(|side| dot(side, side));
        let normal = cross(sides[0], sides[1]);
        Rounded {
            longest: squares.into_iter().fold(0.0, f64::max),
            shortest: squares.into_iter().fold(f64::INFINITY, f64::min),
            area: dot(normal, normal).sqrt(),
        }
    }

    /// Whether no product of these under- or overflows by more than the error.
    fn is_in_range(&self) -> bool {
        self.longest > 1e-140 && self.longest < 1e140
    }

    /// Whether the longest edge is so many times the height; `None` where rounding leaves a doubt.
    fn reaches(&self, limit: f64) -> Option<bool> {
        let reach = limit * self.area;
        let error = (1.0 + limit) * ERROR * self.longest;
        let is_sure = self.is_in_range() && (self.longest - reach).abs() > error && limit < 1e100;
        is_sure.then_some(self.longest > reach)
    }

    /// Whether ten times the shortest edge is at most the longest one; `None` where rounding leaves a doubt.
    fn has_short_edge(&self) -> Option<bool> {
        let tenfold = 100.0 * self.shortest;
        let is_sure = self.is_in_range() && (self.longest - tenfold).abs() > ERROR * (self.longest + tenfold);
        is_sure.then_some(self.longest > tenfold)
    }

    /// Between which bounds the aspect is.
    fn aspect_between(&self) -> Option<[f64; 2]> {
        let error = ERROR * self.longest;
        let [low, high] = [self.longest / (self.area + error), self.longest / (self.area - error)];
        (self.is_in_range() && self.area > error).then_some([low * (1.0 - ERROR), high * (1.0 + ERROR)])
    }
}

/// The squares of a triangle's longest and shortest edge and of twice its area, times powers of two that leave all quotients.
struct Exact {
    longest: BigInt,
    shortest: BigInt,
    area: BigInt,
}

impl Exact {
    fn of(triangle: [Point; 3]) -> Self {
        let [a, b, c] = integer_points(triangle);
        let sides = [(&b, &a), (&c, &b), (&a, &c)].map(|(to, from)| integers::minus(to, from));
        let mut squares = sides.each_ref().map(|side| integers::dot(side, side));
        squares.sort_unstable();
        let normal = integers::cross(&sides[0], &sides[1]);
        let [shortest, _, longest] = squares;
        Exact { longest, shortest, area: integers::dot(&normal, &normal) }
    }

    /// Whether L⁴ ≥ R²|n|².
    fn reaches(&self, limit: f64) -> bool {
        if !limit.is_finite() {
            return self.area == BigInt::ZERO;
        }
        let power = lowest_exponent([limit].iter());
        let (length, reach) = (self.longest.pow(2), integer(limit, power).pow(2) * &self.area);
        let shift = 2 * power.unsigned_abs();
        if power < 0 { length << shift >= reach } else { length >= reach << shift }
    }

    fn has_short_edge(&self) -> bool {
        &self.shortest * 100u32 <= self.longest
    }

    fn aspect(&self) -> f64 {
        if self.area == BigInt::ZERO {
            return f64::MAX;
        }
        root_of_quotient(&self.longest.pow(2), &self.area)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn kind(points: [[f64; 2]; 3]) -> Option<SliverKind> {
        sliver_kind(points.map(|[x, y]| [x, y, 0.0]), 1000.0)
    }

    #[test]
    fn kinds_are_those_of_the_definition_also_at_its_limits() {
        let (needle, cap) = (Some(SliverKind::Needle), Some(SliverKind::Cap));
        assert_eq!(kind([[0.0, 0.0], [1000.0, 0.0], [500.0, 1.0]]), cap);
        assert_eq!(kind([[0.0, 0.0], [1000.0, 0.0], [500.0, 1.0f64.next_up()]]), None);
        assert_eq!(kind([[0.0, 0.0], [1000.0, 0.0], [1000.0, 0.5]]), needle);
        assert_eq!(kind([[0.0, 0.0], [1000.0, 0.0], [1000.0, 2.0]]), None);
        assert_eq!(kind([[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]]), cap);
        assert_eq!(kind([[0.0, 0.0], [20.0, 0.0], [2.0, 0.0]]), needle);
        assert_eq!(kind([[0.0, 0.0], [20.0, 0.0], [2.0f64.next_up(), 0.0]]), cap);
        assert_eq!(kind([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]), None);
    }

    #[test]
    fn zero_area_is_the_longest_shape_of_all() {
        let flat = [[0.0; 3], [1.0, 1.0, 1.0], [2.0, 2.0, 2.0]];
        let thin = [[0.0; 3], [1.0, 1.0, 1.0], [2.0, 2.0, 2f64.next_up()]];
        assert_eq!(compare_aspects(flat, thin), Ordering::Greater);
        assert_eq!(compare_aspects(thin, flat), Ordering::Less);
        assert_eq!(compare_aspects(flat, flat), Ordering::Equal);
        assert_eq!(aspect(flat), f64::MAX);
        assert!(aspect(thin) > 1e15 && aspect(thin) < 1e17);
    }

    /// Coordinates of the most different sizes, and such as make triangles that are thin.
    fn coordinate() -> impl Strategy<Value = f64> {
        let near = (-3i32..4, -3i64..4).prop_map(|(whole, ulps)| f64::from(whole) + ulps as f64 * 1e-3);
        let sizes = (-1074i32..1000, -9i32..10).prop_map(|(power, digits)| {
            f64::from(digits) * 2f64.powi(power / 2) * 2f64.powi(power - power / 2)
        });
        prop_oneof![3 => near, 1 => sizes]
    }

    fn triangle() -> impl Strategy<Value = [Point; 3]> {
        prop::array::uniform3(prop::array::uniform3(coordinate()))
    }

    proptest! {
        #[test]
        fn doubles_say_what_whole_numbers_say(one in triangle(), other in triangle(), limit in 1.0f64..3000.0) {
            let exact = Exact::of(one);
            let expected = exact.reaches(limit).then(|| {
                if exact.has_short_edge() { SliverKind::Needle } else { SliverKind::Cap }
            });
            prop_assert_eq!(sliver_kind(one, limit), expected);
            let [a, b, c] = one;
            prop_assert_eq!(sliver_kind([b, c, a], limit), expected);
            prop_assert_eq!(sliver_kind([c, b, a], limit), expected);
            let b = Exact::of(other);
            let expected = match (exact.area == BigInt::ZERO, b.area == BigInt::ZERO) {
                (false, false) => (exact.longest.pow(2) * &b.area).cmp(&(b.longest.pow(2) * &exact.area)),
                (flat, other) => flat.cmp(&other),
            };
            prop_assert_eq!(compare_aspects(one, other), expected);
            prop_assert_eq!(compare_aspects(one, one), Ordering::Equal);
            let (shown, exactly) = (aspect(one), exact.aspect());
            prop_assert!((shown - exactly).abs() <= 1e-8 * exactly, "{} {}", shown, exactly);
        }
    }
}
