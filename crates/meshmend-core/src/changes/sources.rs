//! Where each element of one kind came from.

use crate::Id;

/// For each new element the old one that it is; `None` if it was created.
#[derive(Clone, Debug)]
pub struct Sources<I> {
    count: usize,
    /// Absent when each new element is the old one of the same index.
    listed: Option<Vec<u32>>,
    kind: std::marker::PhantomData<I>,
}

const CREATED: u32 = u32::MAX;

impl<I: Id> Sources<I> {
    /// Nothing changed: `count` elements, each its own source.
    pub fn same(count: usize) -> Self {
        Sources { count, listed: None, kind: std::marker::PhantomData }
    }

    /// A source for each new element.
    pub fn listed(sources: impl IntoIterator<Item = Option<I>>) -> Self {
        Self::of_words(sources.into_iter().map(|s| s.map_or(CREATED, |id| id.index() as u32)).collect())
    }

    fn of_words(listed: Vec<u32>) -> Self {
        let count = listed.len();
        let is_same = listed.iter().zip(0..).all(|(&old, new)| old == new);
        Sources { count, listed: (!is_same).then_some(listed), kind: std::marker::PhantomData }
    }

    /// How many new elements there are.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether there is no new element.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Whether each new element is the old one of the same index. There may have been more old ones.
    pub fn is_same(&self) -> bool {
        self.listed.is_none()
    }

    /// Whether the new elements are the `old_count` old ones, in order.
    pub fn is_all_of(&self, old_count: usize) -> bool {
        self.is_same() && self.count == old_count
    }

    /// The old element that a new one is.
    #[inline]
    pub fn of(&self, new: I) -> Option<I> {
        match &self.listed {
            None => Some(new),
            Some(listed) => match listed[new.index()] {
                CREATED => None,
                old => Some(I::new(old as usize)),
            },
        }
    }

    /// Each new element with its source, ascending.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (I, Option<I>)> + '_ {
        (0..self.count).map(|new| (I::new(new), self.of(I::new(new))))
    }

    /// For each of `old_count` old elements, whether some new element is it.
    pub fn survivors(&self, old_count: usize) -> Vec<bool> {
        let mut survives = vec![false; old_count];
        self.iter().filter_map(|(_, old)| old).for_each(|old| survives[old.index()] = true);
        survives
    }

    /// The sources of `later`'s elements as seen from before `self`.
    pub(super) fn then(&self, later: &Self) -> Self {
        if self.is_same() {
            later.clone()
        } else if later.is_all_of(self.count) {
            self.clone()
        } else {
            Sources::listed(later.iter().map(|(_, middle)| middle.and_then(|m| self.of(m))))
        }
    }
}

impl<I: Id> From<Vec<I>> for Sources<I> {
    /// A source for each new element, none of which was created.
    fn from(sources: Vec<I>) -> Self {
        Self::of_words(sources.into_iter().map(|id| id.index() as u32).collect())
    }
}

impl<I: Id> PartialEq for Sources<I> {
    fn eq(&self, other: &Self) -> bool {
        self.count == other.count && self.iter().eq(other.iter())
    }
}
