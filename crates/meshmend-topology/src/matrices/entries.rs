//! The entries of incidence matrices, and ∂₂ by columns.

use meshmend_core::{EdgeId, EdgeTable, FaceId, FaceTable, Id};

/// Sides of a face that are no entry of ∂₂, since as many of them run along the edge one way as the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LostSide {
    /// The face.
    pub face: FaceId,
    /// The edge along which it runs both ways.
    pub edge: EdgeId,
    /// How many pairs of sides cancel.
    pub pairs: u32,
}

/// The place of a one in a row or column: an index below 2³¹, with the sign in the lowest bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Entry(u32);

impl Entry {
    pub(super) fn plus(index: impl Id) -> Self {
        Entry((index.index() as u32) << 1)
    }

    pub(super) fn minus(index: impl Id) -> Self {
        Entry((index.index() as u32) << 1 | 1)
    }

    pub(super) fn signed(index: impl Id, is_positive: bool) -> Self {
        if is_positive { Self::plus(index) } else { Self::minus(index) }
    }

    pub(super) fn index<I: Id>(self) -> I {
        I::new((self.0 >> 1) as usize)
    }

    pub(super) fn sign(self) -> i64 {
        if self.0 & 1 == 0 { 1 } else { -1 }
    }
}

/// ∂₂ by columns, and what cancels in it.
pub(super) struct FaceColumns {
    pub(super) starts: Option<Vec<u32>>,
    pub(super) entries: Vec<Entry>,
    pub(super) lost_sides: Vec<LostSide>,
}

impl FaceColumns {
    pub(super) fn of(faces: &FaceTable, edges: &EdgeTable) -> Self {
        let mut starts = Vec::with_capacity(faces.face_count() + 1);
        let mut entries = Vec::with_capacity(faces.corner_count());
        let (mut lost_sides, mut sides) = (Vec::new(), Vec::new());
        for face in faces.faces() {
            starts.push(entries.len() as u32);
            sides.clear();
            sides.extend(faces.face_corners(face).map(|corner| {
                let edge = edges.corner_edge(corner);
                (edge, faces.corner_vertex(corner) == edges.ends(edge)[0])
            }));
            sides.sort_unstable();
            for run in sides.chunk_by(|one, other| one.0 == other.0) {
                let (edge, forward) = (run[0].0, run.iter().filter(|side| side.1).count());
                let backward = run.len() - forward;
                entries.extend(std::iter::repeat_n(Entry::plus(edge), forward.saturating_sub(backward)));
                entries.extend(std::iter::repeat_n(Entry::minus(edge), backward.saturating_sub(forward)));
                if forward.min(backward) > 0 {
                    lost_sides.push(LostSide { face, edge, pairs: forward.min(backward) as u32 });
                }
            }
        }
        starts.push(entries.len() as u32);
        entries.shrink_to_fit();
        lost_sides.shrink_to_fit();
        let is_uniform =
            starts.iter().zip(0u32..).all(|(&start, face)| u64::from(start) == 3 * u64::from(face));
        FaceColumns { starts: (!is_uniform).then_some(starts), entries, lost_sides }
    }

    pub(super) fn range(&self, face: FaceId) -> std::ops::Range<usize> {
        range(self.starts.as_deref(), face)
    }
}

/// The places of a face's entries: three each where there are no starts.
pub(super) fn range(starts: Option<&[u32]>, face: FaceId) -> std::ops::Range<usize> {
    let f = face.index();
    match starts {
        None => 3 * f..3 * f + 3,
        Some(starts) => starts[f] as usize..starts[f + 1] as usize,
    }
}

/// Entries, those of one index as one number.
pub(super) fn added_up<I: Id>(entries: &[Entry]) -> impl Iterator<Item = (I, i64)> {
    let runs = entries.chunk_by(|one, other| one.0 >> 1 == other.0 >> 1);
    runs.map(|run| (run[0].index(), run.iter().map(|entry| entry.sign()).sum()))
}
