//! The edges and diagonals that are there, found by their ends.

use std::borrow::Cow;
use std::collections::BTreeSet;

use meshmend_core::{Id, VertexId};

/// Edges, each found among those of its smaller end.
pub struct Edges<'a> {
    /// The smaller end first; sorted.
    ends: Cow<'a, [[VertexId; 2]]>,
    /// For each vertex where the edges begin whose smaller end it is, and one more.
    starts: Vec<u32>,
}

impl<'a> Edges<'a> {
    /// Edges by their ends, the smaller end first; sorted.
    ///
    /// *Cost*: linear.
    pub fn new(ends: Cow<'a, [[VertexId; 2]]>, vertex_count: usize) -> Self {
        let mut starts = Vec::with_capacity(vertex_count + 1);
        for (at, edge) in ends.iter().enumerate() {
            while starts.len() <= edge[0].index() {
                starts.push(at as u32);
            }
        }
        starts.resize(vertex_count + 1, ends.len() as u32);
        Edges { ends, starts }
    }

    /// Whether an edge joins two vertices, the smaller first.
    ///
    /// *Cost*: O(log d) for d edges of the smaller end.
    #[inline]
    pub fn contains(&self, [smaller, larger]: [VertexId; 2]) -> bool {
        let of_smaller = self.starts[smaller.index()] as usize..self.starts[smaller.index() + 1] as usize;
        self.ends[of_smaller].binary_search_by_key(&larger, |edge| edge[1]).is_ok()
    }
}

/// Diagonals that were drawn. Most vertices are the smaller end of one at most, which is then found at once.
pub(crate) struct Diagonals {
    /// For each vertex the larger end of the first diagonal whose smaller end it is.
    first: Vec<Option<VertexId>>,
    /// All others.
    more: BTreeSet<[VertexId; 2]>,
}

impl Diagonals {
    pub(crate) fn none(vertex_count: usize) -> Self {
        Diagonals { first: vec![None; vertex_count], more: BTreeSet::new() }
    }

    /// Whether a diagonal joins two vertices, the smaller first.
    #[inline]
    pub(crate) fn contains(&self, ends: [VertexId; 2]) -> bool {
        match self.first[ends[0].index()] {
            None => false,
            Some(larger) => larger == ends[1] || self.more.contains(&ends),
        }
    }

    /// Adds one; tells whether it is new.
    pub(crate) fn insert(&mut self, ends: [VertexId; 2]) -> bool {
        match &mut self.first[ends[0].index()] {
            Some(larger) => *larger != ends[1] && self.more.insert(ends),
            first => {
                *first = Some(ends[1]);
                true
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_and_diagonals_are_found_by_their_ends() {
        let ends = |list: &[[u32; 2]]| list.iter().map(|ends| ends.map(VertexId)).collect::<Vec<_>>();
        let there = ends(&[[0, 1], [0, 3], [2, 2], [2, 3]]);
        let edges = Edges::new(Cow::Borrowed(&there), 5);
        let mut diagonals = Diagonals::none(5);
        assert!(there.iter().all(|&ends| diagonals.insert(ends)));
        assert!(!there.iter().any(|&ends| diagonals.insert(ends)));
        for asked in (0..5).flat_map(|low| (low..5).map(move |high| [VertexId(low), VertexId(high)])) {
            assert_eq!(edges.contains(asked), there.contains(&asked), "{asked:?}");
            assert_eq!(diagonals.contains(asked), there.contains(&asked), "{asked:?}");
        }
    }
}
