//! Sorting by comparisons that may contradict themselves.

use std::cmp::Ordering;

/// A stable merge sort that ends with some permutation whatever the comparison says: where coordinates underflow, exact
/// predicates may contradict themselves, and the standard sorts may then panic.
///
/// *Cost*: O(n log n) comparisons.
pub fn merge_sort<T>(items: &mut Vec<T>, compare: impl Fn(&T, &T) -> Ordering) {
    let mut runs: Vec<Vec<T>> = items.drain(..).map(|item| vec![item]).collect();
    while runs.len() > 1 {
        let mut halves = runs.into_iter();
        let mut merged = Vec::new();
        while let Some(one) = halves.next() {
            merged.push(match halves.next() {
                Some(other) => merge(one, other, &compare),
                None => one,
            });
        }
        runs = merged;
    }
    items.extend(runs.into_iter().flatten());
}

fn merge<T>(one: Vec<T>, other: Vec<T>, compare: &impl Fn(&T, &T) -> Ordering) -> Vec<T> {
    let mut merged = Vec::with_capacity(one.len() + other.len());
    let (mut one, mut other) = (one.into_iter().peekable(), other.into_iter().peekable());
    while let (Some(a), Some(b)) = (one.peek(), other.peek()) {
        let next = if compare(a, b) == Ordering::Greater { other.next() } else { one.next() };
        merged.extend(next);
    }
    merged.extend(one);
    merged.extend(other);
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comparison_that_contradicts_itself_still_gives_a_permutation() {
        let mut items: Vec<u32> = (0..100).collect();
        merge_sort(&mut items, |_, _| Ordering::Greater);
        items.sort_unstable();
        assert_eq!(items, (0..100).collect::<Vec<_>>());
        let mut items = vec![5, 3, 9, 1, 1, 0];
        merge_sort(&mut items, Ord::cmp);
        assert_eq!(items, [0, 1, 1, 3, 5, 9]);
    }
}
