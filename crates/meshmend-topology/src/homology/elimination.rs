//! What is the rank of a sparse matrix over the integers modulo a prime?
//!
//! Elimination takes pivots that cause little fill: first columns with one entry, which cost nothing, then the
//! shortest row, and in it the column with the fewest entries. Entries are counted as they are touched, and
//! beyond a budget the answer is that there is none: a matrix can be small and its elimination huge.
//!
//! *Source*: for the choice of pivots: H. M. Markowitz, *The elimination form of the inverse*, 1957.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

/// The integers modulo a prime below 2³².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PrimeField(u32);

impl PrimeField {
    /// The integers modulo 2.
    pub(crate) const TWO: PrimeField = PrimeField(2);
    /// The integers modulo 2³¹ − 1, which stand for the rationals.
    pub(crate) const LARGE: PrimeField = PrimeField((1 << 31) - 1);

    /// The integers modulo a number, which has to be a prime.
    pub(crate) fn modulo(prime: u32) -> Self {
        PrimeField(prime)
    }

    pub(crate) fn residue(self, number: i64) -> u32 {
        number.rem_euclid(i64::from(self.0)) as u32
    }

    pub(crate) fn product(self, one: u32, other: u32) -> u32 {
        (u64::from(one) * u64::from(other) % u64::from(self.0)) as u32
    }

    fn difference(self, one: u32, other: u32) -> u32 {
        self.residue(i64::from(one) - i64::from(other))
    }

    /// The inverse of a residue that is not 0, by Fermat's little theorem.
    pub(crate) fn inverse(self, residue: u32) -> u32 {
        let (mut power, mut square, mut exponent) = (1, residue, self.0 - 2);
        while exponent > 0 {
            if exponent & 1 == 1 {
                power = self.product(power, square);
            }
            square = self.product(square, square);
            exponent >>= 1;
        }
        power
    }
}

/// Rows of a sparse matrix over a prime field, multiples of one another kept once.
#[derive(Debug)]
pub(crate) struct SparseRows {
    field: PrimeField,
    starts: Vec<usize>,
    /// (column, residue), ascending in each row, residues not 0, the first one 1.
    entries: Vec<(u32, u32)>,
}

impl SparseRows {
    pub(crate) fn new(field: PrimeField) -> Self {
        SparseRows { field, starts: vec![0], entries: Vec::new() }
    }

    /// Adds a row given as terms of columns, in any order, repeats adding up; sorts the terms.
    pub(crate) fn push(&mut self, terms: &mut [(u32, i64)]) {
        terms.sort_unstable();
        let before = self.entries.len();
        for run in terms.chunk_by(|one, other| one.0 == other.0) {
            let residue = self.field.residue(run.iter().map(|term| term.1).sum());
            if residue != 0 {
                self.entries.push((run[0].0, residue));
            }
        }
        if let Some(first) = self.entries.get(before) {
            let scale = self.field.inverse(first.1);
            for entry in &mut self.entries[before..] {
                entry.1 = self.field.product(entry.1, scale);
            }
            self.starts.push(self.entries.len());
        }
    }

    fn row(&self, row: usize) -> &[(u32, u32)] {
        &self.entries[self.starts[row]..self.starts[row + 1]]
    }

    /// The rank, or nothing when elimination would touch more than `budget` entries.
    ///
    /// *Cost*: linear where columns with one entry unravel the matrix; at most `budget` entries touched.
    pub(crate) fn rank(&self, column_count: usize, budget: u64) -> Option<usize> {
        let mut different: Vec<usize> = (0..self.starts.len() - 1).collect();
        different.sort_unstable_by(|&one, &other| self.row(one).cmp(self.row(other)));
        different.dedup_by(|one, other| self.row(*one) == self.row(*other));
        let entry_count: usize = different.iter().map(|&row| self.row(row).len()).sum();
        let budget = budget.checked_sub(entry_count as u64)?;
        let rows = different.into_iter().map(|row| self.row(row));
        Elimination::new(self.field, rows, column_count, budget).rank()
    }
}

/// A matrix in the course of elimination, seen by rows and by columns.
struct Elimination {
    field: PrimeField,
    rows: Vec<BTreeMap<u32, u32>>,
    columns: Vec<BTreeSet<u32>>,
    /// Columns that had one entry at some time.
    lone: Vec<u32>,
    /// Rows by length, also at lengths that they no longer have.
    by_length: BinaryHeap<Reverse<(usize, u32)>>,
    budget: u64,
}

impl Elimination {
    fn new<'a>(
        field: PrimeField,
        rows: impl Iterator<Item = &'a [(u32, u32)]>,
        column_count: usize,
        budget: u64,
    ) -> Self {
        let rows: Vec<BTreeMap<u32, u32>> = rows.map(|row| row.iter().copied().collect()).collect();
        let mut columns = vec![BTreeSet::new(); column_count];
        for (row, entries) in (0u32..).zip(&rows) {
            entries.keys().for_each(|&column| {
                columns[column as usize].insert(row);
            });
        }
        let lone =
            (0u32..).zip(&columns).filter(|(_, rows)| rows.len() == 1).map(|(column, _)| column).collect();
        let by_length = (0u32..).zip(&rows).map(|(row, entries)| Reverse((entries.len(), row))).collect();
        Elimination { field, rows, columns, lone, by_length, budget }
    }

    fn rank(mut self) -> Option<usize> {
        let mut rank = 0;
        while let Some((row, column)) = self.next_pivot() {
            rank += 1;
            self.eliminate(row, column)?;
        }
        Some(rank)
    }

    fn next_pivot(&mut self) -> Option<(u32, u32)> {
        while let Some(column) = self.lone.pop() {
            let rows = &self.columns[column as usize];
            if let (1, Some(&row)) = (rows.len(), rows.first()) {
                return Some((row, column));
            }
        }
        while let Some(Reverse((length, row))) = self.by_length.pop() {
            let entries = &self.rows[row as usize];
            if entries.len() == length {
                let fewest = entries.keys().min_by_key(|&&column| self.columns[column as usize].len());
                if let Some(&column) = fewest {
                    return Some((row, column));
                }
            }
        }
        None
    }

    /// Takes a row out and its pivot column out of all other rows; `None` when the budget is spent.
    fn eliminate(&mut self, row: u32, column: u32) -> Option<()> {
        let pivot_row = std::mem::take(&mut self.rows[row as usize]);
        for &other in pivot_row.keys() {
            self.remove_from_column(other, row);
        }
        let targets = std::mem::take(&mut self.columns[column as usize]);
        let touched = (targets.len() as u64 + 1).saturating_mul(pivot_row.len() as u64);
        self.budget = self.budget.checked_sub(touched)?;
        let inverse = self.field.inverse(*pivot_row.get(&column)?);
        for target in targets {
            let factor = self.rows[target as usize].remove(&column).unwrap_or(0);
            let factor = self.field.product(factor, inverse);
            for (&other, &residue) in pivot_row.iter().filter(|entry| *entry.0 != column) {
                self.subtract(target, other, self.field.product(factor, residue));
            }
            self.by_length.push(Reverse((self.rows[target as usize].len(), target)));
        }
        Some(())
    }

    fn subtract(&mut self, row: u32, column: u32, amount: u32) {
        let entry = self.rows[row as usize].entry(column).or_insert(0);
        let before = *entry;
        *entry = self.field.difference(before, amount);
        if *entry == 0 {
            self.rows[row as usize].remove(&column);
            self.remove_from_column(column, row);
        } else if before == 0 {
            self.columns[column as usize].insert(row);
        }
    }

    fn remove_from_column(&mut self, column: u32, row: u32) {
        self.columns[column as usize].remove(&row);
        if self.columns[column as usize].len() == 1 {
            self.lone.push(column);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Random, dense_rank};

    #[test]
    fn inverses_are_inverse() {
        for residue in [1, 2, 3, 65537, (1 << 31) - 2] {
            assert_eq!(PrimeField::LARGE.product(residue, PrimeField::LARGE.inverse(residue)), 1);
        }
        assert_eq!(PrimeField::TWO.inverse(1), 1);
    }

    #[test]
    fn the_rank_is_that_of_the_dense_matrix() {
        let mut random = Random(11);
        for _ in 0..2000 {
            let (height, width) = (1 + random.below(9), 1 + random.below(9));
            let mut dense = vec![vec![0i64; width]; height];
            for _ in 0..random.below(30) {
                dense[random.below(height)][random.below(width)] = random.below(5) as i64 - 2;
            }
            for field in [PrimeField::TWO, PrimeField::LARGE] {
                let mut sparse = SparseRows::new(field);
                for row in &dense {
                    sparse.push(&mut (0u32..).zip(row.iter().copied()).collect::<Vec<_>>());
                }
                assert_eq!(sparse.rank(width, 1 << 20), Some(dense_rank(&dense, i64::from(field.0))));
            }
        }
    }

    #[test]
    fn beyond_the_budget_there_is_no_answer() {
        let mut rows = SparseRows::new(PrimeField::LARGE);
        (1..=8i64).for_each(|i| rows.push(&mut (0..8u32).map(|j| (j, i.pow(j))).collect::<Vec<_>>()));
        assert_eq!(rows.rank(8, 1 << 12), Some(8));
        assert_eq!(rows.rank(8, 100), None);
    }
}
