//! Which way to a root is the shortest, from every vertex?
//!
//! One run finds the trees of all components. Vertices are settled by distance, equal ones by id; of equally short
//! ways to a vertex the one that comes in by the lowest edge is taken. So only ids decide, and every kernel gives the
//! same forest.
//!
//! *Source*: E. W. Dijkstra, *A note on two problems in connexion with graphs*, 1959.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use meshmend_core::{Cancelled, Column, Connectivity, EdgeId, VertexId, Watch};

use super::STEP;
use super::ancestors::Ancestors;
use super::weights::Weights;

/// The shortest-path trees of some roots.
#[derive(Clone, Debug)]
pub(super) struct Forest {
    pub(super) ancestors: Ancestors,
    nodes: Column<VertexId, Node>,
    /// All vertices that a root reaches, each after its parent.
    pub(super) order: Vec<VertexId>,
}

/// What is known of the shortest way from a vertex, together, as all of it is asked for at once.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// How long it is; infinite where no root is reached.
    distance: f64,
    /// Its first edge; `NONE` for a root and where no root is reached.
    entry: EdgeId,
    /// Where that edge leads, as far as is known; `SETTLED` when there is no shorter way.
    next: VertexId,
}

const NONE: EdgeId = EdgeId(u32::MAX);
const SETTLED: VertexId = VertexId(u32::MAX);

impl Forest {
    /// Grows the trees of roots in different components.
    ///
    /// *Cost*: O(n log n); 32 bytes a vertex, and 16 more while it runs.
    ///
    /// # Errors
    /// If the watch stops it.
    pub(super) fn grow<K: Connectivity>(
        kernel: &K,
        weights: &Weights<'_>,
        roots: &[VertexId],
        watch: &Watch,
    ) -> Result<Self, Cancelled> {
        let count = kernel.vertex_count();
        let unknown = Node { distance: f64::INFINITY, entry: NONE, next: VertexId(0) };
        let mut forest = Forest {
            ancestors: Ancestors::new(count),
            nodes: Column::filled(unknown, count),
            order: Vec::new(),
        };
        let mut front = Front::default();
        for &root in roots {
            forest.nodes[root].distance = 0.0;
            front.push(0.0, root);
        }
        while let Some(vertex) = front.pop() {
            if forest.nodes[vertex].next == SETTLED {
                continue;
            }
            watch.look_at_times(STEP, forest.order.len(), count)?;
            forest.settle(vertex);
            for corner in kernel.vertex_corners(vertex) {
                let before = kernel.prev_corner(corner);
                let steps = [(corner, kernel.corner_target(corner)), (before, kernel.corner_vertex(before))];
                for (side, neighbour) in steps {
                    // Half of the neighbours are settled; their edges are not looked up.
                    if forest.nodes[neighbour].next != SETTLED {
                        forest.reach(&mut front, kernel.corner_edge(side), [vertex, neighbour], weights);
                    }
                }
            }
        }
        Ok(forest)
    }

    fn settle(&mut self, vertex: VertexId) {
        self.order.push(vertex);
        let node = &mut self.nodes[vertex];
        let next = std::mem::replace(&mut node.next, SETTLED);
        if node.entry == NONE {
            self.ancestors.add_root(vertex);
        } else {
            self.ancestors.add_child(vertex, next);
        }
    }

    /// Sees whether an edge is a shorter way to a vertex that is not settled, or one as short with a lower edge.
    #[inline]
    fn reach(&mut self, front: &mut Front, edge: EdgeId, [from, to]: [VertexId; 2], weights: &Weights<'_>) {
        let distance = self.nodes[from].distance + weights.of(edge);
        let node = &mut self.nodes[to];
        if distance < node.distance {
            front.push(distance, to);
        } else if distance > node.distance || edge >= node.entry {
            return;
        }
        *node = Node { distance, entry: edge, next: from };
    }

    /// The edge from a vertex towards its root; `None` for a root.
    #[inline]
    pub(super) fn entry(&self, vertex: VertexId) -> Option<EdgeId> {
        let edge = self.nodes[vertex].entry;
        (edge != NONE).then_some(edge)
    }

    /// How long the way from a vertex to its root is.
    #[inline]
    pub(super) fn distance(&self, vertex: VertexId) -> f64 {
        self.nodes[vertex].distance
    }

    /// Whether an edge with these ends is in a tree.
    #[inline]
    pub(super) fn has_edge(&self, edge: EdgeId, [low, high]: [VertexId; 2]) -> bool {
        self.nodes[low].entry == edge || self.nodes[high].entry == edge
    }

    /// The vertices from one up to an ancestor, that one left out.
    pub(super) fn path_up(&self, from: VertexId, ancestor: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        let step = |&vertex: &VertexId| Some(self.ancestors.parent(vertex));
        std::iter::successors(Some(from), step).take_while(move |&vertex| vertex != ancestor)
    }
}

/// The vertices that have been reached, some more than once.
#[derive(Default)]
struct Front {
    /// Distances from 0 on are in the order of their bits.
    heap: BinaryHeap<Reverse<(u64, VertexId)>>,
}

impl Front {
    fn push(&mut self, distance: f64, vertex: VertexId) {
        self.heap.push(Reverse((distance.to_bits(), vertex)));
    }

    /// The nearest vertex, of equally near ones the lowest.
    fn pop(&mut self) -> Option<VertexId> {
        self.heap.pop().map(|Reverse((_, vertex))| vertex)
    }
}
