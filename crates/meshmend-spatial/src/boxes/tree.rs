//! A binary tree over boxes. It does not depend on the number of threads.

use std::convert::Infallible;

use meshmend_core::{Cancelled, Watch};
use rayon::prelude::*;

use super::bounds::Bounds;
use crate::unit::Unit;

/// Most items of a leaf.
const LEAF: usize = super::few::MOST;
/// Parts with fewer items are split by one thread.
const PARALLEL: usize = 4096;

/// A tree over numbered items with a box each. The boxes of the items are not kept: whoever asks gives them again.
///
/// Each node's items are halved at the median of the box centres along the axis in which these lie farthest apart. So the
/// shape of the tree follows from their number: node k has the nodes 2 k + 1 and 2 k + 2 below it, and all leaves are equally
/// deep.
pub struct BoxTree {
    /// The items, leaf after leaf.
    items: Vec<u32>,
    nodes: Vec<Node>,
    depth: u32,
}

#[derive(Clone, Copy)]
struct Node {
    bounds: Bounds,
    /// The greatest item below.
    greatest: u32,
}

/// A box that is looked for among the items from a number on.
#[derive(Clone, Copy, Debug)]
pub struct Query {
    /// The box.
    pub bounds: Bounds,
    /// The lowest item that is asked about.
    pub from: u32,
}

/// An item while items are halved.
#[derive(Clone, Copy)]
struct Placed {
    /// The centre of its box, in steps of 2⁻³¹ of the whole.
    centre: [u32; 3],
    item: u32,
}

impl BoxTree {
    /// A tree over the items from 0 to `count` − 1.
    ///
    /// *Cost*: O(n log n); at most 18 bytes an item, and 16 more while it is built.
    pub fn over(count: usize, bounds: impl Fn(usize) -> Bounds + Sync) -> Self {
        let Ok(tree) = BoxTree::built(count, bounds, || Ok::<(), Infallible>(()));
        tree
    }

    /// The same, for work with a name that somebody watches.
    ///
    /// # Errors
    /// When they stop it.
    ///
    /// *Cost*: that of [`over`](Self::over).
    pub fn watched(
        count: usize,
        bounds: impl Fn(usize) -> Bounds + Sync,
        (watch, step): (&Watch, &'static str),
    ) -> Result<Self, Cancelled> {
        BoxTree::built(count, bounds, || watch.look(step, 0, 0))
    }

    fn built<E: Send>(
        count: usize,
        bounds: impl Fn(usize) -> Bounds + Sync,
        look: impl Fn() -> Result<(), E> + Sync,
    ) -> Result<Self, E> {
        let mut depth = 0;
        while count > LEAF << depth {
            depth += 1;
        }
        let items = halved(count, depth, &bounds, &look)?;
        look()?;
        let mut tree = BoxTree { items, nodes: Vec::new(), depth };
        tree.nodes = tree.enclosing(&bounds);
        Ok(tree)
    }

    /// The items in the order of the leaves, in which items that are near each other are near each other.
    #[inline]
    pub fn items(&self) -> &[u32] {
        &self.items
    }

    pub(super) fn depth(&self) -> u32 {
        self.depth
    }

    /// The box of a node.
    #[inline]
    pub(super) fn bounds_of(&self, node: usize) -> &Bounds {
        &self.nodes[node].bounds
    }

    /// The box of a leaf.
    #[inline]
    pub fn bounds_of_leaf(&self, leaf: usize) -> &Bounds {
        self.bounds_of((1 << self.depth) - 1 + leaf)
    }

    /// Finds for each of some queries the items whose boxes overlap its box: `found` gets the query's place and the item, in an
    /// order that depends on nothing but the tree and the queries.
    ///
    /// *Cost*: O(log n + found) a query where boxes are small beside the whole; queries near each other share the way down.
    pub fn each_overlap(
        &self,
        queries: &[Query],
        bounds: impl Fn(usize) -> Bounds,
        mut found: impl FnMut(usize, usize),
    ) {
        let all = queries.iter().fold(Bounds::NONE, |all, query| all.with(&query.bounds));
        let mut walk = Walk { tree: self, queries, all, bounds, active: Vec::new() };
        walk.active.extend(0..queries.len() as u32);
        walk.enter(0, 0, 0..self.items.len(), 0, &mut found);
    }

    /// Whether there is an item that `is_it` says `true` of; only those are asked for that lie in boxes that `enters` holds for, as
    /// it does for every box in which a box lies that it holds for.
    ///
    /// *Cost*: as many boxes as are entered, times the number of items of a leaf.
    pub fn any(&self, enters: impl Fn(&Bounds) -> bool, mut is_it: impl FnMut(usize) -> bool) -> bool {
        let mut open = vec![(0, 0, 0..self.items.len())];
        while let Some((at, level, items)) = open.pop() {
            if !enters(&self.nodes[at].bounds) {
                continue;
            }
            if level == self.depth {
                if self.items[items].iter().any(|&item| is_it(item as usize)) {
                    return true;
                }
            } else {
                let [one, other] = halves(items);
                open.extend([(2 * at + 2, level + 1, other), (2 * at + 1, level + 1, one)]);
            }
        }
        false
    }

    /// The boxes of all nodes.
    fn enclosing(&self, bounds: &(impl Fn(usize) -> Bounds + Sync)) -> Vec<Node> {
        let leaves = 1_usize << self.depth;
        let none = Node { bounds: Bounds::NONE, greatest: 0 };
        let mut nodes = vec![none; 2 * leaves - 1];
        let leaf = |(leaf, node): (usize, &mut Node)| {
            *node = self.items[self.leaf_range(leaf)].iter().fold(none, |node, &item| Node {
                bounds: node.bounds.with(&bounds(item as usize)),
                greatest: node.greatest.max(item),
            });
        };
        nodes[leaves - 1..].par_iter_mut().enumerate().with_min_len(PARALLEL / LEAF).for_each(leaf);
        for at in (0..leaves - 1).rev() {
            let [one, other] = [nodes[2 * at + 1], nodes[2 * at + 2]];
            nodes[at] =
                Node { bounds: one.bounds.with(&other.bounds), greatest: one.greatest.max(other.greatest) };
        }
        nodes
    }

    /// Where the items of a leaf are.
    fn leaf_range(&self, leaf: usize) -> std::ops::Range<usize> {
        let mut range = 0..self.items.len();
        for level in (0..self.depth).rev() {
            let [one, other] = halves(range);
            range = if leaf >> level & 1 == 0 { one } else { other };
        }
        range
    }
}

/// One search down the tree.
struct Walk<'a, B> {
    tree: &'a BoxTree,
    queries: &'a [Query],
    /// The box that holds those of all queries.
    all: Bounds,
    bounds: B,
    /// The queries that reach a node, for each node on the way down.
    active: Vec<u32>,
}

impl<B: Fn(usize) -> Bounds> Walk<'_, B> {
    /// Enters a node with the queries that reached the one above it, which begin at `above` in the list.
    fn enter(
        &mut self,
        at: usize,
        level: u32,
        items: std::ops::Range<usize>,
        above: usize,
        found: &mut impl FnMut(usize, usize),
    ) {
        let first = self.active.len();
        self.filter(&self.tree.nodes[at], above..first);
        if self.active.len() > first {
            if level == self.tree.depth {
                self.look_at(items, first, found);
            } else {
                let [one, other] = halves(items);
                self.enter(2 * at + 1, level + 1, one, first, found);
                self.enter(2 * at + 2, level + 1, other, first, found);
            }
        }
        self.active.truncate(first);
    }

    /// Appends those of some active queries that reach a node.
    fn filter(&mut self, node: &Node, above: std::ops::Range<usize>) {
        if !node.bounds.overlaps(&self.all) {
            return;
        }
        // Each is written, and kept if it reaches the node: a branch would be guessed wrong too often.
        let mut end = above.end;
        self.active.resize(above.end + above.len(), 0);
        for place in above {
            let query = &self.queries[self.active[place] as usize];
            self.active[end] = self.active[place];
            end += usize::from(node.bounds.overlaps(&query.bounds) & (node.greatest >= query.from));
        }
        self.active.truncate(end);
    }

    /// Compares a leaf's items with the queries that reached it.
    fn look_at(&self, items: std::ops::Range<usize>, first: usize, found: &mut impl FnMut(usize, usize)) {
        for &item in &self.tree.items[items] {
            let bounds = (self.bounds)(item as usize);
            for &place in &self.active[first..] {
                let query = &self.queries[place as usize];
                if (item >= query.from) & query.bounds.overlaps(&bounds) {
                    found(place as usize, item as usize);
                }
            }
        }
    }
}

/// The items in the order of the leaves.
fn halved<E: Send>(
    count: usize,
    depth: u32,
    bounds: &(impl Fn(usize) -> Bounds + Sync),
    look: &(impl Fn() -> Result<(), E> + Sync),
) -> Result<Vec<u32>, E> {
    let items = || (0..count).into_par_iter().with_min_len(PARALLEL);
    let all = items().map(bounds).reduce(|| Bounds::NONE, |one, other| one.with(&other));
    let place = |x: f64, low: f64| x / 2.0 - low / 2.0;
    let extent = (0..3).map(|i| place(all.high[i], all.low[i])).fold(0.0, f64::max);
    let unit = Unit::of(extent);
    let placed = |item: usize| {
        let centre = bounds(item).centre();
        let centre = unit.shrunk(std::array::from_fn(|i| place(centre[i], all.low[i])));
        Placed { centre: centre.map(|x| (x * f64::from(1_u32 << 31)) as u32), item: item as u32 }
    };
    look()?;
    let mut placed: Vec<Placed> = items().map(placed).collect();
    halve(&mut placed, depth, look)?;
    Ok(placed.into_iter().map(|placed| placed.item).collect())
}

fn halve<E: Send>(
    all: &mut [Placed],
    levels: u32,
    look: &(impl Fn() -> Result<(), E> + Sync),
) -> Result<(), E> {
    if levels == 0 {
        return Ok(());
    }
    let is_large = all.len() >= PARALLEL;
    if is_large {
        look()?;
    }
    let none = ([u32::MAX; 3], [0; 3]);
    let (low, high) = all.iter().fold(none, |(low, high), Placed { centre, .. }| {
        (std::array::from_fn(|i| low[i].min(centre[i])), std::array::from_fn(|i| high[i].max(centre[i])))
    });
    let lengths: [u32; 3] = std::array::from_fn(|i| high[i].saturating_sub(low[i]));
    let axis = (1..3).fold(0, |most, i| if lengths[i] > lengths[most] { i } else { most });
    let [one, _] = halves(0..all.len());
    if one.end < all.len() {
        all.select_nth_unstable_by_key(one.end, |placed| {
            u64::from(placed.centre[axis]) << 32 | u64::from(placed.item)
        });
    }
    let (low, high) = all.split_at_mut(one.end);
    if is_large {
        let (one, other) = rayon::join(|| halve(low, levels - 1, look), || halve(high, levels - 1, look));
        one.and(other)
    } else {
        halve(low, levels - 1, look)?;
        halve(high, levels - 1, look)
    }
}

/// The two halves of a node's items.
pub(super) fn halves(items: std::ops::Range<usize>) -> [std::ops::Range<usize>; 2] {
    let middle = items.start + items.len() / 2;
    [items.start..middle, middle..items.end]
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Boxes of many sizes in some order.
    pub(in crate::boxes) fn boxes(count: usize) -> Vec<Bounds> {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 40) as f64 / f64::from(1 << 24)
        };
        (0..count)
            .map(|_| {
                let low = [next(), next(), (next() * 4.0).floor()];
                let size = next().powi(8);
                Bounds { low, high: low.map(|x| x + size) }
            })
            .collect()
    }

    #[test]
    fn overlaps_are_those_of_all_pairs() {
        for count in [0, 1, 2, 8, 9, 100, 1000] {
            let all = boxes(count);
            let tree = BoxTree::over(count, |item| all[item]);
            let queries: Vec<Query> =
                (0..count).map(|item| Query { bounds: all[item], from: item as u32 + 1 }).collect();
            let mut found = Vec::new();
            tree.each_overlap(&queries, |item| all[item], |query, item| found.push((query, item)));
            found.sort_unstable();
            let pairs = (0..count).flat_map(|one| (one + 1..count).map(move |other| (one, other)));
            let expected: Vec<(usize, usize)> =
                pairs.filter(|&(one, other)| all[one].overlaps(&all[other])).collect();
            assert_eq!(found, expected, "{count}");
        }
    }

    #[test]
    fn some_item_is_found_where_there_is_one() {
        let all = boxes(100);
        let tree = BoxTree::over(100, |item| all[item]);
        for (wanted, of_it) in all.iter().enumerate() {
            let enters = |bounds: &Bounds| bounds.overlaps(of_it);
            assert!(tree.any(enters, |item| item == wanted));
            assert!(!tree.any(enters, |_| false));
        }
        assert!(!BoxTree::over(0, |item| all[item]).any(|_| true, |_| true));
    }
}
