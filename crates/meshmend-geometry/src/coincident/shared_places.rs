//! The places that several points share, where few are shared: most points are passed over at a look.

use super::equal_keys::{always, lowest_of_equal};
use crate::vector::{Point, is_finite, place_bits};

/// Gives each set of several finite points at one place, of those that are asked about: their numbers, ascending. The
/// set with the lowest point comes first.
///
/// *Cost*: linear, and k log k for k points that share their place. Two bytes a point, and 50 for each of those.
pub fn each_shared_place(
    points: &[Point],
    is_asked: impl Fn(usize) -> bool,
    mut found: impl FnMut(&[usize]),
) {
    let asked = (0..points.len()).filter(|&at| is_asked(at) && is_finite(&points[at]));
    let (mut once, mut again) = (Marks::for_count(points.len()), Marks::for_count(points.len()));
    for at in asked.clone() {
        let mark = once.mark_of(points[at]);
        if once.set(mark) {
            again.set(mark);
        }
    }
    // Places that share a mark may be different ones.
    let perhaps: Vec<usize> = asked.filter(|&at| again.is_set(again.mark_of(points[at]))).collect();
    let Ok(lowest) = lowest_of_equal(&perhaps, |&at| Some(place_bits(points[at])), &always);
    let mut order: Vec<usize> = (0..perhaps.len()).collect();
    order.sort_unstable_by_key(|&at| (lowest[at], at));
    let mut place = Vec::new();
    for same in order.chunk_by(|&one, &other| lowest[one] == lowest[other]).filter(|same| same.len() > 1) {
        place.clear();
        place.extend(same.iter().map(|&at| perhaps[at]));
        found(&place);
    }
}

/// A bit for each of many marks, eight marks or more a point.
struct Marks {
    words: Vec<u64>,
}

impl Marks {
    fn for_count(count: usize) -> Self {
        Marks { words: vec![0; (count / 8 + 1).next_power_of_two()] }
    }

    #[inline]
    fn mark_of(&self, point: Point) -> usize {
        const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
        let mixed = place_bits(point).iter().fold(0_u64, |mixed, bits| {
            let product = (mixed ^ bits).wrapping_mul(ODD);
            product ^ product >> 32
        });
        // Points that differ in signs alone differ in high bits alone.
        (mixed.wrapping_mul(ODD) >> 32) as usize & (64 * self.words.len() - 1)
    }

    /// Sets a mark; tells whether it was set already.
    #[inline]
    fn set(&mut self, mark: usize) -> bool {
        let (word, bit) = (&mut self.words[mark / 64], 1 << (mark % 64));
        let was_set = *word & bit != 0;
        *word |= bit;
        was_set
    }

    #[inline]
    fn is_set(&self, mark: usize) -> bool {
        self.words[mark / 64] & 1 << (mark % 64) != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shared(points: &[Point], is_asked: impl Fn(usize) -> bool) -> Vec<Vec<usize>> {
        let mut all = Vec::new();
        each_shared_place(points, is_asked, |place| all.push(place.to_vec()));
        all.sort();
        all
    }

    #[test]
    fn points_at_one_place_are_found_among_all() {
        let points: Vec<Point> =
            (0..1000).map(|i| [f64::from(i % 700), -0.0, 0.5 / f64::from(i % 700)]).collect();
        let expected: Vec<Vec<usize>> = (1..300).map(|i| vec![i, i + 700]).collect();
        assert_eq!(shared(&points, |_| true), expected);
        assert_eq!(shared(&points, |at| at % 2 == 1).len(), 150);
        assert_eq!(shared(&[], |_| true), Vec::<Vec<usize>>::new());
    }

    #[test]
    fn zeros_are_one_and_what_is_not_finite_equals_nothing() {
        let points =
            [[0.0; 3], [-0.0; 3], [f64::NAN; 3], [f64::NAN; 3], [f64::INFINITY; 3], [f64::INFINITY; 3]];
        assert_eq!(shared(&points, |_| true), [[0, 1]]);
    }
}
