//! Faces as cyclic words: spikes folded, loops taken apart; and classes of things.

use std::collections::{BTreeMap, VecDeque};

/// Drops consecutive repeats (the earlier corner stays) and folds x y x to the first x: one pass, then the ends.
pub(super) fn fold_spikes(word: &[u32], name: impl Fn(u32) -> u32) -> Vec<u32> {
    let same = |a: u32, b: u32| name(a) == name(b);
    let mut stack: VecDeque<u32> = VecDeque::new();
    for &corner in word {
        let n = stack.len();
        if n > 0 && same(stack[n - 1], corner) {
            continue;
        }
        if n > 1 && same(stack[n - 2], corner) {
            stack.pop_back();
        } else {
            stack.push_back(corner);
        }
    }
    while stack.len() > 1 {
        let n = stack.len();
        if same(stack[0], stack[n - 1]) || (n > 2 && same(stack[n - 2], stack[0])) {
            stack.pop_back();
        } else if n > 2 && same(stack[n - 1], stack[1]) {
            stack.pop_front();
        } else {
            break;
        }
    }
    stack.into()
}

/// Splits a word at repeated vertices, inner loops first; those with three corners or more.
pub(super) fn simple_loops(word: &[u32], name: impl Fn(u32) -> u32) -> Vec<Vec<u32>> {
    let (mut loops, mut stack, mut place) = (Vec::new(), Vec::new(), BTreeMap::new());
    for &corner in word {
        match place.get(&name(corner)) {
            Some(&at) => {
                let at: usize = at;
                loops.push(stack[at..].to_vec());
                stack.drain(at + 1..).for_each(|c| {
                    place.remove(&name(c));
                });
            }
            None => {
                place.insert(name(corner), stack.len());
                stack.push(corner);
            }
        }
    }
    loops.push(stack);
    loops.retain(|found| found.len() >= 3);
    loops
}

/// The rotation that begins at the first of the least names.
pub(super) fn canonical(names: &[u32]) -> Vec<u32> {
    let least = (0..names.len()).min_by_key(|&i| names[i]).unwrap_or(0);
    [&names[least..], &names[..least]].concat()
}

/// Union-find whose root is the lowest member.
pub(super) struct Classes {
    parent: Vec<usize>,
}

impl Classes {
    pub(super) fn new(size: usize) -> Self {
        Classes { parent: (0..size).collect() }
    }

    pub(super) fn root(&self, mut at: usize) -> usize {
        while self.parent[at] != at {
            at = self.parent[at];
        }
        at
    }

    pub(super) fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.root(one), self.root(other));
        self.parent[one.max(other)] = one.min(other);
    }
}

/// Where each face's corners begin in a list of all, and one more.
pub(super) fn bases(sizes: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut bases = vec![0];
    for size in sizes {
        bases.push(bases[bases.len() - 1] + size);
    }
    bases
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spikes_fold_and_the_first_corner_stays() {
        assert_eq!(fold_spikes(&[0, 1, 2, 1, 3], |v| v), [0, 1, 3]);
        assert_eq!(fold_spikes(&[1, 0, 2, 3, 0], |v| v), [0, 2, 3]);
        assert_eq!(fold_spikes(&[0, 1, 1, 2, 0], |v| v), [0, 1, 2]);
    }

    #[test]
    fn inner_loops_come_first() {
        let loops = simple_loops(&[0, 1, 2, 0, 3, 4], |v| v);
        assert_eq!(loops, [vec![0, 1, 2], vec![0, 3, 4]]);
    }
}
