//! One list for each element of a kind, all lists in one piece.
//!
//! Grouping is what every kernel does when it is built, so kernels of other crates find it here.
//!
//! ```text
//! starts   0     2        5  5      element 0: items 0, 1 · element 1: items 2, 3, 4 · element 2: none
//! items    a b   c d e
//! ```

use std::marker::PhantomData;

use crate::{Array, Id, Per};

/// A list of `T` for each `I`: `Lists<VertexId, CornerId>` are the corners of each vertex.
#[derive(Clone, Debug)]
pub struct Lists<I, T> {
    starts: Vec<u32>,
    items: Vec<T>,
    kind: PhantomData<I>,
}

impl<I: Id, T: Copy + Default> Lists<I, T> {
    /// Hands each item to its owner; the items of one owner keep their order.
    ///
    /// ```
    /// use meshmend_core::{CornerId, Lists, VertexId};
    ///
    /// let pairs = [(2, 7), (0, 1), (2, 3)].map(|(v, c)| (VertexId(v), CornerId(c)));
    /// let corners_at = Lists::group(4, pairs.into_iter());
    /// assert_eq!(corners_at.of(VertexId(2)), [CornerId(7), CornerId(3)]);
    /// assert_eq!(corners_at.of(VertexId(3)), []);
    /// ```
    ///
    /// *Panics* if an owner is not below `owners`.
    ///
    /// *Cost*: two passes over fewer than 2³² pairs.
    pub fn group(owners: usize, pairs: impl Iterator<Item = (I, T)> + Clone) -> Self {
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
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there is not one owner.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The items of one owner.
    #[inline]
    pub fn of(&self, owner: I) -> &[T] {
        let at = owner.index();
        &self.items[self.starts[at] as usize..self.starts[at + 1] as usize]
    }

    /// Bytes on the heap.
    pub fn heap_bytes(&self) -> usize {
        self.starts.capacity() * size_of::<u32>() + self.items.capacity() * size_of::<T>()
    }

    /// Both arrays as a kernel names them, each with what it has a place for.
    pub fn arrays(&self, starts: (&'static str, Per), items: (&'static str, Per)) -> [Array; 2] {
        [
            Array::new(starts.0, starts.1, size_of::<u32>(), self.starts.capacity()),
            Array::new(items.0, items.1, size_of::<T>(), self.items.capacity()),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CornerId, VertexId};

    #[test]
    fn items_keep_their_order_and_an_owner_may_have_none() {
        let pairs = [(2, 7), (0, 1), (2, 3)].map(|(v, c)| (VertexId(v), CornerId(c)));
        let lists = Lists::group(4, pairs.into_iter());
        let lengths: Vec<_> = (0..lists.len()).map(|v| lists.of(VertexId::new(v)).len()).collect();
        assert_eq!(lengths, [1, 0, 2, 0]);
        assert_eq!(lists.of(VertexId(2)), [CornerId(7), CornerId(3)]);
    }
}
