//! The rank of a matrix most of whose rows have one entry or two.
//!
//! A row is an equation between unknowns. One entry says that an unknown is 0, two that one unknown is a multiple of
//! another. Such rows are put into a forest of unknowns, each with its multiple of its parent. What is left are the rows
//! with more entries, told by the roots: they are few, and go to elimination. So ∂₁, and ∂₂ of a manifold, have their rank
//! at once.

use crate::homology::{PrimeField, SparseRows};

/// Unknowns over a prime field, joined where one is a multiple of another.
#[derive(Debug)]
pub(super) struct Contraction {
    field: PrimeField,
    parents: Vec<u32>,
    /// Each unknown is so many times its parent.
    ratios: Vec<u32>,
    /// How many unknowns are below a root.
    sizes: Vec<u32>,
    /// Whether a root is 0, and so all below it.
    is_zero: Vec<bool>,
    rank: usize,
}

/// A row: unknowns with their coefficients.
pub(super) type Row = Vec<(u32, i64)>;

/// The rank of a matrix given by its rows, or `None` if elimination would touch more than `budget` entries.
///
/// *Cost*: nearly linear for rows of up to two entries; elimination for the rest.
pub(super) fn rank(
    field: PrimeField,
    column_count: usize,
    rows: impl Iterator<Item = Row>,
    budget: u64,
) -> Option<usize> {
    let mut contraction = Contraction::new(field, column_count);
    let mut long: Vec<Row> = rows.filter_map(|row| contraction.take(row)).collect();
    // The short rows behind a long one may have shortened it.
    long = long.into_iter().filter_map(|row| contraction.take(row)).collect();
    let mut rest = SparseRows::new(field);
    for row in long {
        rest.push(&mut contraction.told_by_roots(row));
    }
    Some(contraction.rank + rest.rank(column_count, budget)?)
}

impl Contraction {
    fn new(field: PrimeField, unknowns: usize) -> Self {
        Contraction {
            field,
            parents: (0..unknowns as u32).collect(),
            ratios: vec![1; unknowns],
            sizes: vec![1; unknowns],
            is_zero: vec![false; unknowns],
            rank: 0,
        }
    }

    /// Takes a row in if the roots tell it in at most two entries, and gives it back if not.
    fn take(&mut self, row: Row) -> Option<Row> {
        let row = self.told_by_roots(row);
        match row[..] {
            [] => None,
            [(root, _)] => {
                self.is_zero[root as usize] = true;
                self.rank += 1;
                None
            }
            [one, other] => {
                self.join(one, other);
                self.rank += 1;
                None
            }
            _ => Some(row),
        }
    }

    /// The row with each unknown replaced by its root, ascending, without what is 0.
    fn told_by_roots(&mut self, row: Row) -> Row {
        let mut told: Row = Vec::with_capacity(row.len());
        for (unknown, coefficient) in row {
            let (root, ratio) = self.root(unknown);
            if !self.is_zero[root as usize] {
                let residue = self.field.product(self.field.residue(coefficient), ratio);
                told.push((root, i64::from(residue)));
            }
        }
        told.sort_unstable();
        let runs = told.chunk_by(|one, other| one.0 == other.0);
        let sums = runs.map(|run| {
            let sum = run.iter().map(|term| term.1).sum();
            (run[0].0, i64::from(self.field.residue(sum)))
        });
        sums.filter(|term| term.1 != 0).collect()
    }

    /// The root above an unknown, and how many times the root it is.
    fn root(&mut self, unknown: u32) -> (u32, u32) {
        let (mut at, mut ratio) = (unknown as usize, 1);
        loop {
            let parent = self.parents[at] as usize;
            if parent == at {
                return (at as u32, ratio);
            }
            // Each unknown on the way is hung below its grandparent.
            if self.parents[parent] as usize != parent {
                self.ratios[at] = self.field.product(self.ratios[at], self.ratios[parent]);
                self.parents[at] = self.parents[parent];
            }
            ratio = self.field.product(ratio, self.ratios[at]);
            at = self.parents[at] as usize;
        }
    }

    /// Joins two roots by the equation that their multiples add up to 0.
    fn join(&mut self, one: (u32, i64), other: (u32, i64)) {
        let is_smaller = self.sizes[one.0 as usize] < self.sizes[other.0 as usize];
        let ((low, of_low), (high, of_high)) = if is_smaller { (one, other) } else { (other, one) };
        let quotient =
            self.field.product(self.field.residue(of_high), self.field.inverse(self.field.residue(of_low)));
        self.parents[low as usize] = high;
        self.ratios[low as usize] = self.field.residue(-i64::from(quotient));
        self.sizes[high as usize] += self.sizes[low as usize];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Random, dense_rank};

    #[test]
    fn the_rank_is_that_of_the_dense_matrix() {
        let mut random = Random(23);
        for round in 0..3000 {
            let (height, width) = (1 + random.below(12), 1 + random.below(9));
            let mut dense = vec![vec![0i64; width]; height];
            // Mostly short rows.
            for row in &mut dense {
                for _ in 0..1 + random.below(if round % 2 == 0 { 3 } else { 5 }) {
                    row[random.below(width)] = random.below(7) as i64 - 3;
                }
            }
            for prime in [2, 3, 5, (1 << 31) - 1] {
                let rows = dense.iter().map(|row| (0u32..).zip(row.iter().copied()).collect());
                let found = rank(PrimeField::modulo(prime), width, rows, 1 << 20);
                assert_eq!(found, Some(dense_rank(&dense, i64::from(prime))), "{prime} {dense:?}");
            }
        }
    }

    #[test]
    fn the_largest_prime_below_2_to_the_32_does_not_overflow() {
        let field = PrimeField::modulo(4_294_967_291);
        let rows = [vec![(0, -1), (1, 2)], vec![(1, -3), (2, 1)], vec![(0, 1), (1, 1), (2, -1)]];
        assert_eq!(rank(field, 3, rows.into_iter(), 100), Some(2));
    }

    #[test]
    fn long_chains_are_joined_in_nearly_no_time() {
        let rows = (0..200_000u32).map(|i| vec![(i, 1), (i + 1, -1)]);
        assert_eq!(rank(PrimeField::TWO, 200_001, rows, 1), Some(200_000));
    }
}
