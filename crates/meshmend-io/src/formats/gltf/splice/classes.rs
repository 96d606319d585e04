//! Which rows the pools of a part have now, and which of them each corner names.

use std::collections::BTreeMap;

use meshmend_core::{CornerId, Id};

use crate::formats::gltf::splice::part_rows::PartRows;

/// The row of a pool as it is now.
#[derive(Clone, Copy, Debug)]
pub(super) struct NewRow {
    /// The row of the file whose values it has, or some of them.
    pub(super) old: Option<u32>,
    /// A corner that has its values; `None` for a row of the file that stays though no face uses it.
    pub(super) corner: Option<CornerId>,
    /// Whether all values are those of the old row.
    pub(super) is_as_stored: bool,
}

/// The rows of a pool as they are now.
#[derive(Debug, Default)]
pub(super) struct NewPool {
    pub(super) rows: Vec<NewRow>,
    /// For each row of the file its number now.
    pub(super) row_now: Vec<Option<u32>>,
    /// Whether a row went, came or changed.
    pub(super) is_changed: bool,
    /// How many rows are written once more, as their corners are at several vertices now.
    pub(super) parted: usize,
}

/// The rows of a part as they are now.
pub(super) struct Classes {
    pub(super) pools: Vec<NewPool>,
    /// The primitive of each face; `None`: no primitive takes it.
    pub(super) primitives: Vec<Option<usize>>,
    /// The number of each corner's row in its pool.
    pub(super) corners: Vec<u32>,
}

/// A row that has no place of its own among those of the file: by old row, vertex and values.
type Key = (Option<u32>, u32, Option<Vec<u32>>);

/// How the rows of a part are found.
struct Finder<'c, 'p> {
    part: &'c PartRows<'p>,
    /// For each row of the file what takes its place: the vertex, and the key where the values differ.
    taken: Vec<Option<NewRow>>,
    further: BTreeMap<(usize, Key), usize>,
    /// The pool and the row of each further one, in the order in which they are met.
    listed: Vec<(usize, NewRow)>,
}

/// A row before all are numbered.
#[derive(Clone, Copy)]
enum Found {
    OfFile(u32),
    Further(usize),
}

impl Classes {
    /// The rows of a part. A row of the file keeps its place if corners still have its values, or others in place of them;
    /// rows that are used by points and lines stay.
    pub(super) fn of(part: &PartRows<'_>, is_kept: &[bool]) -> Self {
        let primitives = primitives_of(part);
        let mut finder =
            Finder { part, taken: vec![None; part.pools.rows], further: BTreeMap::new(), listed: Vec::new() };
        let found = finder.found(&primitives);
        let Finder { taken, listed, .. } = finder;
        let mut pools: Vec<NewPool> = Vec::new();
        for pool in &part.pools.list {
            let range = pool.base..pool.base + pool.rows;
            pools.push(NewPool::of_file(&taken[range.clone()], &is_kept[range], pool.base as u32));
        }
        let mut further = Vec::with_capacity(listed.len());
        for (pool, row) in listed {
            further.push(pools[pool].rows.len() as u32);
            pools[pool].parted += usize::from(row.is_as_stored);
            pools[pool].rows.push(row);
            pools[pool].is_changed = true;
        }
        let number = |(corner, found): (usize, &Option<Found>)| match found {
            None => 0,
            Some(Found::Further(at)) => further[*at],
            Some(Found::OfFile(row)) => {
                let face = corner / 3;
                let pool = primitives[face].and_then(|primitive| part.pools.of_primitive[primitive]);
                let pool = pool.unwrap_or_default();
                let row = *row as usize - part.pools.list[pool].base;
                pools[pool].row_now[row].unwrap_or_default()
            }
        };
        let corners = found.iter().enumerate().map(number).collect();
        Classes { pools, primitives, corners }
    }
}

/// The primitive that each face is in: its own, or that of the face before it.
fn primitives_of(part: &PartRows<'_>) -> Vec<Option<usize>> {
    let mut last = part.pools.of_primitive.iter().position(Option::is_some);
    (0..part.mesh.faces().face_count())
        .map(|face| {
            last = part.primitive(face).or(last);
            last
        })
        .collect()
}

impl Finder<'_, '_> {
    /// The row of each corner. Those that have all values of a row of the file take its place first.
    fn found(&mut self, primitives: &[Option<usize>]) -> Vec<Option<Found>> {
        let mut found: Vec<Option<Found>> = vec![None; self.part.mesh.faces().corner_count()];
        let mut others: Vec<(usize, CornerId, Option<u32>)> = Vec::new();
        for corner in self.part.mesh.faces().corners() {
            let face = corner.index() / 3;
            let Some(pool) = primitives[face].and_then(|at| self.part.pools.of_primitive[at]) else {
                continue;
            };
            let row = self.part.row(corner, pool);
            match row.filter(|&row| self.part.is_as_stored(corner, row)) {
                Some(row) => found[corner.index()] = Some(self.as_stored(pool, corner, row)),
                None => others.push((pool, corner, row)),
            }
        }
        for (pool, corner, row) in others {
            found[corner.index()] = Some(self.changed(pool, corner, row));
        }
        found
    }

    fn as_stored(&mut self, pool: usize, corner: CornerId, row: u32) -> Found {
        let new = NewRow { old: Some(row), corner: Some(corner), is_as_stored: true };
        let first = self.taken[row as usize].get_or_insert(new);
        let vertex = self.part.vertex(corner);
        if first.corner.is_some_and(|first| self.part.vertex(first) == vertex) {
            return Found::OfFile(row);
        }
        self.further(pool, (Some(row), vertex.0, None), new)
    }

    fn changed(&mut self, pool: usize, corner: CornerId, row: Option<u32>) -> Found {
        let (vertex, uses) = (self.part.vertex(corner), self.part.uses(corner));
        let new = NewRow { old: row, corner: Some(corner), is_as_stored: false };
        if let Some(row) = row {
            let first = *self.taken[row as usize].get_or_insert(new);
            let is_same =
                |first: CornerId| self.part.vertex(first) == vertex && self.part.uses(first) == uses;
            if !first.is_as_stored && first.corner.is_some_and(is_same) {
                return Found::OfFile(row);
            }
        }
        self.further(pool, (row, vertex.0, Some(uses)), new)
    }

    fn further(&mut self, pool: usize, key: Key, new: NewRow) -> Found {
        let next = self.listed.len();
        let at = *self.further.entry((pool, key)).or_insert(next);
        if at == next {
            self.listed.push((pool, new));
        }
        Found::Further(at)
    }
}

impl NewPool {
    /// The rows of the file that stay, with what takes their places.
    fn of_file(taken: &[Option<NewRow>], is_kept: &[bool], base: u32) -> Self {
        let mut pool = NewPool::default();
        for (at, (new, &is_kept)) in taken.iter().zip(is_kept).enumerate() {
            let kept = NewRow { old: Some(base + at as u32), corner: None, is_as_stored: true };
            let new = new.or(is_kept.then_some(kept));
            pool.row_now.push(new.map(|_| pool.rows.len() as u32));
            pool.is_changed |= new.is_none_or(|new| !new.is_as_stored);
            pool.rows.extend(new);
        }
        pool
    }
}
