//! Grouping by key: sides by their smaller vertex, corners by their vertex, edges by corner.
//!
//! ```text
//! records         (key, item) (key, item) ...      in any order, from one source or several
//! plain           each thread takes a range of keys, and passes over all records
//! scattered       each thread parts the records of a source by ranges of some thousand keys; then as above, by range
//! ```
//!
//! The plain way is the faster one while records beside one another have keys near one another, as in meshes that
//! were modelled. A table that is filled in random order waits for memory at each record as soon as it is larger than
//! the cache; then it pays to part the records first, which takes two more passes, but writes to a few places in
//! turn.

use std::ops::Range;

use crate::{FaceTable, threads};

/// Records of a key and an item each, always the same ones in the same order.
pub(crate) trait Records<T>: Sync {
    fn for_each(&self, visit: impl FnMut(u32, T));
}

/// What is made of records, by ascending ranges of keys.
pub(crate) trait Collect<T>: Default + Send {
    /// Makes room for so many records.
    fn reserve(&mut self, records: usize);

    /// Takes the records whose keys are in a range, which begins where the last one ended; others are passed over.
    fn add(&mut self, keys: Range<u32>, records: &impl Records<T>);
}

/// How records are collected; what comes out is the same.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strategy {
    pub(crate) threads: usize,
    pub(crate) is_scattered: bool,
}

/// Tables of fewer corners are built on one thread.
const LARGE: usize = 1 << 16;
/// Tables by fewer vertices fit the cache of one thread.
const MANY_VERTICES: usize = 3 << 18;
/// More threads than this would mostly look at records that are not theirs.
const MOST_THREADS: usize = 8;

impl Strategy {
    /// The way that is fast for a table of faces.
    pub(crate) fn for_table(faces: &FaceTable) -> Self {
        // Threads are not worth starting for a small mesh.
        let is_large = faces.corner_count() >= LARGE;
        let threads = if is_large { threads::count().min(MOST_THREADS) } else { 1 };
        // Each thread has a cache of its own, but also looks at all records, unless they are parted.
        let are_many = faces.vertex_count() * threads >= MANY_VERTICES;
        Strategy { threads, is_scattered: are_many && is_scattered(faces) }
    }

    /// As many ranges as there are threads; together they are `0..count`.
    pub(crate) fn shares(self, count: usize) -> Vec<Range<usize>> {
        let bound = |share: usize| (count as u64 * share as u64 / self.threads as u64) as usize;
        (0..self.threads).map(|share| bound(share)..bound(share + 1)).collect()
    }

    /// Collects the records of all sources, whose keys are below `key_count`: in as many collections as there are
    /// threads, each of a range of keys, ascending.
    pub(crate) fn collect<T, C>(self, key_count: usize, sources: &[impl Records<T>]) -> Vec<C>
    where
        T: Copy + Default + Send + Sync,
        C: Collect<T>,
    {
        if !self.is_scattered {
            return self.map(&self.shares(key_count), |keys| {
                let mut collection = C::default();
                collection.add(keys.start as u32..keys.end as u32, &All(sources));
                collection
            });
        }
        let parted = self.map(sources, |source| Parted::of(key_count, source));
        let bits = range_bits(key_count);
        self.map(&self.shares((key_count >> bits) + 1), |ranges| {
            let mut collection = C::default();
            collection.reserve(parted.iter().map(|parted| parted.len_of(ranges.clone())).sum());
            for range in ranges.clone() {
                let bound = |range: usize| (range << bits).min(key_count) as u32;
                collection.add(bound(range)..bound(range + 1), &OfRange { parted: &parted, range });
            }
            collection
        })
    }

    /// Puts the item of each record into the slot of its key.
    pub(crate) fn scatter<T: Copy + Default + Send + Sync>(
        self,
        slots: &mut [T],
        sources: &[impl Records<T>],
    ) {
        let bits = range_bits(slots.len());
        let parted = if self.is_scattered {
            self.map(sources, |source| Parted::of(slots.len(), source))
        } else {
            Vec::new()
        };
        // Whole ranges, as many for each thread.
        let share = slots.len().div_ceil(self.threads << bits).max(1) << bits;
        let fill = |(place, slots): (usize, &mut [T])| {
            let first = place * share;
            let ranges = first >> bits..(first + slots.len()).div_ceil(1 << bits);
            let mut put = |key: u32, item| {
                if let Some(slot) = slots.get_mut((key as usize).wrapping_sub(first)) {
                    *slot = item;
                }
            };
            if !self.is_scattered {
                return All(sources).for_each(put);
            }
            for range in ranges {
                OfRange { parted: &parted, range }.for_each(&mut put);
            }
        };
        match self.threads {
            1 => slots.chunks_mut(share).enumerate().for_each(fill),
            _ => threads::for_each_chunk(slots, share, fill),
        }
    }

    /// Does two things, at the same time where there are threads.
    pub(crate) fn both<A: Send, B: Send>(
        self,
        one: impl FnOnce() -> A + Send,
        other: impl FnOnce() -> B + Send,
    ) -> (A, B) {
        if self.threads == 1 { (one(), other()) } else { threads::join(one, other) }
    }

    fn map<S: Sync, R: Send>(self, items: &[S], each: impl Fn(&S) -> R + Sync + Send) -> Vec<R> {
        match self.threads {
            1 => items.iter().map(each).collect(),
            _ => threads::map(items, each),
        }
    }
}

/// Items in groups, one for each key from the first one on.
#[derive(Clone, Debug)]
pub(crate) struct Groups<T> {
    /// Where each group begins, and the end of the last.
    pub(crate) starts: Vec<u32>,
    pub(crate) items: Vec<T>,
}

impl<T> Default for Groups<T> {
    fn default() -> Self {
        Groups { starts: vec![0], items: Vec::new() }
    }
}

impl<T: Clone + Default> Groups<T> {
    /// Groups the records of the keys that follow, each in the form that `item` gives it. Within a group they keep
    /// their order.
    #[inline]
    pub(crate) fn add_as<R>(&mut self, keys: Range<u32>, records: &impl Records<R>, item: impl Fn(R) -> T) {
        let (first, mut total) = (self.starts.len(), self.items.len() as u32);
        self.starts.resize(first + keys.len(), 0);
        let places = &mut self.starts[first..];
        // Lower keys come out far beyond the end.
        let group = |key: u32| key.wrapping_sub(keys.start) as usize;
        records.for_each(|key, _| {
            if let Some(count) = places.get_mut(group(key)) {
                *count += 1;
            }
        });
        for place in &mut *places {
            total += std::mem::replace(place, total);
        }
        self.items.resize(total as usize, T::default());
        let items = &mut self.items;
        // Each place moves on to where its group ends and the next begins.
        records.for_each(|key, record| {
            if let Some(place) = places.get_mut(group(key)) {
                items[*place as usize] = item(record);
                *place += 1;
            }
        });
    }

    /// One after the other.
    pub(crate) fn joined(parts: Vec<Self>) -> Self {
        let mut parts = parts.into_iter();
        let mut whole = parts.next().unwrap_or_default();
        for part in parts {
            let before = whole.items.len() as u32;
            whole.starts.extend(part.starts[1..].iter().map(|start| before + start));
            whole.items.extend(part.items);
        }
        whole
    }

    pub(crate) fn clear(&mut self) {
        self.starts.truncate(1);
        self.items.clear();
    }
}

impl<T: Copy + Default + Send + Sync> Collect<T> for Groups<T> {
    fn reserve(&mut self, records: usize) {
        self.items.reserve_exact(records);
    }

    fn add(&mut self, keys: Range<u32>, records: &impl Records<T>) {
        self.add_as(keys, records, |item| item);
    }
}

/// The records of several sources, one after the other.
struct All<'a, R>(&'a [R]);

impl<T, R: Records<T>> Records<T> for All<'_, R> {
    #[inline]
    fn for_each(&self, mut visit: impl FnMut(u32, T)) {
        self.0.iter().for_each(|source| source.for_each(&mut visit));
    }
}

/// Records grouped by ranges of their keys; within a group in the order in which they came.
struct Parted<T> {
    starts: Vec<u32>,
    records: Vec<(u32, T)>,
}

/// A range has so many keys at least: what is done for it fits a cache of some hundred kilobytes.
const LEAST_BITS: u32 = 12;
/// More ranges than this would wait for memory by themselves.
const MOST_RANGES: usize = 1 << 11;

/// How many bits of a key tell places within a range apart.
fn range_bits(key_count: usize) -> u32 {
    (LEAST_BITS..32).find(|bits| key_count >> bits < MOST_RANGES).unwrap_or(32)
}

impl<T: Copy + Default> Parted<T> {
    fn of(key_count: usize, source: &impl Records<T>) -> Self {
        let bits = range_bits(key_count);
        let mut groups = Groups::default();
        groups.add_as(0..(key_count >> bits) as u32 + 1, &ByRange { source, bits }, |record| record);
        Parted { starts: groups.starts, records: groups.items }
    }

    fn len_of(&self, ranges: Range<usize>) -> usize {
        (self.starts[ranges.end] - self.starts[ranges.start]) as usize
    }
}

/// Records with the ranges of their keys for keys.
struct ByRange<'a, S> {
    source: &'a S,
    bits: u32,
}

impl<T, S: Records<T>> Records<(u32, T)> for ByRange<'_, S> {
    #[inline]
    fn for_each(&self, mut visit: impl FnMut(u32, (u32, T))) {
        self.source.for_each(|key, item| visit(key >> self.bits, (key, item)));
    }
}

/// The records of one range, from all sources.
struct OfRange<'a, T> {
    parted: &'a [Parted<T>],
    range: usize,
}

impl<T: Copy + Default + Send + Sync> Records<T> for OfRange<'_, T> {
    #[inline]
    fn for_each(&self, mut visit: impl FnMut(u32, T)) {
        for Parted { starts, records } in self.parted {
            let bounds = starts[self.range] as usize..starts[self.range + 1] as usize;
            records[bounds].iter().for_each(|&(key, item)| visit(key, item));
        }
    }
}

/// Whether faces name vertices in such an order that a table by vertices is looked into at random. A sample decides.
fn is_scattered(faces: &FaceTable) -> bool {
    const NEAR: u32 = 1 << 12;
    const SAMPLES: usize = 1 << 10;
    let vertices = faces.corner_vertices();
    let step = (vertices.len() / SAMPLES).max(4);
    let pairs = vertices.chunks_exact(step).map(|corners| [corners[0], corners[3]]);
    let (far, near): (Vec<_>, Vec<_>) = pairs.partition(|[one, other]| one.0.abs_diff(other.0) > NEAR);
    far.len() > near.len()
}

/// What was collected in parts, one after the other; a single one as it is.
pub(crate) fn joined<T: Clone>(mut parts: Vec<Vec<T>>, count: usize) -> Vec<T> {
    if parts.len() == 1 {
        let mut whole = parts.swap_remove(0);
        whole.shrink_to_fit();
        return whole;
    }
    let mut whole = Vec::with_capacity(count);
    parts.into_iter().for_each(|part| whole.extend_from_slice(&part));
    whole
}
