//! Which side of a plane polygon lies below each of its corners.

use super::plane::Plane;

/// The sides that run to the right, and so have the inside above them where the polygon runs round it anticlockwise.
///
/// A segment tree over the corners from left to right: a node stands for a range of them, and holds the sides that
/// reach over all of it and not over all of its parent's, from the lowest to the highest. Sides that don't cross
/// have one order there; others have some order.
pub(super) struct Sides<'a> {
    plane: &'a Plane,
    /// Where each node's sides start. Node 1 is the root, node k has the children 2k and 2k + 1.
    starts: Vec<u32>,
    /// A side is named after the corner at which it starts.
    sides: Vec<u32>,
    leaf_count: usize,
}

impl<'a> Sides<'a> {
    /// *Cost*: O(n log² n) time, O(n log n) memory.
    pub(super) fn of(plane: &'a Plane) -> Self {
        let leaf_count = plane.len().next_power_of_two();
        let mut starts = vec![0u32; 2 * leaf_count + 1];
        let rightward = || (0..plane.len()).filter(|&side| plane.rank(side) < plane.rank(plane.next(side)));
        for side in rightward() {
            nodes_of(plane, side, leaf_count, |node| starts[node + 1] += 1);
        }
        let mut sum = 0;
        for start in &mut starts {
            sum += *start;
            *start = sum;
        }
        let mut free = starts.clone();
        let mut sides = vec![0u32; sum as usize];
        for side in rightward() {
            nodes_of(plane, side, leaf_count, |node| {
                sides[free[node] as usize] = side as u32;
                free[node] += 1;
            });
        }
        let mut found = Sides { plane, starts, sides, leaf_count };
        found.sort();
        found
    }

    /// The highest side below a corner that does not end there.
    ///
    /// *Cost*: O(log² n).
    pub(super) fn below(&self, corner: usize) -> Option<usize> {
        let path =
            std::iter::successors(Some(self.plane.rank(corner) + self.leaf_count), |&node| Some(node / 2));
        let highest_of = |node: usize| {
            let sides = &self.sides[self.range(node)];
            let count = sides.partition_point(|&side| {
                let side = side as usize;
                self.plane.turn(side, self.plane.next(side), corner) > 0.0
            });
            count.checked_sub(1).map(|last| sides[last] as usize)
        };
        let x = self.plane.point(corner)[0];
        let height = |side: usize| self.plane.height(side, x);
        let highest = path.take_while(|&node| node > 0).filter_map(highest_of);
        highest.max_by(|&one, &other| height(one).total_cmp(&height(other)).then(one.cmp(&other)))
    }

    fn range(&self, node: usize) -> std::ops::Range<usize> {
        self.starts[node] as usize..self.starts[node + 1] as usize
    }

    /// Brings each node's sides into order by their heights amid the node's range: whatever the numbers are, a total
    /// order.
    fn sort(&mut self) {
        for node in 1..2 * self.leaf_count {
            let level = node.ilog2();
            let width = self.leaf_count >> level;
            let first = (node - (1 << level)) * width;
            let ends = [first, first + width - 1].map(|rank| {
                let corner = self.plane.corner_at(rank.min(self.plane.len() - 1));
                self.plane.point(corner)[0]
            });
            let middle = ends[0] / 2.0 + ends[1] / 2.0;
            let range = self.range(node);
            let plane = self.plane;
            let height = |side: u32| plane.height(side as usize, middle);
            self.sides[range]
                .sort_unstable_by(|&one, &other| height(one).total_cmp(&height(other)).then(one.cmp(&other)));
        }
    }
}

/// Calls for each node that holds a side: those whose ranges make up the corners strictly between its ends.
fn nodes_of(plane: &Plane, side: usize, leaf_count: usize, mut call: impl FnMut(usize)) {
    let mut low = plane.rank(side) + 1 + leaf_count;
    let mut high = plane.rank(plane.next(side)) + leaf_count;
    while low < high {
        if low % 2 == 1 {
            call(low);
            low += 1;
        }
        if high % 2 == 1 {
            high -= 1;
            call(high);
        }
        low /= 2;
        high /= 2;
    }
}
