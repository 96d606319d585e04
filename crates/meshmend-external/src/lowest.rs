//! The lowest of many things, as many as are listed.

use std::collections::BinaryHeap;

/// How many things there were, and the lowest of them.
#[derive(Debug)]
pub(crate) struct Lowest<T> {
    count: u64,
    most: usize,
    kept: BinaryHeap<T>,
}

impl<T: Ord> Lowest<T> {
    /// Keeps so many at most.
    pub(crate) fn new(most: usize) -> Self {
        Lowest { count: 0, most, kept: BinaryHeap::new() }
    }

    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    /// The same things out of more.
    pub(crate) fn counting(self, count: u64) -> Self {
        Lowest { count, ..self }
    }

    #[inline]
    pub(crate) fn add(&mut self, thing: T) {
        self.count += 1;
        if self.kept.len() < self.most {
            self.kept.push(thing);
        } else if let Some(mut highest) = self.kept.peek_mut()
            && thing < *highest
        {
            *highest = thing;
        }
    }

    /// Those that were kept, ascending.
    pub(crate) fn into_kept(self) -> Vec<T> {
        self.kept.into_sorted_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_are_kept_and_all_are_counted() {
        for most in [0, 1, 5, 100] {
            let mut lowest = Lowest::new(most);
            (0..50u32).for_each(|n| lowest.add(n * 37 % 53));
            assert_eq!(lowest.count(), 50);
            let mut all: Vec<u32> = (0..50).map(|n| n * 37 % 53).collect();
            all.sort_unstable();
            all.truncate(most);
            assert_eq!(lowest.into_kept(), all);
        }
    }
}
