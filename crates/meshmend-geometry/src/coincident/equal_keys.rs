//! Which things have equal keys: a hash table in parts that each stay in the processor's cache.
//!
//! ```text
//! things      │ chunk 0        │ chunk 1        │ …      each chunk sorts its keys into parts by their hash
//! entries     │ p0 p1 p2 … p63 │ p0 p1 p2 … p63 │ …
//!               ╲─────────────────╲                      each part goes through its runs of all chunks in order,
//! table of part 0: key → lowest thing                    so the first thing with a key is the lowest
//! ```
//!
//! The answer does not depend on how many chunks, parts or threads there are. A part whose keys were made to collide is
//! sorted instead, so that no file can make this slow.

use std::convert::Infallible;

use meshmend_core::{Id, VertexId};
use rayon::prelude::*;

/// What goes on is never asked to stop.
#[allow(clippy::unnecessary_wraps, reason = "what can be stopped answers with it")]
pub(super) fn always() -> Result<(), Infallible> {
    Ok(())
}

/// Things of a chunk: their keys fit the second-level cache.
pub(super) const CHUNK: usize = 1 << 15;
/// Things of a part, on average.
const PART: usize = 1 << 13;
const NOTHING: u32 = u32::MAX;

/// What things are compared by.
pub(super) trait Key: Copy + Ord + Send + Sync {
    /// Stands in empty slots, where it is not looked at.
    const NONE: Self;
    /// Spread over all bits.
    fn hash(self) -> u64;
}

impl Key for [u32; 3] {
    const NONE: Self = [0; 3];

    #[inline]
    fn hash(self) -> u64 {
        let [x, y, z] = self.map(u64::from);
        folded(x << 32 | y, z)
    }
}

impl Key for [u64; 3] {
    const NONE: Self = [0; 3];

    #[inline]
    fn hash(self) -> u64 {
        folded(folded(self[0], self[1]), self[2])
    }
}

/// Both halves of a product, mixed. The constants are odd and have about as many ones as zeros.
#[inline]
fn folded(one: u64, other: u64) -> u64 {
    let product =
        u128::from(one ^ 0x9e37_79b9_7f4a_7c15) * u128::from(other.rotate_left(32) ^ 0xd6e8_feb8_6659_fd93);
    product as u64 ^ (product >> 64) as u64
}

/// A thing and its key; later the lowest thing with that key.
#[derive(Clone, Copy)]
struct Entry<K> {
    key: K,
    thing: u32,
    lowest: u32,
}

/// The comparable things of a chunk, sorted into parts.
struct Chunk<K> {
    entries: Vec<Entry<K>>,
    /// Where each part begins, and one more.
    starts: Vec<usize>,
}

/// For each thing the lowest one with the same key; a thing without a key is alone. From time to time it is asked whether to go on.
pub(super) fn lowest_of_equal<T: Sync, K: Key, E: Send>(
    things: &[T],
    key: impl Fn(&T) -> Option<K> + Sync,
    goes_on: &(impl Fn() -> Result<(), E> + Sync),
) -> Result<Vec<VertexId>, E> {
    let part_bits = (things.len() / PART).max(1).ilog2();
    let part_of = |key: K| (u128::from(key.hash()) << part_bits >> 64) as usize;
    let mut chunks: Vec<Chunk<K>> = things
        .par_chunks(CHUNK)
        .enumerate()
        .map(|(chunk, things)| {
            goes_on()?;
            Ok(Chunk::of(things, chunk * CHUNK, 1 << part_bits, &key, part_of))
        })
        .collect::<Result<_, E>>()?;
    goes_on()?;
    let parts = by_part(&mut chunks, 1 << part_bits);
    parts.into_par_iter().for_each_init(Table::new, |table, mut runs| table.find_lowest(&mut runs));
    goes_on()?;
    let mut lowest: Vec<VertexId> = (0..things.len()).map(VertexId::new).collect();
    lowest.par_chunks_mut(CHUNK).zip(&chunks).enumerate().for_each(|(at, (lowest, chunk))| {
        let first = at * CHUNK;
        chunk.entries.iter().for_each(|e| lowest[e.thing as usize - first] = VertexId(e.lowest));
    });
    Ok(lowest)
}

impl<K: Key> Chunk<K> {
    fn of<T>(
        things: &[T],
        first: usize,
        parts: usize,
        key: impl Fn(&T) -> Option<K>,
        part_of: impl Fn(K) -> usize,
    ) -> Self {
        let keys = || things.iter().enumerate().filter_map(|(place, thing)| Some((place, key(thing)?)));
        let mut starts = vec![0; parts + 1];
        keys().for_each(|(_, key)| starts[part_of(key) + 1] += 1);
        for part in 0..parts {
            starts[part + 1] += starts[part];
        }
        let mut next = starts.clone();
        let mut entries = vec![Entry { key: K::NONE, thing: 0, lowest: 0 }; starts[parts]];
        for (place, key) in keys() {
            let slot = &mut next[part_of(key)];
            let thing = (first + place) as u32;
            entries[*slot] = Entry { key, thing, lowest: thing };
            *slot += 1;
        }
        Chunk { entries, starts }
    }
}

/// For each part its runs in all chunks, in order.
fn by_part<K>(chunks: &mut [Chunk<K>], parts: usize) -> Vec<Vec<&mut [Entry<K>]>> {
    let mut runs: Vec<Vec<&mut [Entry<K>]>> = (0..parts).map(|_| Vec::with_capacity(chunks.len())).collect();
    for chunk in chunks {
        let mut rest = &mut chunk.entries[..];
        for (part, bounds) in chunk.starts.windows(2).enumerate() {
            let (run, others) = rest.split_at_mut(bounds[1] - bounds[0]);
            runs[part].push(run);
            rest = others;
        }
    }
    runs
}

/// An open table of keys, each with the lowest thing that has it; kept from part to part.
struct Table<K> {
    slots: Vec<(K, u32)>,
}

impl<K: Key> Table<K> {
    fn new() -> Self {
        Table { slots: Vec::new() }
    }

    /// Finds for each entry of a part the lowest thing with its key.
    fn find_lowest(&mut self, runs: &mut [&mut [Entry<K>]]) {
        let count: usize = runs.iter().map(|run| run.len()).sum();
        let size = (2 * count).next_power_of_two();
        self.slots.clear();
        self.slots.resize(size, (K::NONE, NOTHING));
        // Far more than honest keys ever need.
        let mut steps_left = 16 * count + 64;
        for entry in runs.iter_mut().flat_map(|run| run.iter_mut()) {
            let mut slot = entry.key.hash() as usize & (size - 1);
            loop {
                let (key, lowest) = self.slots[slot];
                if lowest == NOTHING {
                    self.slots[slot] = (entry.key, entry.thing);
                    break;
                }
                if key == entry.key {
                    entry.lowest = lowest;
                    break;
                }
                if steps_left == 0 {
                    return sort_instead(runs, count);
                }
                steps_left -= 1;
                slot = (slot + 1) & (size - 1);
            }
        }
    }
}

/// The same by sorting, whatever the keys are.
fn sort_instead<K: Key>(runs: &mut [&mut [Entry<K>]], count: usize) {
    let mut all: Vec<&mut Entry<K>> = Vec::with_capacity(count);
    all.extend(runs.iter_mut().flat_map(|run| run.iter_mut()));
    all.sort_unstable_by_key(|entry| (entry.key, entry.thing));
    for equal in all.chunk_by_mut(|one, other| one.key == other.key) {
        let lowest = equal[0].thing;
        equal.iter_mut().for_each(|entry| entry.lowest = lowest);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Keys of one hash: the table gives up, and sorting gives the same.
    #[test]
    fn keys_that_collide_are_sorted() {
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        struct Colliding(u32);
        impl Key for Colliding {
            const NONE: Self = Colliding(0);
            fn hash(self) -> u64 {
                7
            }
        }
        let things: Vec<u32> = (0..5000).map(|i| i % 1250).collect();
        let Ok(found) = lowest_of_equal(&things, |&thing| Some(Colliding(thing)), &always);
        assert!(found.iter().zip(0..).all(|(lowest, thing)| lowest.0 == thing % 1250));
    }
}
