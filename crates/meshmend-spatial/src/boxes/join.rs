//! The pairs of leaves of a tree whose boxes overlap: among them are all pairs of items that do.

use std::ops::{ControlFlow, Range};

use super::tree::{BoxTree, halves};

/// The level at which the search for pairs is cut into parts.
const CUT: u32 = 8;

/// A node of a tree, and where the items below it are.
#[derive(Clone, Debug)]
struct Branch {
    node: usize,
    items: Range<usize>,
}

/// Two nodes of one level, or one twice, below which pairs of leaves are looked for.
#[derive(Clone, Debug)]
pub struct JoinPart([Branch; 2]);

/// A leaf of a tree.
#[derive(Clone, Debug)]
pub struct Leaf {
    /// Its number among the leaves.
    pub number: usize,
    /// Where its items are in the order of [`BoxTree::items`].
    pub items: Range<usize>,
}

impl BoxTree {
    /// The parts of the search for all pairs of leaves whose boxes overlap, a leaf with itself included. Each pair is found
    /// in one of them.
    ///
    /// *Cost*: constant; some thousand parts where boxes are small beside the whole, 32 896 at most.
    pub fn join_parts(&self) -> Vec<JoinPart> {
        let root = Branch { node: 0, items: 0..self.items().len() };
        let mut parts = vec![JoinPart([root.clone(), root])];
        for _ in 0..self.depth().min(CUT) {
            let mut below = Vec::new();
            parts.into_iter().for_each(|part| self.each_below(part, &mut |part| below.push(part)));
            parts = below;
        }
        parts
    }

    /// Gives the pairs of leaves of a part, in an order that depends on nothing but the tree, until `found` breaks off. Of two
    /// different leaves the one with the lower number comes first.
    ///
    /// *Cost*: O(pairs) where boxes are small beside the whole.
    pub fn join(
        &self,
        part: JoinPart,
        found: &mut impl FnMut([Leaf; 2]) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let leaves = 1_usize << self.depth();
        let mut open = vec![part];
        while let Some(part) = open.pop() {
            if part.0[0].node + 1 >= leaves {
                found(part.0.map(|Branch { node, items }| Leaf { number: node + 1 - leaves, items }))?;
            } else {
                let first = open.len();
                self.each_below(part, &mut |part| open.push(part));
                open[first..].reverse();
            }
        }
        ControlFlow::Continue(())
    }

    /// The pairs of nodes below two nodes that overlap.
    fn each_below(&self, JoinPart([one, other]): JoinPart, found: &mut impl FnMut(JoinPart)) {
        let is_one = one.node == other.node;
        let [low, high] = one.below();
        let mut add_overlapping = |one: &Branch, other: &Branch| {
            if self.bounds_of(one.node).overlaps(self.bounds_of(other.node)) {
                found(JoinPart([one.clone(), other.clone()]));
            }
        };
        if is_one {
            add_overlapping(&low, &low);
            add_overlapping(&low, &high);
            add_overlapping(&high, &high);
        } else {
            let others = other.below();
            for one in [low, high] {
                others.iter().for_each(|other| add_overlapping(&one, other));
            }
        }
    }
}

impl Branch {
    fn below(&self) -> [Branch; 2] {
        let [one, other] = halves(self.items.clone());
        [Branch { node: 2 * self.node + 1, items: one }, Branch { node: 2 * self.node + 2, items: other }]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxes::Bounds;
    use crate::boxes::tree::tests::boxes;

    #[test]
    fn all_pairs_that_overlap_are_in_one_pair_of_leaves() {
        for count in [0, 1, 2, 16, 17, 100, 1000] {
            let all = boxes(count);
            let tree = BoxTree::over(count, |item| all[item]);
            let mut found = Vec::new();
            let mut look_at = |[one, other]: [Leaf; 2]| {
                let items = |leaf: &Leaf| tree.items()[leaf.items.clone()].to_vec();
                let (ones, others) = (items(&one), items(&other));
                let bounds = others.iter().map(|&item| all[item as usize]);
                assert_eq!(
                    *tree.bounds_of_leaf(other.number),
                    bounds.fold(Bounds::NONE, |one, other| one.with(&other))
                );
                for &one_item in &ones {
                    let is_asked = |item: &&u32| one.number != other.number || one_item < **item;
                    found.extend(
                        others.iter().filter(is_asked).map(|&item| (one_item.min(item), one_item.max(item))),
                    );
                }
                ControlFlow::Continue(())
            };
            for part in tree.join_parts() {
                assert!(tree.join(part, &mut look_at).is_continue());
            }
            let overlap = |&(one, other): &(u32, u32)| all[one as usize].overlaps(&all[other as usize]);
            found.retain(overlap);
            found.sort_unstable();
            let last = count as u32;
            let pairs = (0..last).flat_map(|one| (one + 1..last).map(move |other| (one, other)));
            assert_eq!(found, pairs.filter(overlap).collect::<Vec<_>>(), "{count}");
        }
    }

    #[test]
    fn a_search_breaks_off_where_it_is_told_to() {
        let all = boxes(100);
        let tree = BoxTree::over(100, |item| all[item]);
        let mut count = 0;
        let mut stop = |_: [Leaf; 2]| {
            count += 1;
            if count == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let ended: Vec<bool> =
            tree.join_parts().into_iter().map(|part| tree.join(part, &mut stop).is_break()).collect();
        assert_eq!(ended.into_iter().filter(|&is_broken| is_broken).count(), 1);
    }
}
