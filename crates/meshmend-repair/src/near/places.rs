//! Where points are, written so that sorting brings near ones together.
//!
//! Four cubes along each axis are a cell. A word has a point's cell, its cube in that cell, and the point:
//!
//! ```text
//! │ cell: x, y, z │ cube: x, y, z, two bits each │ point │
//! ```
//!
//! Many clouds fit words of 64 bits, others 128; [`Spread`] takes any.

use std::marker::PhantomData;
use std::ops::{Shl, Shr};

/// A cube's place, in sides.
pub(super) type Cube = [i64; 3];

/// Bits of a cube in its cell.
const CUBE_BITS: u32 = 6;

/// How a point and its place are written.
pub(super) trait Places: Sync {
    /// A point with its place; sorts by cell, then cube, then point.
    type Entry: Copy + Ord + Send + Sync;
    /// Sorts as the entries do.
    type Cell: Copy + Ord;

    fn entry(&self, cube: Cube, point: u32) -> Self::Entry;
    fn point(&self, entry: Self::Entry) -> u32;
    /// The cube's place in its cell: 0 to 3 along each axis.
    fn cube(&self, entry: Self::Entry) -> [i8; 3];
    fn cell(&self, entry: Self::Entry) -> Self::Cell;
    /// The cell up to one step away along each axis.
    fn beside(&self, cell: Self::Cell, step: [i8; 3]) -> Self::Cell;
}

/// The cell of a cube and its place in there.
fn split(cube: Cube) -> (Cube, [i8; 3]) {
    (cube.map(|x| x >> 2), cube.map(|x| (x & 3) as i8))
}

/// What words have to hold.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    /// The lowest cell, less one: so a step down never leaves the words.
    origin: Cube,
    /// How many cells there are along y and z, with one more at either end.
    y: u64,
    z: u64,
    point_bits: u32,
    /// Of all, if 64 are enough for the cells.
    pub(super) bits: Option<u32>,
}

impl Layout {
    /// For so many points in the cubes from `low` to `high`.
    pub(super) fn of(low: Cube, high: Cube, points: usize) -> Self {
        let origin = split(low).0.map(|x| x - 1);
        let last = split(high).0;
        let [x, y, z] = [0, 1, 2].map(|axis| (last[axis] + 2 - origin[axis]) as u64);
        let cells = y.checked_mul(z).and_then(|cells| cells.checked_mul(x));
        let point_bits = (points as u64).next_power_of_two().ilog2();
        let bits = cells.map(|cells| u64::BITS - cells.leading_zeros() + CUBE_BITS + point_bits);
        Layout { origin, y, z, point_bits, bits }
    }
}

/// A word of 64 or 128 bits.
pub(super) trait Word:
    Copy + Ord + Send + Sync + Shl<u32, Output = Self> + Shr<u32, Output = Self>
{
    /// The word with this in its lowest bits, which are empty.
    fn with(self, low: u64) -> Self;
    fn of(value: u64) -> Self;
    /// The lowest bits.
    fn low(self) -> u64;
}

impl Word for u64 {
    fn with(self, low: u64) -> Self {
        self | low
    }
    fn of(value: u64) -> Self {
        value
    }
    fn low(self) -> u64 {
        self
    }
}

impl Word for u128 {
    fn with(self, low: u64) -> Self {
        self | u128::from(low)
    }
    fn of(value: u64) -> Self {
        value.into()
    }
    fn low(self) -> u64 {
        self as u64
    }
}

/// Places in words that are wide enough for them.
pub(super) struct Packed<W> {
    layout: Layout,
    word: PhantomData<W>,
}

impl<W: Word> Packed<W> {
    pub(super) fn new(layout: Layout) -> Self {
        Packed { layout, word: PhantomData }
    }
}

impl<W: Word> Places for Packed<W> {
    type Entry = W;
    type Cell = u64;

    fn entry(&self, cube: Cube, point: u32) -> W {
        let (cell, [a, b, c]) = split(cube);
        let [x, y, z] = [0, 1, 2].map(|axis| (cell[axis] - self.layout.origin[axis]) as u64);
        let cell = (x * self.layout.y + y) * self.layout.z + z;
        let cube = (a << 4 | b << 2 | c) as u64;
        ((W::of(cell) << CUBE_BITS).with(cube) << self.layout.point_bits).with(point.into())
    }

    fn point(&self, entry: W) -> u32 {
        (entry.low() & ((1 << self.layout.point_bits) - 1)) as u32
    }

    fn cube(&self, entry: W) -> [i8; 3] {
        let cube = (entry >> self.layout.point_bits).low();
        [cube >> 4, cube >> 2, cube].map(|x| (x & 3) as i8)
    }

    fn cell(&self, entry: W) -> u64 {
        (entry >> (self.layout.point_bits + CUBE_BITS)).low()
    }

    fn beside(&self, cell: u64, step: [i8; 3]) -> u64 {
        let [x, y, z] = step.map(i64::from);
        let (row, layer) = (self.layout.z as i64, (self.layout.y * self.layout.z) as i64);
        cell.wrapping_add_signed(x * layer + y * row + z)
    }
}

/// Places that fit no word.
pub(super) struct Spread;

impl Places for Spread {
    type Entry = (Cube, [i8; 3], u32);
    type Cell = Cube;

    fn entry(&self, cube: Cube, point: u32) -> Self::Entry {
        let (cell, cube) = split(cube);
        (cell, cube, point)
    }

    fn point(&self, entry: Self::Entry) -> u32 {
        entry.2
    }

    fn cube(&self, entry: Self::Entry) -> [i8; 3] {
        entry.1
    }

    fn cell(&self, entry: Self::Entry) -> Cube {
        entry.0
    }

    fn beside(&self, cell: Cube, step: [i8; 3]) -> Cube {
        std::array::from_fn(|axis| cell[axis] + i64::from(step[axis]))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// What a way of writing says of a point, and of the cells beside its own.
    fn told<P: Places>(places: &P, cubes: &[Cube]) -> Vec<(u32, [i8; 3], Vec<std::cmp::Ordering>)> {
        let mut entries: Vec<P::Entry> = (0..).zip(cubes).map(|(at, &cube)| places.entry(cube, at)).collect();
        entries.sort_unstable();
        let first = entries.first().map(|&entry| places.cell(entry));
        let steps = (0..27).map(|i| [i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1]);
        let told = |&entry: &P::Entry| {
            let beside = |step| places.beside(places.cell(entry), step).cmp(&first.unwrap());
            (places.point(entry), places.cube(entry), steps.clone().map(beside).collect())
        };
        entries.iter().map(told).collect()
    }

    proptest! {
        #[test]
        fn all_ways_of_writing_say_the_same(
            cubes in prop::collection::vec(prop::array::uniform3(-40..40i64), 1..30),
            scale in 0..9u32,
        ) {
            let cubes: Vec<Cube> = cubes.iter().map(|cube| cube.map(|x| x << scale)).collect();
            let end = |best: fn(i64, i64) -> i64| {
                cubes.iter().copied().reduce(|a, b| std::array::from_fn(|axis| best(a[axis], b[axis]))).unwrap()
            };
            let layout = Layout::of(end(i64::min), end(i64::max), cubes.len());
            prop_assert!(layout.bits.is_some_and(|bits| bits <= 64));
            let spread = told(&Spread, &cubes);
            prop_assert_eq!(&told(&Packed::<u64>::new(layout), &cubes), &spread);
            prop_assert_eq!(&told(&Packed::<u128>::new(layout), &cubes), &spread);
        }
    }
}
