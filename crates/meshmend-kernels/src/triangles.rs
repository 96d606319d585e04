//! Which face a corner is of where every face that has corners is a triangle.
//!
//! The first three corners are those of the first face, and so on: no array is needed. Only degenerate faces, which
//! have a number and no corners, bring this out of step.

use meshmend_core::{Array, Column, CornerId, FaceId, FaceTable, Id, Per};

/// The faces of a triangle complex, three corners each.
#[derive(Clone, Debug)]
pub(crate) struct Triangles {
    face_count: usize,
    /// Absent when every face has its three corners.
    out_of_step: Option<OutOfStep>,
}

#[derive(Clone, Debug)]
struct OutOfStep {
    /// The face of each three corners.
    face_of_three: Vec<FaceId>,
    first_corner: Column<FaceId, CornerId>,
}

/// What stands for the corner of a degenerate face: there are always fewer corners.
pub(crate) const NO_CORNER: CornerId = CornerId(u32::MAX);

impl Triangles {
    /// The faces of a table.
    ///
    /// *Cost*: constant without degenerate faces, else one pass over the faces.
    pub(crate) fn of(faces: &FaceTable) -> Self {
        let out_of_step = (!faces.is_all_triangles()).then(|| {
            let has_corners = |&face: &FaceId| !faces.corner_range(face).is_empty();
            let mut face_of_three = Vec::with_capacity(faces.corner_count() / 3);
            face_of_three.extend(faces.faces().filter(has_corners));
            let mut first_corner = Column::filled(NO_CORNER, faces.face_count());
            for (three, &face) in face_of_three.iter().enumerate() {
                first_corner[face] = CornerId::new(3 * three);
            }
            OutOfStep { face_of_three, first_corner }
        });
        Triangles { face_count: faces.face_count(), out_of_step }
    }

    /// How many faces there are, degenerate ones included.
    pub(crate) fn face_count(&self) -> usize {
        self.face_count
    }

    /// How many faces have corners.
    pub(crate) fn proper_count(&self) -> usize {
        self.out_of_step.as_ref().map_or(self.face_count, |found| found.face_of_three.len())
    }

    /// The face that a corner is of.
    #[inline]
    pub(crate) fn corner_face(&self, corner: CornerId) -> FaceId {
        match &self.out_of_step {
            None => FaceId(corner.0 / 3),
            Some(found) => found.face_of_three[corner.index() / 3],
        }
    }

    /// The first corner of a face; [`NO_CORNER`] for a degenerate one.
    #[inline]
    pub(crate) fn first_corner(&self, face: FaceId) -> CornerId {
        match &self.out_of_step {
            None => CornerId(3 * face.0),
            Some(found) => found.first_corner[face],
        }
    }

    /// The corners of a face.
    #[inline]
    pub(crate) fn face_corners(&self, face: FaceId) -> impl Iterator<Item = CornerId> + Clone + use<> {
        let first = self.first_corner(face);
        let count = if first == NO_CORNER { 0 } else { 3 };
        (0..count).map(move |place| CornerId(first.0 + place))
    }

    /// Bytes on the heap.
    pub(crate) fn heap_bytes(&self) -> usize {
        self.arrays().iter().map(Array::bytes).sum()
    }

    /// The arrays that degenerate faces make necessary.
    pub(crate) fn arrays(&self) -> Vec<Array> {
        self.out_of_step.iter().flat_map(OutOfStep::arrays).collect()
    }
}

impl OutOfStep {
    fn arrays(&self) -> [Array; 2] {
        [
            Array::new(
                "face of three corners",
                Per::Face,
                size_of::<FaceId>(),
                self.face_of_three.capacity(),
            ),
            Array::of_column("first corner", Per::Face, &self.first_corner),
        ]
    }
}

/// The corner after another in its triangle.
#[inline]
pub(crate) fn next(corner: CornerId) -> CornerId {
    CornerId(if corner.0 % 3 == 2 { corner.0 - 2 } else { corner.0 + 1 })
}

/// The corner before another in its triangle.
#[inline]
pub(crate) fn prev(corner: CornerId) -> CornerId {
    CornerId(if corner.0.is_multiple_of(3) { corner.0 + 2 } else { corner.0 - 1 })
}

#[cfg(test)]
mod tests {
    use meshmend_core::{FaceTableBuilder, VertexId};

    use super::*;

    #[test]
    fn faces_without_corners_are_passed_over() {
        let mut builder = FaceTableBuilder::default();
        let faces: [&[u32]; 5] = [&[], &[0, 1, 2], &[], &[2, 1, 3], &[]];
        faces.iter().for_each(|face| builder.push_face(face.iter().copied().map(VertexId)));
        let triangles = Triangles::of(&builder.build(4).unwrap());
        let of_corners: Vec<u32> = (0..6).map(|corner| triangles.corner_face(CornerId(corner)).0).collect();
        assert_eq!(of_corners, [1, 1, 1, 3, 3, 3]);
        let corners = |face| triangles.face_corners(FaceId(face)).map(|corner| corner.0).collect::<Vec<_>>();
        assert_eq!(
            [corners(0), corners(1), corners(3), corners(4)],
            [vec![], vec![0, 1, 2], vec![3, 4, 5], vec![]]
        );
        assert_eq!(triangles.face_count(), 5);
        assert_eq!(triangles.heap_bytes(), 4 * 2 + 4 * 5);
    }

    #[test]
    fn triangles_alone_need_no_array() {
        let corners = [0, 1, 2, 2, 1, 3].map(VertexId).to_vec();
        let triangles = Triangles::of(&FaceTable::triangles(4, corners).unwrap());
        assert!(triangles.face_corners(FaceId(1)).eq([3, 4, 5].map(CornerId)));
        assert_eq!((triangles.corner_face(CornerId(5)), triangles.heap_bytes()), (FaceId(1), 0));
        assert_eq!([3, 4, 5].map(|c| next(CornerId(c)).0), [4, 5, 3]);
        assert_eq!([3, 4, 5].map(|c| prev(CornerId(c)).0), [5, 3, 4]);
    }
}
