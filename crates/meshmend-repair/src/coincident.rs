//! Which vertices are in the same place, exactly: a hash table in parts that each stay in the processor's cache.
//!
//! ```text
//! positions   │ chunk 0        │ chunk 1        │ …      each chunk sorts its keys into parts by their hash
//! entries     │ p0 p1 p2 … p63 │ p0 p1 p2 … p63 │ …
//!               ╲─────────────────╲                      each part goes through its runs of all chunks in order,
//! table of part 0: key → lowest vertex                   so the first vertex with a key is the lowest
//! ```
//!
//! The answer does not depend on how many chunks, parts or threads there are. A part whose keys were made to collide is
//! sorted instead, so that no file can make this slow.

use meshmend_core::{Id, PolygonMesh, VertexId};
use meshmend_geometry::places::place_bits;
use rayon::prelude::*;

/// Vertices of a chunk: their keys fit the second-level cache.
const CHUNK: usize = 1 << 15;
/// Vertices of a part, on average.
const PART: usize = 1 << 13;
const NO_VERTEX: u32 = u32::MAX;

/// For each vertex the lowest one at the same position: −0 equals 0, and what is not finite equals nothing.
///
/// *Cost*: linear; 20 bytes a vertex, and 36 for each that equals another one in single precision alone.
pub fn coincident_vertices(mesh: &PolygonMesh) -> Vec<VertexId> {
    coincident_points(mesh.positions())
}

/// The same for any points.
pub(crate) fn coincident_points(positions: &[[f64; 3]]) -> Vec<VertexId> {
    Coincidence::of(positions).exactly
}

/// For each vertex the lowest one at the same position when all coordinates are rounded to single precision; what is not
/// finite then equals nothing.
///
/// *Cost*: linear; 20 bytes a vertex.
pub fn coincident_in_single(mesh: &PolygonMesh) -> Vec<VertexId> {
    equal_in_single(mesh.positions())
}

/// Which vertices are in the same place, and how many more would be if coordinates were stored in single precision.
#[derive(Clone, Debug)]
pub struct Coincidence {
    /// For each vertex the lowest one at the same position.
    pub exactly: Vec<VertexId>,
    /// How many vertices equal a lower one in single precision alone.
    pub only_in_single: usize,
}

impl Coincidence {
    /// Looks at some points.
    ///
    /// *Cost*: that of [`coincident_vertices`].
    pub fn of(positions: &[[f64; 3]]) -> Self {
        let are_single =
            |positions: &[[f64; 3]]| positions.iter().flatten().all(|&x| f64::from(x as f32) == x);
        let lowest = equal_in_single(positions);
        // A coordinate that is no number equals none, itself included.
        if positions.par_chunks(CHUNK).all(are_single) {
            return Coincidence { exactly: lowest, only_in_single: 0 };
        }
        let doubtful = doubtful(positions, &lowest);
        let mut exactly = lowest;
        let joined = |lowest: &[VertexId]| doubtful.iter().filter(|&&v| lowest[v.index()] != v).count();
        let joined_in_single = joined(&exactly);
        let points: Vec<[f64; 3]> = doubtful.iter().map(|v| positions[v.index()]).collect();
        let equal = lowest_of_equal(&points, f64::is_finite, place_bits);
        for (&vertex, low) in doubtful.iter().zip(equal) {
            exactly[vertex.index()] = doubtful[low.index()];
        }
        // Numbers that single precision does not reach may be equal as they are, and are not in single precision.
        let only_in_single = joined_in_single.saturating_sub(joined_within(&exactly, &doubtful, positions));
        Coincidence { exactly, only_in_single }
    }
}

fn equal_in_single(positions: &[[f64; 3]]) -> Vec<VertexId> {
    lowest_of_equal(positions, |x| (x as f32).is_finite(), |p| p.map(|x| (x as f32 + 0.0).to_bits()))
}

/// The vertices of which single precision does not tell what they equal: all of a class that are not all at one position,
/// and those beyond its reach.
fn doubtful(positions: &[[f64; 3]], lowest: &[VertexId]) -> Vec<VertexId> {
    let vertices = || (0..positions.len()).map(VertexId::new);
    let mut is_mixed = vec![false; positions.len()];
    for vertex in vertices() {
        let low = lowest[vertex.index()];
        if low != vertex && positions[low.index()] != positions[vertex.index()] {
            is_mixed[low.index()] = true;
        }
    }
    let is_doubtful = |vertex: &VertexId| {
        let point = positions[vertex.index()];
        is_mixed[lowest[vertex.index()].index()] || !is_in_reach(point) && point.iter().all(|x| x.is_finite())
    };
    vertices().filter(is_doubtful).collect()
}

/// How many of some vertices within the reach of single precision are joined to a lower one.
fn joined_within(lowest: &[VertexId], vertices: &[VertexId], positions: &[[f64; 3]]) -> usize {
    let is_joined = |v: &&VertexId| lowest[v.index()] != **v && is_in_reach(positions[v.index()]);
    vertices.iter().filter(is_joined).count()
}

fn is_in_reach(point: [f64; 3]) -> bool {
    point.iter().all(|&x| (x as f32).is_finite())
}

/// What positions are compared by.
trait Key: Copy + Ord + Send + Sync {
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

/// A vertex and its key; later the lowest vertex with that key.
#[derive(Clone, Copy)]
struct Entry<K> {
    key: K,
    vertex: u32,
    lowest: u32,
}

/// The comparable vertices of a chunk, sorted into parts.
struct Chunk<K> {
    entries: Vec<Entry<K>>,
    /// Where each part begins, and one more.
    starts: Vec<usize>,
}

/// For each point the lowest one with the same key; a point with a coordinate that is not comparable is alone.
fn lowest_of_equal<K: Key>(
    positions: &[[f64; 3]],
    is_comparable: impl Fn(f64) -> bool + Sync,
    key: impl Fn([f64; 3]) -> K + Sync,
) -> Vec<VertexId> {
    let part_bits = (positions.len() / PART).max(1).ilog2();
    let part_of = |key: K| (u128::from(key.hash()) << part_bits >> 64) as usize;
    let mut chunks: Vec<Chunk<K>> = positions
        .par_chunks(CHUNK)
        .enumerate()
        .map(|(chunk, positions)| {
            let compared = |p: &[f64; 3]| p.iter().all(|&x| is_comparable(x)).then(|| key(*p));
            Chunk::of(positions, chunk * CHUNK, 1 << part_bits, compared, part_of)
        })
        .collect();
    let parts = by_part(&mut chunks, 1 << part_bits);
    parts.into_par_iter().for_each_init(Table::new, |table, mut runs| table.find_lowest(&mut runs));
    let mut lowest: Vec<VertexId> = (0..positions.len()).map(VertexId::new).collect();
    lowest.par_chunks_mut(CHUNK).zip(&chunks).enumerate().for_each(|(at, (lowest, chunk))| {
        let first = at * CHUNK;
        chunk.entries.iter().for_each(|e| lowest[e.vertex as usize - first] = VertexId(e.lowest));
    });
    lowest
}

impl<K: Key> Chunk<K> {
    fn of(
        positions: &[[f64; 3]],
        first: usize,
        parts: usize,
        key: impl Fn(&[f64; 3]) -> Option<K>,
        part_of: impl Fn(K) -> usize,
    ) -> Self {
        let keys = || positions.iter().enumerate().filter_map(|(place, p)| Some((place, key(p)?)));
        let mut starts = vec![0; parts + 1];
        keys().for_each(|(_, key)| starts[part_of(key) + 1] += 1);
        for part in 0..parts {
            starts[part + 1] += starts[part];
        }
        let mut next = starts.clone();
        let mut entries = vec![Entry { key: K::NONE, vertex: 0, lowest: 0 }; starts[parts]];
        for (place, key) in keys() {
            let slot = &mut next[part_of(key)];
            let vertex = (first + place) as u32;
            entries[*slot] = Entry { key, vertex, lowest: vertex };
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

/// An open table of keys, each with the lowest vertex that has it; kept from part to part.
struct Table<K> {
    slots: Vec<(K, u32)>,
}

impl<K: Key> Table<K> {
    fn new() -> Self {
        Table { slots: Vec::new() }
    }

    /// Finds for each entry of a part the lowest vertex with its key.
    fn find_lowest(&mut self, runs: &mut [&mut [Entry<K>]]) {
        let count: usize = runs.iter().map(|run| run.len()).sum();
        let size = (2 * count).next_power_of_two();
        self.slots.clear();
        self.slots.resize(size, (K::NONE, NO_VERTEX));
        // Far more than honest keys ever need.
        let mut steps_left = 16 * count + 64;
        for entry in runs.iter_mut().flat_map(|run| run.iter_mut()) {
            let mut slot = entry.key.hash() as usize & (size - 1);
            loop {
                let (key, lowest) = self.slots[slot];
                if lowest == NO_VERTEX {
                    self.slots[slot] = (entry.key, entry.vertex);
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
    all.sort_unstable_by_key(|entry| (entry.key, entry.vertex));
    for equal in all.chunk_by_mut(|one, other| one.key == other.key) {
        let lowest = equal[0].vertex;
        equal.iter_mut().for_each(|entry| entry.lowest = lowest);
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use meshmend_core::FaceTable;
    use proptest::prelude::*;

    use super::*;

    fn lowest(positions: &[[f64; 3]]) -> Vec<u32> {
        let faces = FaceTable::empty(positions.len());
        let mesh = PolygonMesh::new(positions.to_vec(), faces).unwrap();
        coincident_vertices(&mesh).into_iter().map(|vertex| vertex.0).collect()
    }

    fn expected(positions: &[[f64; 3]]) -> Vec<u32> {
        let mut first = BTreeMap::new();
        let position = |(vertex, p): (u32, &[f64; 3])| {
            let key = p.map(|x| (x + 0.0).to_bits());
            if p.iter().all(|x| x.is_finite()) { *first.entry(key).or_insert(vertex) } else { vertex }
        };
        (0..).zip(positions).map(position).collect()
    }

    #[test]
    fn zeros_are_equal_and_what_is_not_finite_equals_nothing() {
        let positions = [
            [0.0, -0.0, 1.0],
            [-0.0, 0.0, 1.0],
            [f64::NAN, 0.0, 0.0],
            [f64::NAN, 0.0, 0.0],
            [f64::INFINITY, 0.0, 0.0],
            [f64::INFINITY, 0.0, 0.0],
            [0.0, 0.0, 1.0],
        ];
        assert_eq!(lowest(&positions), [0, 0, 2, 3, 4, 5, 0]);
        // Without the numbers that are none all are single precision.
        assert_eq!(lowest(&positions[4..]), [0, 1, 2]);
        assert_eq!(lowest(&[]), [0u32; 0]);
    }

    /// More than one chunk and many parts, in single and in double precision.
    #[test]
    fn large_clouds_are_as_a_map_has_them() {
        for scale in [1.0, 0.1] {
            let count = 5 * CHUNK as u64 / 2;
            let coordinate = |i: u64, step: u64| (i.wrapping_mul(step) % 40) as f64 * scale;
            let positions: Vec<[f64; 3]> = (0..count)
                .map(|i| [coordinate(i, 7), coordinate(i / 40, 11), coordinate(i / 977, 13)])
                .collect();
            assert_eq!(lowest(&positions), expected(&positions));
        }
    }

    /// What is joined in single precision is counted beyond what is equal, also where numbers leave its range.
    #[test]
    fn single_precision_joins_more() {
        let positions = [
            [0.1, 0.0, 0.0],
            [0.1_f32.into(), 0.0, 0.0],
            [0.1, -0.0, 1e-60],
            [0.1, 0.0, 0.0],
            [1e39, 0.0, 0.0],
            [1e39, 0.0, 0.0],
            [2e39, 0.0, 0.0],
            [f64::NAN, 0.0, 0.0],
            [0.5, 0.0, 0.0],
        ];
        let found = Coincidence::of(&positions);
        let exactly: Vec<u32> = found.exactly.iter().map(|v| v.0).collect();
        assert_eq!((exactly, found.only_in_single), (vec![0, 1, 2, 0, 4, 4, 6, 7, 8], 2));
        let in_single: Vec<u32> = equal_in_single(&positions).iter().map(|v| v.0).collect();
        assert_eq!(in_single, [0, 0, 0, 0, 4, 5, 6, 7, 8]);
        assert_eq!(Coincidence::of(&positions[8..]).only_in_single, 0);
    }

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
        let positions: Vec<[f64; 3]> = (0..5000u32).map(|i| [f64::from(i % 1250), 0.0, 0.0]).collect();
        let found = lowest_of_equal(&positions, f64::is_finite, |[x, _, _]| Colliding(x as u32));
        assert!(found.iter().zip(0..).all(|(lowest, vertex)| lowest.0 == vertex % 1250));
    }

    proptest! {
        #[test]
        fn small_clouds_are_as_a_map_has_them(cells in prop::collection::vec((0..3i8, -1..2i8, 0..2i8), 0..60)) {
            let point = |&(x, y, z): &(i8, i8, i8)| [f64::from(x) / 3.0, f64::from(y) * -0.0, f64::from(z)];
            let positions: Vec<[f64; 3]> = cells.iter().map(point).collect();
            prop_assert_eq!(lowest(&positions), expected(&positions));
        }
    }
}
