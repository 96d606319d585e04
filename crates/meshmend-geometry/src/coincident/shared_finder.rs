//! Which points are the same to the bit, found as they come.
//!
//! An open table of places, by hash:
//!
//! ```text
//! slots    hash bits │ place + 1        0 where nothing is
//! points   the place's three coordinates, in single precision
//! ```
//!
//! Neighbours in a file mostly share places that came a moment before, and those are still in the processor's cache. Where hardly
//! any place comes twice, or hashes were made to collide, it is given up, and points are what they are.

use meshmend_core::{Id, SharedPlaces, VertexId};

use super::equal_keys::Key;

/// Points after which it is looked whether sharing pays, and then each time that there are twice as many.
const FIRST_LOOK: usize = 1 << 16;

/// Steps from slot to slot for each point that no honest file needs.
const STEPS: usize = 16;

/// Points in single precision, of which the different ones are kept.
#[derive(Debug)]
pub struct SharedFinder {
    slots: Vec<u64>,
    points: Vec<[f32; 3]>,
    of_vertex: Vec<VertexId>,
    next_look: usize,
    steps: usize,
}

impl SharedFinder {
    /// For so many points, or fewer.
    pub fn for_points(count: usize) -> Self {
        SharedFinder {
            slots: vec![0; 1 << 10],
            points: Vec::new(),
            of_vertex: Vec::with_capacity(count),
            next_look: FIRST_LOOK,
            steps: 0,
        }
    }

    /// Takes the next points. `false` if it does not pay to go on.
    ///
    /// *Cost*: constant for each; 4 bytes, and 28 to 44 for each that differs from all before.
    #[must_use]
    pub fn take(&mut self, points: &[[f32; 3]]) -> bool {
        for &point in points {
            let place = self.place_of(point);
            self.of_vertex.push(VertexId(place));
        }
        let count = self.of_vertex.len();
        if self.steps > STEPS * (count + FIRST_LOOK) {
            return false;
        }
        if count < self.next_look {
            return true;
        }
        self.next_look *= 2;
        // Each vertex that shares a place saves 20 bytes, and each place costs some 40.
        self.points.len() <= count / 2
    }

    fn place_of(&mut self, point: [f32; 3]) -> u32 {
        let key = point.map(f32::to_bits);
        let hash = key.hash();
        let mask = self.slots.len() - 1;
        let mut at = hash as usize & mask;
        let tag = hash >> 32 << 32;
        loop {
            let slot = self.slots[at];
            if slot == 0 {
                break;
            }
            let place = slot as u32 - 1;
            if slot >> 32 << 32 == tag && self.points[place as usize].map(f32::to_bits) == key {
                return place;
            }
            self.steps += 1;
            at = (at + 1) & mask;
        }
        let place = self.points.len() as u32;
        self.points.push(point);
        self.slots[at] = tag | u64::from(place + 1);
        if 2 * self.points.len() > self.slots.len() {
            self.grow();
        }
        place
    }

    /// Twice as many slots. A slot's tag has but the upper half of the hash, so the points tell the rest.
    fn grow(&mut self) {
        let size = 2 * self.slots.len();
        self.slots.clear();
        self.slots.resize(size, 0);
        for (place, point) in (1u32..).zip(&self.points) {
            let hash = point.map(f32::to_bits).hash();
            let mut at = hash as usize & (size - 1);
            while self.slots[at] != 0 {
                self.steps += 1;
                at = (at + 1) & (size - 1);
            }
            self.slots[at] = hash >> 32 << 32 | u64::from(place);
        }
    }

    /// The places, in the order in which they came, and that of each point.
    pub fn finish(self) -> SharedPlaces {
        let points = self.points.iter().map(|point| point.map(f64::from)).collect();
        // Each is numbered when it first comes.
        SharedPlaces::new(points, self.of_vertex).unwrap_or_default()
    }

    /// All points so far, for whoever gives up.
    pub fn into_points(self) -> impl Iterator<Item = [f64; 3]> {
        let SharedFinder { points, of_vertex, .. } = self;
        of_vertex.into_iter().map(move |place| points[place.index()].map(f64::from))
    }
}

impl Default for SharedFinder {
    fn default() -> Self {
        SharedFinder::for_points(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points of a soup, each of which comes so many times.
    fn soup(count: usize, times: usize) -> Vec<[f32; 3]> {
        (0..count).map(|i| [(i / times) as f32, (i % 7) as f32 * 0.0, -1.0]).collect()
    }

    #[test]
    fn points_that_differ_by_a_bit_differ() {
        let points = [[0.0, 1.0, 2.0], [-0.0, 1.0, 2.0], [0.0, 1.0, 2.0], [f32::NAN; 3], [f32::NAN; 3]];
        let mut finder = SharedFinder::for_points(5);
        assert!(finder.take(&points));
        let found = finder.finish();
        assert_eq!(found.of_vertex(), [0, 1, 0, 2, 2].map(VertexId));
        assert_eq!((found.points().len(), found.points()[1][0].is_sign_negative()), (3, true));
    }

    #[test]
    fn many_points_are_as_a_map_has_them() {
        let mut state = 1u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 53) as f32
        };
        let points: Vec<[f32; 3]> = (0..200_000).map(|_| [next(), next() % 8.0, 0.5]).collect();
        let mut finder = SharedFinder::for_points(points.len());
        assert!(points.chunks(1000).all(|points| finder.take(points)));
        let found = finder.finish();
        let mut places = std::collections::BTreeMap::new();
        for (vertex, point) in points.iter().enumerate() {
            let count = places.len() as u32;
            let expected = *places.entry(point.map(f32::to_bits)).or_insert(count);
            assert_eq!(found.of_vertex()[vertex], VertexId(expected));
            assert_eq!(found.points()[expected as usize], point.map(f64::from));
        }
    }

    #[test]
    fn what_is_not_shared_is_given_up_and_nothing_is_lost() {
        for (times, goes_on) in [(1, false), (6, true)] {
            let points = soup(FIRST_LOOK, times);
            let mut finder = SharedFinder::for_points(points.len());
            assert_eq!(finder.take(&points), goes_on, "{times} times");
            let kept: Vec<[f64; 3]> = finder.into_points().collect();
            assert_eq!(kept, points.iter().map(|point| point.map(f64::from)).collect::<Vec<_>>());
        }
    }
}
