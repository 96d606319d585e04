//! Indices that a reader meets before it knows how many elements there are.

/// The highest index that was read, and the first place where. Faces may come before the vertices that they
/// name, so an index can be checked only when all is read; then the highest speaks for all.
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

    /// Sees what another one has seen at later places.
    pub(crate) fn see_all(&mut self, later: MaxIndex) {
        if let Some((index, at)) = later.found {
            self.see(index, at);
        }
    }

    /// The highest index and its place, if it is not below the count.
    pub(crate) fn beyond(self, count: usize) -> Option<(u32, usize)> {
        self.found.filter(|&(index, _)| index as usize >= count)
    }
}

/// A corner attribute that is named by index: which value each corner uses, none until one is named.
#[derive(Default)]
pub(crate) struct Uses {
    uses: Vec<u32>,
    max_index: MaxIndex,
}

impl Uses {
    /// Lets an element use a value; elements before it that were given none have none.
    #[inline]
    pub(crate) fn set(&mut self, element: usize, value: u32, at: usize) {
        self.uses.resize(element, meshmend_core::NO_VALUE);
        self.uses.push(value);
        self.max_index.see(value, at);
    }

    /// Lets the element after all that have a value use one.
    #[inline]
    pub(crate) fn push(&mut self, value: u32, at: usize) {
        self.uses.push(value);
        self.max_index.see(value, at);
    }

    /// Lets as many elements from this one on use what those of another list use, which come later in the file.
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

    /// How many elements there are up to the last one that was given a value.
    pub(crate) fn len(&self) -> usize {
        self.uses.len()
    }

    /// Forgets all uses, and keeps the memory for others.
    pub(crate) fn clear(&mut self) {
        self.return_to((0, MaxIndex::default()));
    }

    /// What to return to when what follows is to be forgotten.
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

    /// The uses of all elements; values that don't exist are counted, with the place of the highest, and taken
    /// away.
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
