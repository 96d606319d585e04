//! The faces of a mesh as lists of corners.
//!
//! ```text
//!            f0          f1        f2
//! starts   0           3         6          10        (absent when every face is a triangle)
//! corners  v0 v1 v2    v2 v1 v3  v3 v1 v4 v5
//! ```
//!
//! The table is well-formed by construction: every corner names a vertex that exists, and there are fewer than
//! 2³¹ corners. It is *not* promised to be a surface, or even to have proper faces: a face may have no corner,
//! or one, or the same vertex twice in a row. What the rest of the library analyses is the [`Complex`] of the
//! table, in which such faces are set aside.
//!
//! [`Complex`]: crate::Complex

use std::sync::Arc;

use crate::{CornerId, FaceId, FaceTableError, Id, MAX_CORNERS, VertexId};

/// The faces of a mesh, each a cyclic sequence of vertices: the input of every kernel.
#[derive(Clone, Debug)]
pub struct FaceTable {
    vertex_count: usize,
    /// Where each face's corners begin, and one more; absent when every face is a triangle.
    starts: Option<Vec<u32>>,
    /// Shared with other tables, and with the places of a soup's vertices.
    corners: Arc<Vec<VertexId>>,
}

/// Two tables are equal when they hold the same faces, however they are stored.
impl PartialEq for FaceTable {
    fn eq(&self, other: &Self) -> bool {
        self.vertex_count == other.vertex_count
            && self.corners == other.corners
            && self.face_count() == other.face_count()
            && (self.starts == other.starts
                || self.faces().all(|f| self.corner_range(f) == other.corner_range(f)))
    }
}

impl FaceTable {
    /// A table of triangles: three corners a face, no starts stored.
    ///
    /// # Errors
    /// When a corner names a vertex at or beyond `vertex_count`, the number of corners is not a multiple of three,
    /// or there are too many elements.
    ///
    /// *Cost*: one pass over the corners.
    pub fn triangles(vertex_count: usize, corners: Vec<VertexId>) -> Result<Self, FaceTableError> {
        if !corners.len().is_multiple_of(3) {
            return Err(FaceTableError::NotTriangles { corner_count: corners.len() });
        }
        let table = FaceTable { vertex_count, starts: None, corners: Arc::new(corners) };
        table.checked()
    }

    /// A table of faces of any size: face `f` has the corners `starts[f] .. starts[f + 1]`.
    ///
    /// ```
    /// # use meshmend_core::{FaceTable, VertexId};
    /// let corners = [0, 1, 2, 2, 1, 3, 4].map(VertexId).to_vec();
    /// let table = FaceTable::polygons(5, vec![0, 3, 7], corners)?;
    /// assert_eq!(table.face_count(), 2);
    /// # Ok::<(), meshmend_core::FaceTableError>(())
    /// ```
    ///
    /// # Errors
    /// When a corner names a vertex at or beyond `vertex_count`, the starts do not ascend from 0 to the number
    /// of corners, or there are too many elements.
    ///
    /// *Cost*: one pass over starts and corners; the starts are dropped when every face is a triangle.
    pub fn polygons(
        vertex_count: usize,
        starts: Vec<u32>,
        corners: Vec<VertexId>,
    ) -> Result<Self, FaceTableError> {
        check_starts(&starts, corners.len())?;
        let all_triangles = starts.windows(2).all(|pair| pair[1] - pair[0] == 3);
        let starts = if all_triangles { None } else { Some(starts) };
        FaceTable { vertex_count, starts, corners: Arc::new(corners) }.checked()
    }

    /// Faces of the same sizes over other vertices.
    ///
    /// # Errors
    /// When there are more or fewer corners, one names a vertex at or beyond `vertex_count`, or there are too many
    /// elements.
    ///
    /// *Cost*: one pass over the corners.
    pub fn over(&self, vertex_count: usize, corners: Vec<VertexId>) -> Result<Self, FaceTableError> {
        if corners.len() != self.corners.len() {
            let (found, expected) = (corners.len(), self.corners.len());
            return Err(FaceTableError::CornerCount { found, expected });
        }
        FaceTable { vertex_count, starts: self.starts.clone(), corners: Arc::new(corners) }.checked()
    }

    /// A table of faces that a builder has collected.
    pub(super) fn of_parts(
        vertex_count: usize,
        starts: Option<Vec<u32>>,
        corners: Vec<VertexId>,
    ) -> Result<Self, FaceTableError> {
        FaceTable { vertex_count, starts, corners: Arc::new(corners) }.checked()
    }

    /// Faces of the same sizes, whose corner `c` is `corners[c]`, if the corners of this table are the vertices in order.
    ///
    /// *Cost*: one pass over the corners; nothing is copied but starts.
    pub(crate) fn over_shared(&self, vertex_count: usize, corners: &Arc<Vec<VertexId>>) -> Option<Self> {
        let is_soup = || self.corners.iter().zip(0..).all(|(vertex, corner)| vertex.0 == corner);
        if corners.len() != self.corners.len() || !is_soup() {
            return None;
        }
        FaceTable { vertex_count, starts: self.starts.clone(), corners: Arc::clone(corners) }.checked().ok()
    }

    fn checked(self) -> Result<Self, FaceTableError> {
        for (what, count) in
            [("vertices", self.vertex_count), ("corners", self.corners.len()), ("faces", self.face_count())]
        {
            if count >= MAX_CORNERS {
                return Err(FaceTableError::TooLarge { what, count });
            }
        }
        match self.corners.iter().position(|v| v.index() >= self.vertex_count) {
            None => Ok(self),
            Some(place) => {
                let face = self.corner_face(CornerId::new(place));
                Err(FaceTableError::NoSuchVertex {
                    face: face.index(),
                    corner: place - self.corner_range(face).start,
                    vertex: self.corners[place].0,
                    vertex_count: self.vertex_count,
                })
            }
        }
    }

    /// A table without a face.
    pub fn empty(vertex_count: usize) -> Self {
        FaceTable { vertex_count, starts: None, corners: Arc::default() }
    }

    /// How many vertices the corners may name; some may be in no face.
    #[inline]
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// How many faces there are, degenerate ones included.
    #[inline]
    pub fn face_count(&self) -> usize {
        match &self.starts {
            None => self.corners.len() / 3,
            Some(starts) => starts.len() - 1,
        }
    }

    /// How many corners all faces have together.
    #[inline]
    pub fn corner_count(&self) -> usize {
        self.corners.len()
    }

    /// Whether every face has exactly three corners.
    pub fn is_all_triangles(&self) -> bool {
        self.starts.is_none()
    }

    /// Every face, ascending.
    pub fn faces(&self) -> impl DoubleEndedIterator<Item = FaceId> + ExactSizeIterator + Clone + use<> {
        (0..self.face_count()).map(FaceId::new)
    }

    /// Every corner, ascending.
    pub fn corners(&self) -> impl DoubleEndedIterator<Item = CornerId> + ExactSizeIterator + Clone + use<> {
        (0..self.corners.len()).map(CornerId::new)
    }

    /// The places of a face's corners in the list of all corners.
    #[inline]
    pub fn corner_range(&self, face: FaceId) -> std::ops::Range<usize> {
        let f = face.index();
        match &self.starts {
            None => 3 * f..3 * f + 3,
            Some(starts) => starts[f] as usize..starts[f + 1] as usize,
        }
    }

    /// The corners of a face, in order.
    #[inline]
    pub fn face_corners(
        &self,
        face: FaceId,
    ) -> impl DoubleEndedIterator<Item = CornerId> + ExactSizeIterator + Clone + use<> {
        self.corner_range(face).map(CornerId::new)
    }

    /// The vertices of a face, in order, as a slice of the table.
    #[inline]
    pub fn face_vertices(&self, face: FaceId) -> &[VertexId] {
        &self.corners[self.corner_range(face)]
    }

    /// The vertices of all corners, face after face.
    #[inline]
    pub fn corner_vertices(&self) -> &[VertexId] {
        &self.corners
    }

    /// The vertex at a corner.
    #[inline]
    pub fn corner_vertex(&self, corner: CornerId) -> VertexId {
        self.corners[corner.index()]
    }

    /// The face that a corner belongs to.
    ///
    /// *Cost*: constant for triangles, else a search in the starts; for all corners walk the faces instead.
    pub fn corner_face(&self, corner: CornerId) -> FaceId {
        match &self.starts {
            None => FaceId::new(corner.index() / 3),
            Some(starts) => FaceId::new(starts.partition_point(|&start| start <= corner.0) - 1),
        }
    }

    /// Where each face's corners begin, and one more; `None` if every face is a triangle.
    pub fn starts(&self) -> Option<&[u32]> {
        self.starts.as_deref()
    }

    /// Bytes on the heap.
    pub fn heap_bytes(&self) -> usize {
        self.corners.capacity() * size_of::<VertexId>()
            + self.starts.as_ref().map_or(0, |starts| starts.capacity() * size_of::<u32>())
    }
}

/// Whether starts ascend from 0 to the number of corners; else what is wrong, and where.
fn check_starts(starts: &[u32], corner_count: usize) -> Result<(), FaceTableError> {
    let (Some(&first), Some(&last)) = (starts.first(), starts.last()) else {
        return Err(FaceTableError::NoStarts);
    };
    if first != 0 {
        return Err(FaceTableError::FirstStart { start: first });
    }
    if let Some(face) = starts.windows(2).position(|pair| pair[0] > pair[1]) {
        return Err(FaceTableError::Descending { face, start: starts[face], end: starts[face + 1] });
    }
    if last as usize != corner_count {
        return Err(FaceTableError::LastStart { start: last, corner_count });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceTableBuilder;

    fn ids(list: &[u32]) -> Vec<VertexId> {
        list.iter().copied().map(VertexId).collect()
    }

    #[test]
    fn faces_of_the_same_sizes_over_other_vertices() {
        let table = FaceTable::polygons(5, vec![0, 2, 6], ids(&[0, 1, 1, 2, 3, 4])).unwrap();
        let other = table.over(2, ids(&[1, 0, 0, 1, 0, 1])).unwrap();
        assert_eq!(other, FaceTable::polygons(2, vec![0, 2, 6], ids(&[1, 0, 0, 1, 0, 1])).unwrap());
        assert_eq!(table.over(2, ids(&[0, 1])), Err(FaceTableError::CornerCount { found: 2, expected: 6 }));
        let beyond = FaceTableError::NoSuchVertex { face: 1, corner: 0, vertex: 7, vertex_count: 2 };
        assert_eq!(table.over(2, ids(&[0, 1, 7, 0, 0, 0])), Err(beyond));
    }

    #[test]
    fn starts_are_stored_only_when_needed() {
        let mut builder = FaceTableBuilder::default();
        builder.push_face(ids(&[0, 1, 2]));
        assert!(builder.clone().build(4).unwrap().is_all_triangles());
        builder.push_face(ids(&[0, 1, 2, 3]));
        builder.push_face(ids(&[]));
        let table = builder.build(4).unwrap();
        assert_eq!(table.starts(), Some(&[0, 3, 7, 7][..]));
        assert_eq!(table.corner_face(CornerId(6)), FaceId(1));
        assert_eq!(table.face_vertices(FaceId(2)), &[]);
    }

    #[test]
    fn what_one_builder_appends_to_another_is_as_if_it_had_been_added_there() {
        let lists: [&[&[u32]]; 4] =
            [&[], &[&[0, 1, 2], &[2, 1, 0]], &[&[0, 1, 2, 3], &[1, 2, 3]], &[&[1, 2, 3], &[], &[0]]];
        let of = |list: &[&[u32]]| {
            let mut builder = FaceTableBuilder::default();
            list.iter().for_each(|face| builder.push_face(ids(face)));
            builder
        };
        for first in lists {
            for second in lists {
                let mut appended = of(first);
                let mut other = of(second);
                other.push_corner(VertexId(3));
                appended.append(&other);
                assert_eq!(appended.face_count(), first.len() + second.len());
                appended.push_face(ids(&[3, 2, 1]));
                let expected = of(&[first, second, &[&[3, 2, 1]]].concat());
                assert_eq!(appended.build(4), expected.build(4));
            }
        }
    }

    #[test]
    fn an_abandoned_face_and_a_cleared_builder_leave_nothing() {
        let mut builder = FaceTableBuilder::default();
        builder.push_face(ids(&[0, 1, 2, 3]));
        builder.push_corner(VertexId(3));
        builder.abandon_face();
        assert_eq!((builder.face_count(), builder.corner_count()), (1, 4));
        builder.clear();
        assert_eq!((builder.face_count(), builder.corner_count()), (0, 0));
        builder.push_face(ids(&[0, 1, 2]));
        assert!(builder.build(3).unwrap().is_all_triangles());
    }

    #[test]
    fn triangles_in_both_storages_are_equal() {
        let short = FaceTable::triangles(3, ids(&[0, 1, 2])).unwrap();
        let long = FaceTable::polygons(3, vec![0, 3], ids(&[0, 1, 2])).unwrap();
        assert_eq!(short, long);
        assert!(long.is_all_triangles());
    }

    #[test]
    fn a_table_with_other_vertices_corners_or_bounds_is_another_table() {
        let one = FaceTable::polygons(6, vec![0, 2, 6], ids(&[0, 1, 2, 3, 4, 5])).unwrap();
        let bounds = FaceTable::polygons(6, vec![0, 4, 6], ids(&[0, 1, 2, 3, 4, 5])).unwrap();
        let corners = FaceTable::polygons(6, vec![0, 2, 6], ids(&[0, 1, 2, 3, 5, 4])).unwrap();
        let vertices = FaceTable::polygons(7, vec![0, 2, 6], ids(&[0, 1, 2, 3, 4, 5])).unwrap();
        for other in [bounds, corners, vertices] {
            assert_ne!(one, other);
        }
    }

    #[test]
    fn triangles_are_counted_and_found_without_starts() {
        let table = FaceTable::polygons(3, vec![0, 3, 6], ids(&[0, 1, 2, 2, 1, 0])).unwrap();
        assert!(table.is_all_triangles());
        let faces: Vec<FaceId> = table.corners().map(|c| table.corner_face(c)).collect();
        assert_eq!(faces, [0, 0, 0, 1, 1, 1].map(FaceId));
        let mut builder = FaceTableBuilder::default();
        let counts = [3, 3, 4, 3].map(|size| {
            builder.push_face((0..size).map(VertexId));
            (builder.face_count(), builder.corner_count())
        });
        assert_eq!(counts, [(1, 3), (2, 6), (3, 10), (4, 13)]);
    }

    #[test]
    fn bytes_are_those_of_corners_and_starts() {
        let triangle = FaceTable::triangles(3, ids(&[0, 1, 2])).unwrap();
        assert_eq!(triangle.heap_bytes(), 3 * 4);
        let square = FaceTable::polygons(4, vec![0, 4], ids(&[0, 1, 2, 3])).unwrap();
        assert_eq!(square.heap_bytes(), 4 * 4 + 2 * 4);
    }

    #[test]
    fn an_unknown_vertex_is_named_with_its_face() {
        let wrong = FaceTable::polygons(3, vec![0, 0, 3], ids(&[0, 1, 3]));
        assert_eq!(
            wrong,
            Err(FaceTableError::NoSuchVertex { face: 1, corner: 2, vertex: 3, vertex_count: 3 })
        );
    }

    #[test]
    fn starts_must_ascend_to_the_corner_count() {
        let wrong = |starts| FaceTable::polygons(3, starts, ids(&[0, 1, 2])).unwrap_err();
        assert_eq!(wrong(vec![]), FaceTableError::NoStarts);
        assert_eq!(wrong(vec![0]), FaceTableError::LastStart { start: 0, corner_count: 3 });
        assert_eq!(wrong(vec![1, 3]), FaceTableError::FirstStart { start: 1 });
        assert_eq!(wrong(vec![0, 4, 3]), FaceTableError::Descending { face: 1, start: 4, end: 3 });
        assert_eq!(wrong(vec![0, 2]), FaceTableError::LastStart { start: 2, corner_count: 3 });
        let two = FaceTable::triangles(3, ids(&[0, 1]));
        assert_eq!(two, Err(FaceTableError::NotTriangles { corner_count: 2 }));
    }
}
