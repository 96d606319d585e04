//! Where points are, and points in the order of their places.
//!
//! Eight cubes along each axis are a cell. Where the points lie is a box of cells, and a place in there is a number:
//!
//! ```text
//! place   │ cell: x, y, z                            │ cube: x, y, z, three bits each │
//! word              │ what is left of the place                                       │ point │
//!         ╰───┬────╯
//!           part
//! ```
//!
//! Places are parted by their highest bits, so that the rest and the point fit a word, and words are sorted within each part.
//! What is too far apart for that is written out ([`Spread`]).

use rayon::prelude::*;

/// A cube's place, in sides.
pub(super) type Cube = [i64; 3];

/// A cube's place in its cell: three bits an axis.
pub(super) type InCell = u16;

/// Cubes along each axis of a cell.
pub(super) const PLACES: i8 = 8;
/// Cubes of a cell.
pub(super) const CUBES: usize = 1 << CUBE_BITS;
const CUBE_BITS: u32 = 9;

/// How many cubes apart along an axis near points may be.
pub(super) const REACH: i8 = 2;

/// Points have so many parts at most: more would wait for memory by themselves.
const MOST_PART_BITS: u32 = 11;
/// And so many points are a part on average at least, if all fit words.
const LEAST_PART_BITS: u32 = 8;
/// Fewer words are sorted on one thread.
const FEW: usize = 1 << 14;

/// Points by their places.
pub(super) trait Places {
    /// Ascends as points are visited.
    type Cell: Copy + Ord;

    /// Visits the finite points by cell, then cube, then name. While they are sorted it asks whether to go on, and visits none if not.
    fn visit_sorted(
        &self,
        points: &[[f64; 3]],
        goes_on: &dyn Fn() -> bool,
        visit: impl FnMut(Self::Cell, InCell, u32),
    );

    /// The cell up to one step away along each axis.
    fn beside(&self, cell: Self::Cell, step: [i8; 3]) -> Self::Cell;
}

/// Space divided into cubes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    /// How many sides there are to a unit.
    sides: f64,
}

impl Grid {
    pub(super) fn of_side(side: f64) -> Self {
        Grid { sides: side.recip() }
    }

    fn cube_of(self, [x, y, z]: [f64; 3]) -> Cube {
        [floor(x * self.sides), floor(y * self.sides), floor(z * self.sides)]
    }
}

/// The largest whole number that is not more; the library's function is a call on older processors.
fn floor(x: f64) -> i64 {
    let towards_zero = x as i64;
    towards_zero - i64::from(x < towards_zero as f64)
}

fn cell_of(cube: Cube) -> Cube {
    cube.map(|x| x >> 3)
}

fn cube_in_cell([x, y, z]: Cube) -> InCell {
    ((x & 7) << 6 | (y & 7) << 3 | z & 7) as InCell
}

/// A cube's place in its cell along each axis.
pub(super) const fn in_cell(at: InCell) -> [i8; 3] {
    [(at >> 6 & 7) as i8, (at >> 3 & 7) as i8, (at & 7) as i8]
}

/// How many cubes it is from one to another one, which is in the cell so many steps away.
pub(super) fn steps_between(one: InCell, other: InCell, step: [i8; 3]) -> [i8; 3] {
    let (a, b) = (in_cell(one), in_cell(other));
    [0, 1, 2].map(|axis| b[axis] + PLACES * step[axis] - a[axis])
}

/// Places as numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Packed {
    grid: Grid,
    /// The lowest cell, less one: so a step down is a number too.
    origin: Cube,
    /// How many cells there are along y and z, with one more at either end.
    y: u64,
    z: u64,
    place_bits: u32,
}

impl Packed {
    /// For points between these, if there are few enough places.
    pub(super) fn between(grid: Grid, low: [f64; 3], high: [f64; 3]) -> Option<Self> {
        let [low, high] = [low, high].map(|point| cell_of(grid.cube_of(point)));
        let origin = low.map(|x| x - 1);
        let [x, y, z] = [0, 1, 2].map(|axis| (high[axis] + 2 - origin[axis]) as u64);
        let places = x.checked_mul(y)?.checked_mul(z)?.checked_mul(CUBES as u64)?;
        let place_bits = u64::BITS - places.leading_zeros();
        (place_bits < u64::BITS).then_some(Packed { grid, origin, y, z, place_bits })
    }

    /// The place of a point; beyond all places if it is not finite.
    fn place(&self, point: [f64; 3]) -> u64 {
        if !point.iter().all(|x| x.is_finite()) {
            return u64::MAX;
        }
        let cube = self.grid.cube_of(point);
        let cell = cell_of(cube);
        let [x, y, z] = [0, 1, 2].map(|axis| (cell[axis] - self.origin[axis]) as u64);
        ((x * self.y + y) * self.z + z) << CUBE_BITS | u64::from(cube_in_cell(cube))
    }

    /// The points by parts; `None` if the caller does not go on.
    fn parts(&self, points: &[[f64; 3]], goes_on: &dyn Fn() -> bool) -> Option<Parts> {
        let places: Vec<u64> = points.par_iter().map(|&point| self.place(point)).collect();
        let point_bits = points.len().next_power_of_two().ilog2();
        let part_bits = point_bits.saturating_sub(LEAST_PART_BITS).min(MOST_PART_BITS);
        let rest_bits = self.place_bits.saturating_sub(part_bits).min(u64::BITS - point_bits);
        let mut starts = vec![0u32; 1 << (self.place_bits - rest_bits)];
        for place in &places {
            if let Some(count) = starts.get_mut((place >> rest_bits) as usize) {
                *count += 1;
            }
        }
        if !goes_on() {
            return None;
        }
        let mut total = 0;
        for start in &mut starts {
            total += std::mem::replace(start, total);
        }
        let mut words = vec![0u64; total as usize];
        for (place, point) in places.iter().zip(0..) {
            if let Some(next) = starts.get_mut((place >> rest_bits) as usize) {
                // The bits that are shifted out are the part's.
                words[*next as usize] = place << point_bits | point;
                *next += 1;
            }
        }
        if !goes_on() {
            return None;
        }
        // Each start has moved on to where the part after it begins.
        starts.insert(0, 0);
        sort_parts(&mut words, &starts);
        goes_on().then_some(Parts { starts, words, point_bits, rest_bits })
    }
}

/// Words sorted by parts.
struct Parts {
    /// Where each part begins, and one more.
    starts: Vec<u32>,
    words: Vec<u64>,
    point_bits: u32,
    rest_bits: u32,
}

/// Sorts each part, of which these are the starts and the end of the last one.
fn sort_parts(words: &mut [u64], starts: &[u32]) {
    let parts = starts.len() - 1;
    if parts <= 1 || words.len() < FEW {
        let mut rest = words;
        for bounds in starts.windows(2) {
            let (part, after) = rest.split_at_mut((bounds[1] - bounds[0]) as usize);
            part.sort_unstable();
            rest = after;
        }
        return;
    }
    let (low, high) = words.split_at_mut((starts[parts / 2] - starts[0]) as usize);
    rayon::join(|| sort_parts(low, &starts[..=parts / 2]), || sort_parts(high, &starts[parts / 2..]));
}

impl Places for Packed {
    type Cell = u64;

    fn visit_sorted(
        &self,
        points: &[[f64; 3]],
        goes_on: &dyn Fn() -> bool,
        mut visit: impl FnMut(u64, InCell, u32),
    ) {
        let Some(Parts { starts, words, point_bits, rest_bits }) = self.parts(points, goes_on) else {
            return;
        };
        for (part, bounds) in (0u64..).zip(starts.windows(2)) {
            for word in &words[bounds[0] as usize..bounds[1] as usize] {
                let place = part << rest_bits | word >> point_bits;
                let point = (word & ((1 << point_bits) - 1)) as u32;
                visit(place >> CUBE_BITS, (place % CUBES as u64) as InCell, point);
            }
        }
    }

    fn beside(&self, cell: u64, step: [i8; 3]) -> u64 {
        let [x, y, z] = step.map(i64::from);
        let (row, layer) = (self.z as i64, (self.y * self.z) as i64);
        cell.wrapping_add_signed(x * layer + y * row + z)
    }
}

/// Places too far apart for numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spread(pub(super) Grid);

impl Places for Spread {
    type Cell = Cube;

    fn visit_sorted(
        &self,
        points: &[[f64; 3]],
        goes_on: &dyn Fn() -> bool,
        mut visit: impl FnMut(Cube, InCell, u32),
    ) {
        let entry = |(point, name): (&[f64; 3], u32)| {
            let cube = self.0.cube_of(*point);
            point.iter().all(|x| x.is_finite()).then_some((cell_of(cube), cube_in_cell(cube), name))
        };
        let mut entries: Vec<(Cube, InCell, u32)> =
            points.par_iter().zip(0..points.len() as u32).filter_map(entry).collect();
        entries.par_sort_unstable();
        if !goes_on() {
            return;
        }
        entries.into_iter().for_each(|(cell, at, point)| visit(cell, at, point));
    }

    fn beside(&self, cell: Cube, step: [i8; 3]) -> Cube {
        [0, 1, 2].map(|axis| cell[axis] + i64::from(step[axis]))
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The points in order, each with its cube and with which points' cells come before those beside its own.
    fn told<P: Places>(places: &P, points: &[[f64; 3]]) -> Vec<(u32, InCell, Vec<usize>)> {
        let mut visited = Vec::new();
        places.visit_sorted(points, &|| true, |cell, at, point| visited.push((cell, at, point)));
        let steps = (0..27).map(|i| [i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1]);
        let told = |&(cell, at, point): &(P::Cell, InCell, u32)| {
            let before = |step| visited.partition_point(|(other, ..)| *other < places.beside(cell, step));
            (point, at, steps.clone().map(before).collect())
        };
        visited.iter().map(told).collect()
    }

    fn packed(grid: Grid, points: &[[f64; 3]]) -> Option<Packed> {
        let finite = points.iter().filter(|p| p[0].is_finite());
        let end = |best: fn(f64, f64) -> f64| {
            finite.clone().copied().reduce(|a, b| std::array::from_fn(|axis| best(a[axis], b[axis])))
        };
        Packed::between(grid, end(f64::min)?, end(f64::max)?)
    }

    proptest! {
        #[test]
        fn all_ways_of_writing_say_the_same(
            points in prop::collection::vec(prop::array::uniform3(-40..40i32), 1..700),
            scale in 0..14,
            missing in 0..700usize,
        ) {
            let mut points: Vec<[f64; 3]> =
                points.iter().map(|point| point.map(|x| f64::from(x) * 2f64.powi(scale))).collect();
            if let Some(point) = points.get_mut(missing) {
                point[0] = f64::NAN;
            }
            let grid = Grid::of_side(0.7);
            if let Some(packed) = packed(grid, &points) {
                prop_assert_eq!(told(&packed, &points), told(&Spread(grid), &points));
            }
        }
    }

    #[test]
    fn places_of_63_bits_are_numbers_and_what_is_not_finite_has_none() {
        let grid = Grid::of_side(1.0);
        let far = |cells: i32| [[0.0; 3], [f64::from(cells) * 8.0 - 1.0; 3], [f64::NAN, 0.0, 0.0]];
        assert!(packed(grid, &far(1 << 18)).is_none());
        let points = far((1 << 18) - 4);
        assert_eq!(packed(grid, &points).map(|packed| packed.place_bits), Some(63));
        for points in [&points[..], &points[..2], &points[1..], &points[..1]] {
            let packed = packed(grid, &far((1 << 18) - 4)).unwrap();
            assert_eq!(told(&packed, points), told(&Spread(grid), points));
        }
    }
}
