//! One list for each element of a kind, all lists in one piece.
//!
//! ```text
//! starts   0     2        5  5      element 0: items 0, 1 · element 1: items 2, 3, 4 · element 2: none
//! items    a b   c d e
//! ```

use std::marker::PhantomData;

use meshmend_core::Id;

/// A list of `T` for each `I`: `Lists<VertexId, CornerId>` are the corners of each vertex.
#[derive(Clone, Debug)]
pub(crate) struct Lists<I, T> {
    starts: Vec<u32>,
    items: Vec<T>,
    kind: PhantomData<I>,
}

impl<I: Id, T: Copy + Default> Lists<I, T> {
    /// Hands each item to its owner; the items of one owner keep their order.
    ///
    /// *Cost*: two passes over fewer than 2³² pairs.
    pub(crate) fn group(owners: usize, pairs: impl Iterator<Item = (I, T)> + Clone) -> Self {
        let mut starts = vec![0u32; owners + 1];
        pairs.clone().for_each(|(owner, _)| starts[owner.index() + 1] += 1);
        for owner in 0..owners {
            starts[owner + 1] += starts[owner];
        }
        let mut free = starts.clone();
        let mut items = vec![T::default(); starts[owners] as usize];
        for (owner, item) in pairs {
            items[free[owner.index()] as usize] = item;
            free[owner.index()] += 1;
        }
        Lists { starts, items, kind: PhantomData }
    }

    /// How many owners there are.
    pub(crate) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// The items of one owner.
    #[inline]
    pub(crate) fn of(&self, owner: I) -> &[T] {
        let at = owner.index();
        &self.items[self.starts[at] as usize..self.starts[at + 1] as usize]
    }

    /// Bytes on the heap.
    pub(crate) fn heap_bytes(&self) -> usize {
        self.starts.capacity() * size_of::<u32>() + self.items.capacity() * size_of::<T>()
    }
}

#[cfg(test)]
mod tests {
    use meshmend_core::{CornerId, VertexId};

    use super::*;

    #[test]
    fn items_keep_their_order_and_an_owner_may_have_none() {
        let pairs = [(2, 7), (0, 1), (2, 3)].map(|(v, c)| (VertexId(v), CornerId(c)));
        let lists = Lists::group(4, pairs.into_iter());
        let lengths: Vec<_> = (0..lists.len()).map(|v| lists.of(VertexId::new(v)).len()).collect();
        assert_eq!(lengths, [1, 0, 2, 0]);
        assert_eq!(lists.of(VertexId(2)), [CornerId(7), CornerId(3)]);
    }
}
