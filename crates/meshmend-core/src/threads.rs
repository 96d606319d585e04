//! Work on several threads, with the feature `rayon`; without it, on the caller's thread alone. Answers are the same.

use std::ops::Range;

#[cfg(feature = "rayon")]
use rayon::prelude::*;

/// How many threads there are to work on.
pub(crate) fn count() -> usize {
    #[cfg(feature = "rayon")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "rayon"))]
    return 1;
}

/// Does two things, at the same time if it can.
pub(crate) fn join<A: Send, B: Send>(
    one: impl FnOnce() -> A + Send,
    other: impl FnOnce() -> B + Send,
) -> (A, B) {
    #[cfg(feature = "rayon")]
    return rayon::join(one, other);
    #[cfg(not(feature = "rayon"))]
    return (one(), other());
}

/// What becomes of each item, in order.
pub(crate) fn map<S: Sync, R: Send>(items: &[S], each: impl Fn(&S) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "rayon")]
    return items.par_iter().map(each).collect();
    #[cfg(not(feature = "rayon"))]
    return items.iter().map(each).collect();
}

/// What becomes of each number, in order; at least `least` of them are done together, with one state.
pub(crate) fn map_with<T, R: Send>(
    range: Range<usize>,
    least: usize,
    state: impl Fn() -> T + Sync + Send,
    each: impl Fn(&mut T, usize) -> R + Sync + Send,
) -> Vec<R> {
    #[cfg(feature = "rayon")]
    return range.into_par_iter().with_min_len(least).map_init(state, each).collect();
    #[cfg(not(feature = "rayon"))]
    {
        let mut state = state();
        debug_assert!(least > 0);
        range.map(|number| each(&mut state, number)).collect()
    }
}

/// All that becomes of each number, in order.
pub(crate) fn flat_map<R: Send, I: Iterator<Item = R>>(
    range: Range<usize>,
    each: impl Fn(usize) -> I + Sync + Send,
) -> Vec<R> {
    #[cfg(feature = "rayon")]
    return range.into_par_iter().flat_map_iter(each).collect();
    #[cfg(not(feature = "rayon"))]
    return range.flat_map(each).collect();
}

/// Whether all numbers pass.
pub(crate) fn all(range: Range<usize>, passes: impl Fn(usize) -> bool + Sync + Send) -> bool {
    #[cfg(feature = "rayon")]
    return range.into_par_iter().all(passes);
    #[cfg(not(feature = "rayon"))]
    return range.into_iter().all(passes);
}

/// Visits chunks of so many slots, each with its place among the chunks.
pub(crate) fn for_each_chunk<T: Send>(
    slots: &mut [T],
    size: usize,
    visit: impl Fn((usize, &mut [T])) + Sync + Send,
) {
    #[cfg(feature = "rayon")]
    slots.par_chunks_mut(size).enumerate().for_each(visit);
    #[cfg(not(feature = "rayon"))]
    slots.chunks_mut(size).enumerate().for_each(visit);
}
