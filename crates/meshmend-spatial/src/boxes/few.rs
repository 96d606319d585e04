//! A few boxes that are compared with another one all at once.

use super::bounds::Bounds;

/// How many boxes there are at most.
pub(crate) const MOST: usize = 16;

/// Up to 16 boxes, their coordinates rounded to single precision: what overlaps still does then, as rounding keeps order.
#[derive(Clone, Debug)]
pub(crate) struct FewBoxes {
    low: [[f32; MOST]; 3],
    high: [[f32; MOST]; 3],
}

/// A bit for each box.
const BITS: [u32; MOST] = {
    let mut bits = [0; MOST];
    let mut at = 0;
    while at < MOST {
        bits[at] = 1 << at;
        at += 1;
    }
    bits
};

impl FewBoxes {
    /// None yet.
    pub(crate) fn new() -> Self {
        FewBoxes { low: [[f32::INFINITY; MOST]; 3], high: [[f32::NEG_INFINITY; MOST]; 3] }
    }

    /// Puts a box at a place; beyond the last place it is left out.
    #[inline]
    pub(crate) fn set(&mut self, place: usize, bounds: &Bounds) {
        for axis in 0..3 {
            if let (Some(low), Some(high)) = (self.low[axis].get_mut(place), self.high[axis].get_mut(place)) {
                (*low, *high) = (bounds.low[axis] as f32, bounds.high[axis] as f32);
            }
        }
    }

    /// The boxes that overlap another one, a bit each; among them may be some that only nearly do.
    #[inline]
    pub(crate) fn overlapping(&self, bounds: &Bounds) -> u32 {
        let (low, high) = (bounds.low.map(|x| x as f32), bounds.high.map(|x| x as f32));
        let ([x, y, z], [p, q, r]) = (&self.low, &self.high);
        let mut found = 0;
        // So written that it is done for four boxes at a time.
        for at in 0..MOST {
            let overlaps = (x[at] <= high[0])
                & (low[0] <= p[at])
                & (y[at] <= high[1])
                & (low[1] <= q[at])
                & (z[at] <= high[2])
                & (low[2] <= r[at]);
            found |= if overlaps { BITS[at] } else { 0 };
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_that_overlap_are_found_and_those_far_away_are_not() {
        // Numbers next to each other, and beyond the range of single precision.
        let edges = [-f64::MAX, -1.0, -5e-324, 0.0, 5e-324, 1.0, 1.0 + f64::EPSILON, 1.5, 1e300, f64::MAX];
        let mut all = Vec::new();
        for (at, &low) in edges.iter().enumerate() {
            all.extend(
                edges[at..].iter().map(|&high| Bounds { low: [low, 0.0, low], high: [high, 1.0, high] }),
            );
        }
        for some in all.chunks(MOST) {
            let mut few = FewBoxes::new();
            some.iter().enumerate().for_each(|(place, bounds)| few.set(place, bounds));
            for asked in &all {
                let found = few.overlapping(asked);
                let exact = some.iter().enumerate().filter(|(_, bounds)| bounds.overlaps(asked));
                assert!(exact.map(|(place, _)| 1 << place).all(|bit: u32| found & bit != 0));
                assert_eq!(found >> some.len(), 0);
            }
            let above = Bounds { low: [0.0, 1.1, 0.0], high: [1.0, 2.0, 1.0] };
            assert_eq!(few.overlapping(&above), 0);
        }
    }
}
