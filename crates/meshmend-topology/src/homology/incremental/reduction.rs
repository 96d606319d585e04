//! Does a column depend on those before it, over the integers modulo 2?
//!
//! Each column is reduced by those before it that have its largest row as theirs; what is left is nothing, or has a
//! largest row of its own.
//!
//! *Source*: H. Edelsbrunner, D. Letscher, A. Zomorodian, *Topological persistence and simplification*, 2002.

use std::cmp::Ordering;

/// Columns that don't depend on one another, by their largest rows.
#[derive(Debug)]
pub(super) struct Reduction {
    /// The column that has a row as its largest.
    of_row: Vec<Option<Box<[u32]>>>,
    budget: u64,
}

impl Reduction {
    /// No column yet; at most so many entries are touched.
    pub(super) fn new(row_count: usize, budget: u64) -> Self {
        Reduction { of_row: vec![None; row_count], budget }
    }

    /// Adds a column of ascending rows and says whether it depends on those before it; `None` beyond the budget,
    /// after which no other column may be added.
    pub(super) fn depends(&mut self, mut column: Vec<u32>) -> Option<bool> {
        loop {
            let Some(&largest) = column.last() else { return Some(true) };
            let Some(reducing) = self.of_row.get_mut(largest as usize) else { return Some(false) };
            let Some(reducing) = reducing else {
                *reducing = Some(column.into());
                return Some(false);
            };
            self.budget = self.budget.checked_sub((column.len() + reducing.len()) as u64)?;
            column = sum(&column, reducing);
        }
    }
}

/// The rows that are in just one of two columns.
fn sum(one: &[u32], other: &[u32]) -> Vec<u32> {
    let mut rows = Vec::with_capacity(one.len() + other.len());
    let (mut i, mut j) = (0, 0);
    while let (Some(a), Some(b)) = (one.get(i), other.get(j)) {
        match a.cmp(b) {
            Ordering::Less => rows.push(*a),
            Ordering::Greater => rows.push(*b),
            Ordering::Equal => {}
        }
        i += usize::from(a <= b);
        j += usize::from(b <= a);
    }
    rows.extend(&one[i..]);
    rows.extend(&other[j..]);
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{Random, dense_rank};

    #[test]
    fn what_depends_is_what_leaves_the_rank_as_it_is() {
        let mut random = Random(61);
        for _ in 0..500 {
            let mut reduction = Reduction::new(6, u64::MAX);
            let mut dense: Vec<Vec<i64>> = Vec::new();
            for _ in 0..9 {
                let column: Vec<u32> = (0..6).filter(|_| random.below(3) == 0).collect();
                let before = dense_rank(&dense, 2);
                dense.push((0..6).map(|row| i64::from(column.contains(&row))).collect());
                assert_eq!(reduction.depends(column), Some(dense_rank(&dense, 2) == before));
            }
        }
    }

    #[test]
    fn the_budget_counts_entries() {
        let mut reduction = Reduction::new(4, 6);
        assert_eq!(reduction.depends(vec![0, 1, 3]), Some(false));
        assert_eq!(reduction.depends(vec![1, 2, 3]), Some(false));
        assert_eq!(reduction.depends(vec![3]), None);
    }
}
