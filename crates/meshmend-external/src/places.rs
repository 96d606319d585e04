//! Which vertices of a file are at one place.
//!
//! Positions are put in parts by a hash of what they are in single precision, so that equal ones are in the same part; each part is
//! sorted. In a welded view vertices at one place are one from then on: a set of those that are the lowest at their place tells
//! their new numbers, and what the others are joined to lies on disk by ranges of vertices as stored.

use std::path::Path;

use fixedbitset::FixedBitSet;
use meshmend_core::{Cancelled, Defect, DefectKind, VertexId, Watch};
use meshmend_io::{Announced, ReadOptions};

use crate::budget::Budget;
use crate::error::ExternalError;
use crate::lists::Lists;
use crate::ranked::RankedSet;
use crate::sinks::{Rows, read_rows};
use crate::spill::Spill;

/// What the positions of a file say.
pub(crate) struct Places {
    /// What the file holds.
    pub(crate) announced: Announced,
    /// The vertices of the view, by those as stored.
    pub(crate) vertices: VertexMap,
    /// How many vertices the view has.
    pub(crate) vertex_count: u32,
    /// Its vertices whose position is not finite, if there are any.
    pub(crate) infinite: Option<FixedBitSet>,
    /// How many vertices single precision would join beyond those at one place.
    pub(crate) joined_in_single: u64,
    /// How many bytes were written to disk.
    pub(crate) written: u64,
    /// Whether vertices at one place are one in the view.
    pub(crate) is_welded: bool,
}

/// Reads the positions of a file, and finds those that are equal. In a view as stored they are listed.
pub(crate) fn places(
    path: &Path,
    read: &ReadOptions,
    is_welded: Option<bool>,
    budget: &Budget<'_>,
    lists: &mut Lists,
) -> Result<Places, ExternalError> {
    let mut sink = Positions { budget, spill: None, announced: None, next: 0, infinite: None };
    read_rows(path, read, &mut sink)?;
    let Positions { spill, announced, infinite, .. } = sink;
    let (Some(spill), Some(announced)) = (spill, announced) else { return Err(Cancelled.into()) };
    let count = announced.vertices;
    let is_welded = is_welded.unwrap_or(!announced.format.has_indices());
    let mut found = Equal {
        roots: is_welded.then(|| RankedSet::full(count as usize)),
        joined: None,
        range: budget.range_of_stored(&announced),
        joined_in_single: 0,
        lists,
    };
    if is_welded {
        found.joined = Some(budget.spill(count.div_ceil(found.range) as usize)?);
    }
    for part in 0..spill.part_count() {
        look(&read.watch, part, spill.part_count())?;
        let numbers = spill.load(part)?;
        if announced.is_single { found.singles(numbers)? } else { found.doubles(numbers)? }
    }
    let written = spill.written() + found.joined.as_ref().map_or(0, Spill::written);
    let Equal { roots, joined, range, joined_in_single, .. } = found;
    let (vertices, vertex_count) = match roots.zip(joined) {
        None => (VertexMap::Same, count as u32),
        Some((roots, joined)) => {
            let (roots, vertex_count) = roots.ranked();
            (VertexMap::Welded(Box::new(Welded::new(roots, joined, (range, count)))), vertex_count)
        }
    };
    let infinite = infinite.map(|stored| vertices.places_of(&stored, vertex_count as usize));
    if let Some(infinite) = &infinite {
        infinite.ones().for_each(|vertex| {
            lists.add(Defect::new(
                DefectKind::NonFiniteVertex,
                meshmend_core::Element::Vertex(VertexId(vertex as u32)),
            ));
        });
    }
    Ok(Places { announced, vertices, vertex_count, infinite, joined_in_single, written, is_welded })
}

fn look(watch: &Watch, done: usize, total: usize) -> Result<(), Cancelled> {
    watch.look("weld", done, total)
}

/// Puts the positions of a file in parts.
struct Positions<'b> {
    budget: &'b Budget<'b>,
    spill: Option<Spill>,
    announced: Option<Announced>,
    next: u32,
    /// Vertices as stored whose position is not finite.
    infinite: Option<FixedBitSet>,
}

impl Rows for Positions<'_> {
    fn take_announced(&mut self, announced: &Announced) -> Result<(), ExternalError> {
        self.announced = Some(*announced);
        let bytes = if announced.is_single { SINGLE } else { DOUBLE } * 4;
        let resident = announced.vertices / 4;
        let parts = self.budget.parts(resident, announced.vertices * bytes as u64)?;
        self.spill = Some(self.budget.spill(parts)?);
        Ok(())
    }

    fn take_vertices(&mut self, positions: &[[f64; 3]]) -> Result<(), ExternalError> {
        let (Some(spill), Some(announced)) = (&mut self.spill, &self.announced) else { return Ok(()) };
        for &position in positions {
            let vertex = self.next;
            self.next += 1;
            if !position.iter().all(|x| x.is_finite()) {
                let all = || FixedBitSet::with_capacity(announced.vertices as usize);
                self.infinite.get_or_insert_with(all).insert(vertex as usize);
                continue;
            }
            let [x, y, z] = in_single(position);
            let part = (hash([x, y, z]) % spill.part_count() as u64) as usize;
            if announced.is_single {
                spill.push(part, &[x, y, z, vertex])?;
            } else {
                let [x, y, z] = position.map(|x| (x + 0.0).to_bits());
                let half = |x: u64| [(x >> 32) as u32, x as u32];
                let [[a, b], [c, d], [e, f]] = [half(x), half(y), half(z)];
                spill.push(part, &[a, b, c, d, e, f, vertex])?;
            }
        }
        Ok(())
    }

    fn has_all(&self) -> bool {
        self.announced.is_some_and(|announced| u64::from(self.next) == announced.vertices)
    }
}

/// How many numbers a position has with its vertex, if all are stored in single precision; else in double.
const SINGLE: usize = 4;
const DOUBLE: usize = 7;

/// The coordinates in single precision; −0 is 0.
#[inline]
fn in_single(position: [f64; 3]) -> [u32; 3] {
    position.map(|x| (x as f32 + 0.0).to_bits())
}

/// A hash in which every bit of the coordinates counts.
#[inline]
fn hash([x, y, z]: [u32; 3]) -> u64 {
    const ODD: u64 = 0x9e37_79b9_7f4a_7c15;
    let mixed = (u64::from(x) << 32 | u64::from(y)).wrapping_mul(ODD).rotate_left(29) ^ u64::from(z);
    mixed.wrapping_mul(ODD) >> 32
}

/// Collects what is equal.
struct Equal<'l> {
    /// In a welded view: the lowest vertices at their places.
    roots: Option<RankedSet>,
    /// In a welded view: pairs of a vertex and the lowest one at its place, by ranges of the first.
    joined: Option<Spill>,
    range: u64,
    joined_in_single: u64,
    lists: &'l mut Lists,
}

impl Equal<'_> {
    /// Looks at a part of positions that are all stored in single precision.
    fn singles(&mut self, mut numbers: Vec<u32>) -> Result<(), ExternalError> {
        let (points, _) = numbers.as_chunks_mut::<SINGLE>();
        points.sort_unstable();
        for equal in points.chunk_by(|one, other| one[..3] == other[..3]) {
            self.take(equal.iter().map(|point| point[3]))?;
        }
        Ok(())
    }

    /// Looks at a part of positions in double precision.
    fn doubles(&mut self, mut numbers: Vec<u32>) -> Result<(), ExternalError> {
        let double = |point: &[u32; DOUBLE]| {
            [0, 2, 4].map(|at| f64::from_bits(u64::from(point[at]) << 32 | u64::from(point[at + 1])))
        };
        let single = |point: &[u32; DOUBLE]| in_single(double(point));
        let (points, _) = numbers.as_chunks_mut::<DOUBLE>();
        points.sort_unstable_by_key(|point| (single(point), *point));
        for alike in points.chunk_by(|one, other| single(one) == single(other)) {
            let mut classes = 0;
            for equal in alike.chunk_by(|one, other| one[..6] == other[..6]) {
                classes += 1;
                self.take(equal.iter().map(|point| point[6]))?;
            }
            // What single precision does not reach equals nothing in it.
            let is_reached = single(&alike[0]).iter().all(|&bits| f32::from_bits(bits).is_finite());
            self.joined_in_single += if is_reached { classes - 1 } else { 0 };
        }
        Ok(())
    }

    /// Takes vertices at one place, ascending.
    fn take(&mut self, mut equal: impl Iterator<Item = u32>) -> Result<(), ExternalError> {
        let Some(lowest) = equal.next() else { return Ok(()) };
        for vertex in equal {
            match (&mut self.roots, &mut self.joined) {
                (Some(roots), Some(joined)) => {
                    roots.remove(vertex);
                    joined.push((u64::from(vertex) / self.range) as usize, &[vertex, lowest])?;
                }
                _ => self.lists.add(Defect::coincident_vertex(VertexId(vertex), VertexId(lowest))),
            }
        }
        Ok(())
    }
}

/// The vertices of a view by those as stored, and the other way round.
pub(crate) enum VertexMap {
    /// As stored.
    Same,
    /// Those at one place are one.
    Welded(Box<Welded>),
}

impl VertexMap {
    /// The vertex of the view that one as stored is.
    #[inline]
    pub(crate) fn vertex(&mut self, stored: u32) -> Result<u32, ExternalError> {
        match self {
            VertexMap::Same => Ok(stored),
            VertexMap::Welded(welded) => welded.vertex(stored),
        }
    }

    /// The vertex as stored that a vertex of the view is: of those that were joined, the lowest.
    pub(crate) fn stored(&self, vertex: u32) -> u32 {
        match self {
            VertexMap::Same => vertex,
            VertexMap::Welded(welded) => welded.roots.at(vertex).unwrap_or(vertex),
        }
    }

    /// The vertices of the view that some as stored are, each of which is the lowest at its place.
    fn places_of(&self, stored: &FixedBitSet, count: usize) -> FixedBitSet {
        let VertexMap::Welded(welded) = self else { return stored.clone() };
        let mut places = FixedBitSet::with_capacity(count);
        stored.ones().for_each(|vertex| places.insert(welded.roots.rank(vertex as u32) as usize));
        places
    }
}

pub(crate) struct Welded {
    /// The lowest vertices at their places: the numbers of the view are their ranks.
    roots: RankedSet,
    joined: Spill,
    range: u64,
    count: u64,
    /// The range that is in memory, and the vertices of the view for it.
    loaded: Option<u64>,
    vertices: Vec<u32>,
}

impl Welded {
    fn new(roots: RankedSet, joined: Spill, (range, count): (u64, u64)) -> Self {
        Welded { roots, joined, range, count, loaded: None, vertices: Vec::new() }
    }

    #[inline]
    fn vertex(&mut self, stored: u32) -> Result<u32, ExternalError> {
        let range = u64::from(stored) / self.range;
        if self.loaded != Some(range) {
            self.load(range)?;
        }
        Ok(self.vertices[(u64::from(stored) - range * self.range) as usize])
    }

    #[cold]
    fn load(&mut self, range: u64) -> Result<(), ExternalError> {
        let first = range * self.range;
        self.vertices.clear();
        self.vertices.extend(first as u32..(first + self.range).min(self.count) as u32);
        let vertices = &mut self.vertices;
        self.joined.read(range as usize, |numbers| {
            for pair in numbers.as_chunks::<2>().0 {
                vertices[(u64::from(pair[0]) - first) as usize] = pair[1];
            }
            Ok(())
        })?;
        self.vertices.iter_mut().for_each(|vertex| *vertex = self.roots.rank(*vertex));
        self.loaded = Some(range);
        Ok(())
    }
}
