//! The chains of a sweep: the corners that wait for triangles, strip by strip.

use super::corners::Triangle;
use super::outline::Outline;

const NONE: u32 = u32::MAX;

/// The corners that wait in a strip: its lowest and highest node, and the one furthest to the right.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chain {
    low: u32,
    high: u32,
    rightmost: u32,
}

/// A corner in a chain, and the nodes below and above it.
#[derive(Clone, Copy, Debug)]
struct Node {
    corner: usize,
    below: u32,
    above: u32,
}

/// The corners of all chains, and the triangles that were cut off.
pub(super) struct Chains<'a> {
    outline: &'a Outline,
    nodes: Vec<Node>,
    triangles: Vec<Triangle>,
}

impl<'a> Chains<'a> {
    /// None yet.
    pub(super) fn of(outline: &'a Outline) -> Self {
        Chains { outline, nodes: Vec::new(), triangles: Vec::new() }
    }

    /// All triangles that were cut off.
    pub(super) fn into_triangles(self) -> Vec<Triangle> {
        self.triangles
    }

    /// Cuts off all that is left of a chain, from the corner at which its strip ends.
    pub(super) fn close(&mut self, chain: Chain, corner: usize) {
        let mut node = chain.low;
        while self.above(node) != NONE {
            self.emit([self.corner(node), corner, self.corner(self.above(node))]);
            node = self.above(node);
        }
    }

    fn corner(&self, node: u32) -> usize {
        self.nodes[node as usize].corner
    }

    fn below(&self, node: u32) -> u32 {
        self.nodes[node as usize].below
    }

    fn above(&self, node: u32) -> u32 {
        self.nodes[node as usize].above
    }

    fn node(&mut self, corner: usize) -> u32 {
        self.nodes.push(Node { corner, below: NONE, above: NONE });
        self.nodes.len() as u32 - 1
    }

    /// A chain of one corner.
    pub(super) fn single(&mut self, corner: usize) -> Chain {
        let node = self.node(corner);
        Chain { low: node, high: node, rightmost: node }
    }

    fn link(&mut self, lower: u32, upper: u32) {
        self.nodes[lower as usize].above = upper;
        self.nodes[upper as usize].below = lower;
    }

    fn emit(&mut self, mut triangle: Triangle) {
        let least = if triangle[0] < triangle[1].min(triangle[2]) {
            0
        } else {
            1 + usize::from(triangle[2] < triangle[1])
        };
        triangle.rotate_left(least);
        self.triangles.push(triangle);
    }

    /// Whether a corner on the right sees the side of a chain between two corners, one above the other.
    fn sees(&self, corner: usize, lower: u32, upper: u32) -> bool {
        self.outline.turn_at([self.corner(lower), corner, self.corner(upper)]) > 0.0
    }

    /// Cuts off what a corner sees of a chain from a node on down; gives the node at which that ends.
    fn cut_down(&mut self, corner: usize, mut node: u32) -> u32 {
        while self.below(node) != NONE && self.sees(corner, self.below(node), node) {
            self.emit([self.corner(self.below(node)), corner, self.corner(node)]);
            node = self.below(node);
        }
        node
    }

    /// Cuts off what a corner sees of a chain from a node on up; gives the node at which that ends.
    fn cut_up(&mut self, corner: usize, mut node: u32) -> u32 {
        while self.above(node) != NONE && self.sees(corner, node, self.above(node)) {
            self.emit([self.corner(node), corner, self.corner(self.above(node))]);
            node = self.above(node);
        }
        node
    }

    /// The chain with a corner at its upper end, which first gets all triangles that it sees from there.
    pub(super) fn push_high(&mut self, chain: Chain, corner: usize) -> Chain {
        let below = self.cut_down(corner, chain.high);
        let node = self.node(corner);
        self.link(below, node);
        Chain { low: chain.low, high: node, rightmost: node }
    }

    /// The chain with a corner at its lower end, which first gets all triangles that it sees from there.
    pub(super) fn push_low(&mut self, chain: Chain, corner: usize) -> Chain {
        let above = self.cut_up(corner, chain.low);
        let node = self.node(corner);
        self.link(node, above);
        Chain { low: node, high: chain.high, rightmost: node }
    }

    /// Parts a chain at a corner within its strip, which is joined to the corner furthest to the right.
    pub(super) fn part(&mut self, chain: Chain, corner: usize) -> [Chain; 2] {
        let up = self.cut_up(corner, chain.rightmost);
        let down = self.cut_down(corner, chain.rightmost);
        // The node at which both stop is in both chains.
        let (up, high) = if up == down {
            let copy = self.node(self.corner(up));
            match self.above(up) {
                NONE => (copy, copy),
                above => {
                    self.link(copy, above);
                    (copy, chain.high)
                }
            }
        } else {
            (up, chain.high)
        };
        let (lower, upper) = (self.node(corner), self.node(corner));
        self.link(down, lower);
        self.link(upper, up);
        [
            Chain { low: chain.low, high: lower, rightmost: lower },
            Chain { low: upper, high, rightmost: upper },
        ]
    }

    /// One chain of two, the lower of which ends at the corner at which the upper one begins.
    pub(super) fn join(&mut self, lower: Chain, upper: Chain) -> Chain {
        match self.above(upper.low) {
            NONE => lower,
            above => {
                self.link(lower.high, above);
                Chain { low: lower.low, high: upper.high, rightmost: lower.high }
            }
        }
    }
}
