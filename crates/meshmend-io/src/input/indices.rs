//! Indices that a reader meets before it knows how many elements there are.

/// The highest index that was read, and the first place where it stands. Faces may come before the vertices that they
/// name, so indices can be checked only at the end of the file. It is enough to check the highest.
#[derive(Clone, Copy, Default)]
pub(crate) struct MaxIndex {
    found: Option<(u32, usize)>,
}

impl MaxIndex {
    #[inline]
    pub(crate) fn see(&mut self, index: u32, at: usize) {
        if self.found.is_none_or(|(highest, _)| index > highest) {
            self.found = Some((index, at));
        }
    }

    /// Takes in what was seen at later places.
    pub(crate) fn see_all(&mut self, later: MaxIndex) {
        if let Some((index, at)) = later.found {
            self.see(index, at);
        }
    }

    /// The highest index and its place, if the index is not below the count.
    pub(crate) fn beyond(self, count: usize) -> Option<(u32, usize)> {
        self.found.filter(|&(index, _)| index as usize >= count)
    }
}

/// Which value of an attribute each corner uses. A corner has none until a file names one.
#[derive(Default)]
pub(crate) struct Uses {
    uses: Vec<u32>,
    max_index: MaxIndex,
}

impl Uses {
    /// Lets an element use a value. Elements before it that were not set have none.
    #[inline]
    pub(crate) fn set(&mut self, element: usize, value: u32, at: usize) {
        self.uses.resize(element, meshmend_core::NO_VALUE);
        self.uses.push(value);
        self.max_index.see(value, at);
    }

    /// Lets the next element use a value.
    #[inline]
    pub(crate) fn push(&mut self, value: u32, at: usize) {
        self.uses.push(value);
        self.max_index.see(value, at);
    }

    /// Appends the uses of a later part of the file, whose first element is this one.
    pub(crate) fn append(&mut self, element: usize, later: &Uses) {
        if !later.is_empty() {
            self.uses.resize(element, meshmend_core::NO_VALUE);
            self.uses.extend_from_slice(&later.uses);
            self.max_index.see_all(later.max_index);
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.uses.is_empty()
    }

    /// How many elements there are up to the last one that has a value.
    pub(crate) fn len(&self) -> usize {
        self.uses.len()
    }

    /// Forgets all uses, but keeps their memory.
    pub(crate) fn clear(&mut self) {
        self.return_to((0, MaxIndex::default()));
    }

    /// A state to which [`return_to`](Uses::return_to) goes back.
    #[inline]
    pub(crate) fn mark(&self) -> (usize, MaxIndex) {
        (self.uses.len(), self.max_index)
    }

    /// Forgets what came after a mark.
    #[inline]
    pub(crate) fn return_to(&mut self, (length, max_index): (usize, MaxIndex)) {
        self.uses.truncate(length);
        self.max_index = max_index;
    }

    /// The uses of all elements. Uses of values that don't exist are removed; they are counted, with the place of the
    /// highest.
    pub(crate) fn checked(mut self, elements: usize, values: usize) -> (Vec<u32>, Option<(u64, usize)>) {
        self.uses.resize(elements, meshmend_core::NO_VALUE);
        let Some((_, at)) = self.max_index.beyond(values) else {
            return (self.uses, None);
        };
        let mut wrong = 0;
        for slot in &mut self.uses {
            if *slot != meshmend_core::NO_VALUE && *slot as usize >= values {
                *slot = meshmend_core::NO_VALUE;
                wrong += 1;
            }
        }
        (self.uses, Some((wrong, at)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_place_of_the_highest_index_counts() {
        let mut max = MaxIndex::default();
        assert_eq!((max.beyond(0), max.beyond(1)), (None, None));
        for (index, at) in [(0, 7), (4, 8), (4, 9), (3, 10)] {
            max.see(index, at);
        }
        assert_eq!((max.beyond(4), max.beyond(5)), (Some((4, 8)), None));
        let mut later = MaxIndex::default();
        later.see(4, 20);
        max.see_all(later);
        assert_eq!(max.beyond(0), Some((4, 8)));
        max.see(u32::MAX, 30);
        assert_eq!(max.beyond(u32::MAX as usize), Some((u32::MAX, 30)));
    }
}
