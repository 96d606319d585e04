//! Which file is next: the largest first, within the memory that all may have together.

use std::cmp::Reverse;
use std::collections::VecDeque;

/// What is to be done, and what is being done.
pub(crate) struct Queue<T> {
    waiting: VecDeque<(u64, T)>,
    budget: u64,
    reserved: u64,
}

impl<T> Queue<T> {
    /// A queue of pieces of work with their costs, of which so much may be under way together.
    pub(crate) fn new(mut work: Vec<(u64, T)>, budget: u64) -> Self {
        work.sort_by_key(|(cost, _)| Reverse(*cost));
        Queue { waiting: work.into(), budget, reserved: 0 }
    }

    /// The next piece, with its cost, if there is room for it. What does not fit at all is done alone.
    pub(crate) fn take(&mut self) -> Option<(u64, T)> {
        let (cost, _) = self.waiting.front()?;
        let fits = self.reserved == 0 || self.reserved.saturating_add(*cost) <= self.budget;
        let next = if fits { self.waiting.pop_front() } else { None };
        self.reserved += next.as_ref().map_or(0, |(cost, _)| *cost);
        next
    }

    /// A piece of this cost is done.
    pub(crate) fn done(&mut self, cost: u64) {
        self.reserved -= cost;
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.waiting.is_empty()
    }

    /// Forgets what waits.
    pub(crate) fn clear(&mut self) {
        self.waiting.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_is_first_and_waits_until_there_is_room() {
        let mut queue = Queue::new(vec![(1, 'a'), (9, 'b'), (4, 'c'), (3, 'd')], 5);
        assert_eq!((queue.take(), queue.take()), (Some((9, 'b')), None));
        queue.done(9);
        assert_eq!((queue.take(), queue.take()), (Some((4, 'c')), None));
        queue.done(4);
        assert_eq!((queue.take(), queue.take(), queue.is_empty()), (Some((3, 'd')), Some((1, 'a')), true));
    }
}
