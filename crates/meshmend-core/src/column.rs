//! A vector that is indexed by one kind of id only.

use std::marker::PhantomData;
use std::ops::{Index, IndexMut};

use crate::Id;

/// One value for each element of a kind: `Column<FaceId, bool>` is a flag a face.
///
/// *Cost*: a `Vec` and nothing else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column<I, T> {
    values: Vec<T>,
    kind: PhantomData<I>,
}

impl<I: Id, T> Column<I, T> {
    /// A column with the same value for each of `count` elements.
    pub fn filled(value: T, count: usize) -> Self
    where
        T: Clone,
    {
        Column::from(vec![value; count])
    }

    /// The values of an iterator that knows how many it gives, without room for more.
    pub fn exactly(values: impl ExactSizeIterator<Item = T>) -> Self {
        let mut exact = Vec::with_capacity(values.len());
        exact.extend(values);
        Column::from(exact)
    }

    /// How many elements have a value.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there is no element at all.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// Each element with its value, by ascending id.
    pub fn iter(&self) -> impl Iterator<Item = (I, &T)> + Clone {
        self.values.iter().enumerate().map(|(index, value)| (I::new(index), value))
    }

    /// The values alone, by ascending id.
    pub fn values(&self) -> &[T] {
        &self.values
    }

    /// The values alone, to be changed in place.
    pub fn values_mut(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// Adds the value of the next element and gives that element's id.
    pub fn push(&mut self, value: T) -> I {
        self.values.push(value);
        I::new(self.values.len() - 1)
    }

    /// The values as a plain vector.
    pub fn into_vec(self) -> Vec<T> {
        self.values
    }

    /// How many elements there is room for.
    pub fn capacity(&self) -> usize {
        self.values.capacity()
    }

    /// Bytes on the heap, for values that own nothing themselves.
    pub fn heap_bytes(&self) -> usize {
        self.values.capacity() * size_of::<T>()
    }
}

impl<I, T> Default for Column<I, T> {
    fn default() -> Self {
        Column { values: Vec::new(), kind: PhantomData }
    }
}

impl<I: Id, T> From<Vec<T>> for Column<I, T> {
    fn from(values: Vec<T>) -> Self {
        Column { values, kind: PhantomData }
    }
}

impl<I: Id, T> FromIterator<T> for Column<I, T> {
    fn from_iter<It: IntoIterator<Item = T>>(values: It) -> Self {
        Column::from(values.into_iter().collect::<Vec<T>>())
    }
}

impl<I: Id, T> Index<I> for Column<I, T> {
    type Output = T;
    #[inline]
    fn index(&self, id: I) -> &T {
        &self.values[id.index()]
    }
}

impl<I: Id, T> IndexMut<I> for Column<I, T> {
    #[inline]
    fn index_mut(&mut self, id: I) -> &mut T {
        &mut self.values[id.index()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceId;

    #[test]
    fn a_column_has_a_value_for_each_element() {
        let mut column: Column<FaceId, u8> = Column::default();
        assert!(column.is_empty());
        assert_eq!((column.push(7), column.push(8)), (FaceId(0), FaceId(1)));
        column[FaceId(0)] += 1;
        column.values_mut()[1] += 2;
        assert_eq!(column.iter().collect::<Vec<_>>(), [(FaceId(0), &8), (FaceId(1), &10)]);
        assert_eq!((column.len(), column.is_empty()), (2, false));
        assert_eq!(column.into_vec(), [8, 10]);
    }
}
