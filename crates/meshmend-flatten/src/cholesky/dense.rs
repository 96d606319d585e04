//! Arithmetic on dense matrices, each column by column in one slice. Of a triangle only the lower half means something.

use rayon::prelude::*;

use super::CholeskyError;

/// How many columns are eliminated before what they do to the others is computed: so many stay in a cache.
const BLOCK: usize = 32;

/// How many rows and columns are computed at once: so many sums stay in registers.
const TILE: usize = 4;

/// Columns with fewer rows than this are not worth sharing among threads.
const WORTH_SHARING: usize = 256;

/// Room for the columns of a block, as tiles of rows.
#[derive(Default)]
pub(super) struct Tiles {
    /// Tile by tile its rows in each column of the block, filled up with zeros.
    rows: Vec<[f64; TILE]>,
    /// How many columns there are.
    columns: usize,
}

/// Makes the first columns of a matrix those of its Cholesky factor; `height` is how long they are.
///
/// *Cost*: half of width² · height multiplications.
pub(super) fn factorize(columns: &mut [f64], height: usize, tiles: &mut Tiles) -> Result<(), CholeskyError> {
    let width = columns.len() / height;
    for begin in (0..width).step_by(BLOCK) {
        let end = width.min(begin + BLOCK);
        for column in begin..end {
            let (before, rest) = columns.split_at_mut(column * height);
            let own = &mut rest[column..height];
            for before in before[begin * height..].chunks_exact(height) {
                subtract_multiple(own, &before[column..]);
            }
            let pivot = own[0];
            // A pivot that is no number is not positive either.
            if pivot.is_nan() || pivot <= 0.0 {
                return Err(CholeskyError::NotPositive);
            }
            let root = pivot.sqrt();
            own.iter_mut().for_each(|entry| *entry /= root);
        }
        if end < width {
            let (before, after) = columns.split_at_mut(end * height);
            tiles.load(&before[begin * height..], height, end);
            tiles.subtract_squares(after, height, end);
        }
    }
    Ok(())
}

/// Subtracts from a square matrix what eliminating the columns of a factor does to it; its rows are their last ones.
///
/// *Cost*: half of the square's numbers for each column, in multiplications.
pub(super) fn subtract_eliminated(
    square: &mut [f64],
    side: usize,
    factor: &[f64],
    height: usize,
    tiles: &mut Tiles,
) {
    if side > 0 {
        for block in factor.chunks(BLOCK * height) {
            tiles.load(block, height, height - side);
            tiles.subtract_squares(square, side, 0);
        }
    }
}

impl Tiles {
    /// Takes the columns of a block, from a row on.
    fn load(&mut self, block: &[f64], height: usize, from: usize) {
        self.columns = block.len() / height;
        self.rows.clear();
        self.rows.resize((height - from).div_ceil(TILE) * self.columns, [0.0; TILE]);
        for (place, column) in block.chunks_exact(height).enumerate() {
            let targets = self.rows[place..].iter_mut().step_by(self.columns);
            for (target, rows) in targets.zip(column[from..].chunks(TILE)) {
                target[..rows.len()].copy_from_slice(rows);
            }
        }
    }

    /// Subtracts from each entry of some columns the product of the loaded rows with its row's and its column's number.
    /// The columns are `height` long, the first has the number `first`, and so has the first of the loaded rows.
    /// Each entry is one thread's, whichever: the sums are the same for any number of threads.
    fn subtract_squares(&self, targets: &mut [f64], height: usize, first: usize) {
        let subtract = |place: usize, targets: &mut [f64]| {
            let rows = &self.rows[place * self.columns..];
            let by_column = &rows[..self.columns];
            for (by_row, row) in rows.chunks_exact(self.columns).zip((first + place * TILE..).step_by(TILE)) {
                let products = products(by_row, by_column);
                let count = TILE.min(height - row);
                for (target, products) in targets.chunks_exact_mut(height).zip(products) {
                    let target = &mut target[row..row + count];
                    target.iter_mut().zip(products).for_each(|(entry, product)| *entry -= product);
                }
            }
        };
        if height < WORTH_SHARING {
            targets
                .chunks_mut(TILE * height)
                .enumerate()
                .for_each(|(place, targets)| subtract(place, targets));
        } else {
            let tiles =
                targets.par_chunks_mut(TILE * height).enumerate().with_min_len(WORTH_SHARING / TILE / 4);
            tiles.for_each(|(place, targets)| subtract(place, targets));
        }
    }
}

/// For each row of one tile and each row of another, second first, the sum of their products over all columns.
fn products(one: &[[f64; TILE]], other: &[[f64; TILE]]) -> [[f64; TILE]; TILE] {
    let mut sums = [[0.0; TILE]; TILE];
    for (one, other) in one.iter().zip(other) {
        for (sums, by) in sums.iter_mut().zip(other) {
            for (sum, entry) in sums.iter_mut().zip(one) {
                *sum += entry * by;
            }
        }
    }
    sums
}

/// Subtracts a column as often as its first entry says.
fn subtract_multiple(target: &mut [f64], column: &[f64]) {
    let by = column[0];
    target.iter_mut().zip(column).for_each(|(target, entry)| *target -= by * entry);
}
