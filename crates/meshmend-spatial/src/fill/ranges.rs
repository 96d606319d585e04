//! The triangles over all ranges of an opening's corners, each with a number.

use meshmend_core::VertexId;

use super::Opening;
use super::facet::{Direction, Facet};
use super::scaled::Scaled;

/// All triangles that a fill of an opening can have. Those over the range from corner `low` to corner `high` have
/// neighbouring numbers, by their third corner.
pub(super) struct Ranges<'a> {
    pub(super) vertices: &'a [VertexId],
    scaled: &'a Scaled,
    count: usize,
    /// For `low` and `high`, where the numbers of their triangles begin.
    starts: Vec<u32>,
    corners: Vec<[u16; 3]>,
    facets: Vec<Facet>,
    /// The triangles that no fill may have.
    is_barred: Vec<bool>,
}

/// A range of corners: from a lower one to a higher one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Range {
    pub(super) low: usize,
    pub(super) high: usize,
}

impl<'a> Ranges<'a> {
    /// *Cost*: cubic.
    pub(super) fn new(opening: &Opening<'a>, scaled: &'a Scaled) -> Self {
        let count = scaled.len();
        let mut ranges = Ranges {
            vertices: opening.vertices,
            scaled,
            count,
            starts: vec![0; count * count],
            corners: Vec::new(),
            facets: Vec::new(),
            is_barred: Vec::new(),
        };
        for range in all_ranges(count) {
            ranges.starts[range.low * count + range.high] = ranges.corners.len() as u32;
            let is_diagonal = range.high - range.low < count - 1;
            let is_taken = is_diagonal && (opening.is_joined)(range.low, range.high);
            for middle in range.low + 1..range.high {
                let triangle = [range.low, middle, range.high];
                ranges.corners.push(triangle.map(|corner| corner as u16));
                ranges.facets.push(scaled.facet(triangle));
                ranges.is_barred.push(is_taken || (opening.is_there)(triangle));
            }
        }
        ranges
    }

    /// All ranges of three corners or more, the short ones first.
    pub(super) fn all(&self) -> impl Iterator<Item = Range> + use<> {
        all_ranges(self.count)
    }

    /// The range of all corners.
    pub(super) fn whole(&self) -> Range {
        Range { low: 0, high: self.count - 1 }
    }

    /// How many triangles there are.
    pub(super) fn len(&self) -> usize {
        self.corners.len()
    }

    /// The numbers of the triangles over a range.
    pub(super) fn triangles_over(&self, range: Range) -> std::ops::Range<usize> {
        let start = self.starts[range.low * self.count + range.high] as usize;
        start..start + (range.high - range.low).saturating_sub(1)
    }

    pub(super) fn facet(&self, triangle: usize) -> &Facet {
        &self.facets[triangle]
    }

    pub(super) fn corners(&self, triangle: usize) -> [usize; 3] {
        self.corners[triangle].map(usize::from)
    }

    /// Whether a fill may not have a triangle: it is there, or an edge joins two of its corners.
    pub(super) fn is_barred(&self, triangle: usize) -> bool {
        self.is_barred[triangle]
    }

    /// The two ranges below a triangle.
    pub(super) fn below(&self, triangle: usize) -> [Range; 2] {
        let [low, middle, high] = self.corners(triangle);
        [Range { low, high: middle }, Range { low: middle, high }]
    }

    /// The direction of the face beside the loop's side that is this range; `None` for a range that is no side below a triangle.
    pub(super) fn beside(&self, range: Range) -> Option<Direction> {
        (range.high - range.low == 1).then(|| self.scaled.beside(range.low))
    }

    /// The direction of the face beside the side from the last corner to the first.
    pub(super) fn beside_last(&self) -> Direction {
        self.scaled.beside(self.count - 1)
    }
}

fn all_ranges(count: usize) -> impl Iterator<Item = Range> + use<> {
    (2..count).flat_map(move |length| (0..count - length).map(move |low| Range { low, high: low + length }))
}
