//! Where do two paths to the root meet?
//!
//! Each vertex of a rooted forest has one pointer that jumps over some of its ancestors, so that the lowest common
//! ancestor of two vertices is found in logarithmic time, and every vertex costs three words.
//!
//! *Source*: E. W. Myers, *An applicative random-access stack*, 1983.

use meshmend_core::{Column, VertexId};

/// The ancestors of each vertex of a forest that grows from its roots.
#[derive(Clone, Debug)]
pub(super) struct Ancestors {
    nodes: Column<VertexId, Node>,
}

/// Where a vertex stands in its tree.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// A root is its own parent.
    parent: VertexId,
    jump: VertexId,
    depth: u32,
}

impl Ancestors {
    pub(super) fn new(vertex_count: usize) -> Self {
        let nothing = Node { parent: VertexId(0), jump: VertexId(0), depth: 0 };
        Ancestors { nodes: Column::filled(nothing, vertex_count) }
    }

    pub(super) fn vertex_count(&self) -> usize {
        self.nodes.len()
    }

    pub(super) fn add_root(&mut self, root: VertexId) {
        self.nodes[root] = Node { parent: root, jump: root, depth: 0 };
    }

    /// Hangs a new vertex below one that is there.
    pub(super) fn add_child(&mut self, child: VertexId, parent: VertexId) {
        let Node { jump, depth, .. } = self.nodes[parent];
        let middle = self.nodes[jump];
        let is_equal = depth - middle.depth == middle.depth - self.depth(middle.jump);
        let jump = if is_equal { middle.jump } else { parent };
        self.nodes[child] = Node { parent, jump, depth: depth + 1 };
    }

    /// The next vertex towards the root; a root is its own.
    pub(super) fn parent(&self, vertex: VertexId) -> VertexId {
        self.nodes[vertex].parent
    }

    /// How many steps the root is away.
    pub(super) fn depth(&self, vertex: VertexId) -> u32 {
        self.nodes[vertex].depth
    }

    /// The deepest vertex on both ways to the root, for two vertices of one tree.
    pub(super) fn lowest_common(&self, one: VertexId, other: VertexId) -> VertexId {
        let depth = self.depth(one).min(self.depth(other));
        let (mut one, mut other) = (self.at_depth(one, depth), self.at_depth(other, depth));
        while one != other {
            let ways = [self.nodes[one], self.nodes[other]];
            [one, other] = if ways[0].jump == ways[1].jump {
                ways.map(|way| way.parent)
            } else {
                ways.map(|way| way.jump)
            };
        }
        one
    }

    /// The ancestor at a depth not beyond the vertex's own.
    fn at_depth(&self, mut vertex: VertexId, depth: u32) -> VertexId {
        while self.depth(vertex) > depth {
            let Node { parent, jump, .. } = self.nodes[vertex];
            vertex = if self.depth(jump) >= depth { jump } else { parent };
        }
        vertex
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Random;

    #[test]
    fn ancestors_are_those_of_whole_paths() {
        let mut random = Random(17);
        for bushiness in [1, 2, 9, 60] {
            let mut tree = Ancestors::new(60);
            tree.add_root(VertexId(0));
            let mut paths = vec![vec![0]];
            for child in 1..60 {
                let parent = child - 1 - random.below(child.min(bushiness));
                tree.add_child(VertexId(child as u32), VertexId(parent as u32));
                let path = [paths[parent].clone(), vec![child]].concat();
                paths.push(path);
            }
            for one in 0..60 {
                for other in 0..60 {
                    let common = paths[one].iter().zip(&paths[other]).take_while(|(a, b)| a == b).last();
                    let found = tree.lowest_common(VertexId(one as u32), VertexId(other as u32));
                    assert_eq!(Some(found.0 as usize), common.map(|(a, _)| *a));
                    assert_eq!(tree.depth(VertexId(one as u32)) as usize, paths[one].len() - 1);
                }
            }
        }
    }
}
